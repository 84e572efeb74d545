// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_training.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <thread>

#include <fmt/core.h>

#include "agent/integer/quantised_file.h"
#include "agent/perception/one_thread.h"
#include "agent/slam/descriptors/descriptor_net.h"
#include "agent/slam/descriptors/picture_describer.h"
#include "benchmark/base/program_version.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/slam/training/place_loss.h"
#include "benchmark/slam/training/place_measures.h"
#include "benchmark/slam/training/place_views_file.h"
#include "benchmark/training/core/net_parts.h"
#include "sim/base/error.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kValidationSeed = 1'000'003;  // added to the config's
constexpr int kValidationBatches = 8;                 // that the loss is of
constexpr int kCalibrationPictures = 400;
constexpr int kAtATime = 64;  // pictures

std::vector<PlaceViews> LoadViews(const PlaceDataConfig& data, const TrainContext& context) {
  MakeHousesOf(data, CommittedVersion(), 0, context.start);
  const auto scenes = static_cast<int>(ScenesOf(data).size());
  return AllPlaceViews(data, context.start("drawing places", scenes));
}

const PlaceDataConfig& TrainData(const PlaceTrainConfig& config) {
  if (config.data) return *config.data;
  throw sim::KeyError("data", "there is no block 'data'; see configs/train/place.yaml");
}

PlaceBatchSpec SpecOf(const PlaceTrainConfig& config, int scenes, std::uint64_t seed) {
  PlaceBatchSpec spec;
  spec.scenes = std::min(scenes, config.scenes);
  spec.places = config.places / config.scenes * spec.scenes;
  spec.rows = config.model.rows;
  spec.seed = config.seed + seed;
  return spec;
}

PlaceBatchSpec TrainSpecOf(const PlaceTrainConfig& config) {
  PlaceBatchSpec spec = SpecOf(config, config.scenes, 0);
  spec.augment = config.augment;
  return spec;
}

std::vector<PlaceViews> FirstOf(std::vector<PlaceViews> scenes, int count) {
  if (static_cast<int>(scenes.size()) > count) scenes.resize(static_cast<std::size_t>(count));
  return scenes;
}

std::unique_ptr<agent::DescriptorNet> MakeNet(const PlaceTrainConfig& config) {
  auto net = std::make_unique<agent::DescriptorNet>(config.model, config.seed);
  if (!config.start_from.empty()) {
    net->StartFrom(ShippedOr(config.start_from));
  }
  return net;
}

torch::Tensor Covisibilities(const PlaceBatch& batch) {
  torch::Tensor values = torch::empty({batch.count, batch.count});
  std::copy(batch.covisibility.begin(), batch.covisibility.end(), values.data_ptr<float>());
  return values;
}

std::vector<float> CosinesOf(const torch::Tensor& descriptors) {
  const torch::Tensor cosines = at::matmul(descriptors, descriptors.t()).contiguous();
  return {cosines.data_ptr<float>(), cosines.data_ptr<float>() + cosines.numel()};
}

}  // namespace

struct PlaceTraining::Work {
  Work(const PlaceTrainConfig& config_in, std::vector<PlaceViews> train_in,
       std::vector<PlaceViews> validation_in)
      : config(config_in),
        train(std::move(train_in), TrainSpecOf(config_in)),
        validation(FirstOf(std::move(validation_in), config_in.validation_scenes),
                   SpecOf(config_in, config_in.validation_scenes, kValidationSeed)),
        pool(std::min(config_in.lanes, static_cast<int>(std::thread::hardware_concurrency()))),
        net(MakeNet(config_in)) {}

  torch::Device device() const { return net->parameters().front().device(); }

  using Describer = std::function<torch::Tensor(std::span<const std::uint8_t> pictures)>;

  torch::Tensor ByNet(std::span<const std::uint8_t> pictures, agent::DescriptorNet* with) const {
    return with->forward(agent::DescriptorInput(config.model, pictures).to(device())).cpu();
  }

  torch::Tensor LossOf(const PlaceBatches& batches, std::uint64_t number,
                       const Describer& describe) const {
    const PlaceBatch batch = batches.Batch(number);
    return SimilarityLoss(describe(batch.pictures), Covisibilities(batch), config.loss);
  }

  void MakeLanes() {
    for (int i = 0; i < config.lanes; ++i) {
      // Numbers are the net's.
      lanes.push_back(std::make_unique<agent::DescriptorNet>(config.model, config.seed));
      lanes.back()->to(device());
      ShareParameters(*net, *lanes.back());
      lanes.back()->train();
    }
  }

  /// Lets the lanes start from the net's running means.
  void SpreadBuffers() {
    const torch::NoGradGuard no_grad;
    const std::vector<torch::Tensor> from = net->buffers();
    for (const auto& lane : lanes) {
      const std::vector<torch::Tensor> to = lane->buffers();
      for (std::size_t k = 0; k < to.size(); ++k) to[k].copy_(from[k]);
    }
  }

  /// The net's gradients and running means become the means over the lanes.
  void Gather() {
    const torch::NoGradGuard no_grad;
    const double share = 1.0 / config.lanes;
    const std::vector<torch::Tensor> buffers = net->buffers();
    for (const torch::Tensor& buffer : buffers) buffer.zero_();
    for (const auto& lane : lanes) {
      const std::vector<torch::Tensor> means = lane->buffers();
      for (std::size_t k = 0; k < means.size(); ++k) buffers[k].add_(means[k], share);
      TakeGradients(*lane, share, *net);
    }
  }

  Measures MeasuresOf(const Describer& describe) {
    const auto& scenes = validation.scenes();
    std::vector<PlaceMeasures> all(scenes.size());
    std::vector<double> losses(kValidationBatches);
    pool.ForEach(static_cast<int>(scenes.size()) + kValidationBatches, [&](int task, int) {
      const torch::NoGradGuard no_grad;
      agent::StayInThisThread();
      if (task < kValidationBatches) {
        losses[static_cast<std::size_t>(task)] =
            LossOf(validation, static_cast<std::uint64_t>(task), describe).item<double>();
        return;
      }
      const auto at = static_cast<std::size_t>(task - kValidationBatches);
      all[at] = MeasurePlaces(scenes[at], CosinesOf(AllOf(scenes[at], describe)));
    });
    PlaceMeasures mean = MeanOf(all);
    mean.loss = std::accumulate(losses.begin(), losses.end(), 0.0) / kValidationBatches;
    return Measures::Of(mean);
  }

  /// Descriptors of all views of a scene.
  torch::Tensor AllOf(const PlaceViews& scene, const Describer& describe) const {
    std::vector<torch::Tensor> parts;
    for (int first = 0; first < scene.count(); first += kAtATime) {
      std::vector<std::uint8_t> pictures;
      for (int i = first; i < std::min(first + kAtATime, scene.count()); ++i) {
        const auto picture = PictureOf(scene, i, config.model.rows);
        pictures.insert(pictures.end(), picture.begin(), picture.end());
      }
      parts.push_back(describe(pictures));
    }
    return at::cat(parts);
  }

  std::size_t picture_bytes() const {
    return static_cast<std::size_t>(config.model.rows) *
           static_cast<std::size_t>(config.model.cols()) * 3;
  }

  torch::Tensor CalibrationInput() const {
    std::vector<std::uint8_t> pictures;
    for (std::uint64_t i = 0; pictures.size() < kCalibrationPictures * picture_bytes(); ++i) {
      const PlaceBatch batch = train.Batch(i);
      pictures.insert(pictures.end(), batch.pictures.begin(), batch.pictures.end());
    }
    return agent::DescriptorInput(config.model, pictures);
  }

  PlaceTrainConfig config;
  PlaceBatches train;
  PlaceBatches validation;
  sim::WorkerPool pool;
  std::unique_ptr<agent::DescriptorNet> net;
  std::vector<std::unique_ptr<agent::DescriptorNet>> lanes;  // from the first step on
};

PlaceTraining::PlaceTraining(const Config& config, const TrainContext& context)
    : PlaceTraining(config, LoadViews(TrainData(config), context),
                    LoadViews(ValidationData(config), context)) {}

PlaceTraining::PlaceTraining(const Config& config, std::vector<PlaceViews> train,
                             std::vector<PlaceViews> validation)
    : work_(std::make_unique<Work>(config, std::move(train), std::move(validation))) {}

PlaceTraining::~PlaceTraining() = default;

torch::nn::Module& PlaceTraining::net() {
  return *work_->net;
}

double PlaceTraining::Learn(const TrainStep& step) {
  Work& work = *work_;
  if (work.lanes.empty()) work.MakeLanes();
  work.SpreadBuffers();
  std::vector<double> losses(work.lanes.size());
  work.pool.ForEach(work.config.lanes, [&](int lane, int) {
    agent::StayInThisThread();
    const auto number =
        static_cast<std::uint64_t>(step.step) * static_cast<std::uint64_t>(work.config.lanes) +
        static_cast<std::uint64_t>(lane);
    const auto at = static_cast<std::size_t>(lane);
    const torch::Tensor loss = work.LossOf(work.train, number, [&](const auto& pictures) {
      return work.ByNet(pictures, work.lanes[at].get());
    });
    loss.backward();
    losses[at] = loss.item<double>();
  });
  work.Gather();
  const double loss = std::accumulate(losses.begin(), losses.end(), 0.0) / work.config.lanes;
  if (std::isfinite(loss)) step.optimiser->Step(step.rate);
  return loss;
}

Measures PlaceTraining::Validate() {
  return work_->MeasuresOf([this](const auto& pictures) {
    return work_->ByNet(pictures, work_->net.get());
  });
}

std::int64_t PlaceTraining::FramesAfter(int steps) const {
  return std::int64_t{steps} * work_->config.lanes * work_->config.places * work_->train.views();
}

void PlaceTraining::Save(std::map<std::string, std::string> notes,
                         const std::filesystem::path& file) const {
  agent::SaveDescriptor(*work_->net, std::move(notes), agent::StoredType::kBfloat16, file);
}

std::optional<Measures> PlaceTraining::Quantise(const std::filesystem::path& file) {
  const agent::QuantisedNet net =
      agent::Quantise(*agent::LoadDescriptor(file), work_->CalibrationInput());
  agent::AddQuantised(net, file, file);
  return work_->MeasuresOf([&](std::span<const std::uint8_t> pictures) {
    agent::PictureDescriber describer(net, work_->config.model);
    const std::size_t picture = work_->picture_bytes();
    const auto count = static_cast<std::int64_t>(pictures.size() / picture);
    torch::Tensor told = torch::empty({count, work_->config.model.size});
    float* at = told.data_ptr<float>();
    for (std::size_t first = 0; first < pictures.size(); first += picture) {
      for (const std::int16_t number : describer.DescribeShrunk(pictures.subspan(first, picture))) {
        *at++ = static_cast<float>(number) / agent::kDescriptorUnit;
      }
    }
    return told;
  });
}

std::string PlaceTraining::Describe(const Measures& m) const {
  return fmt::format(
      "loss {:.3f}; AP {:.3f} (guessing {:.3f}), turned by more than 90 degrees {:.3f}; recall@1 "
      "{:.3f}",
      m.at("loss"), m.at("ap"), m.at("guessing"), m.at("ap_turned"), m.at("recall_at_1"));
}

std::vector<CurveLine> PlaceTraining::curves() const {
  return {{"AP", "ap"},
          {"AP, turned by more than 90 degrees", "ap_turned"},
          {"recall@1", "recall_at_1"}};
}

std::vector<std::pair<std::string, std::string>> PlaceTraining::CardRows() const {
  const Work& work = *work_;
  return {
      {"data", fmt::format("{} scenes, up to {} places in each, {} views of each",
                           work.train.scenes().size(),
                           work.config.data ? work.config.data->places : 0, work.train.views())},
      {"a step",
       fmt::format("{} batches of {} places, {} views of each, from {} scenes", work.config.lanes,
                   work.config.places, work.train.views(), work.config.scenes)},
      {"begun from", work.config.start_from.empty() ? "random numbers" : work.config.start_from}};
}

std::string PlaceTraining::validated_on() const {
  return fmt::format("all pairs of views in {} validation scenes",
                     work_->validation.scenes().size());
}

namespace {

const TrainerRegistration<PlaceTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
