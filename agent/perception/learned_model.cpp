// SPDX-License-Identifier: MIT
#include "agent/perception/learned_model.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "agent/models/model_registry.h"
#include "agent/perception/model_file.h"
#include "agent/perception/one_thread.h"
#include "agent/perception/semantic_net.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// The four parts of a panorama that pairs are compared by, and what they hold together.
struct PixelLayout {
  std::int64_t sum;
  std::int64_t match;
  std::size_t size() const {
    return static_cast<std::size_t>(kDirections * (1 + 2 * sum + 2 * match));
  }
};

void Append(const torch::Tensor& part, PanoramaCode* code) {
  const torch::Tensor flat = part.contiguous();
  code->insert(code->end(), flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel());
}

std::array<float, kDirections> ToArray(const torch::Tensor& row) {
  const torch::Tensor flat = row.contiguous();
  BULLETNAV_CHECK_EQ(flat.numel(), kDirections);
  std::array<float, kDirections> values{};
  std::copy_n(flat.data_ptr<float>(), kDirections, values.begin());
  return values;
}

}  // namespace

class LearnedModel::Impl {
 public:
  Impl(const std::filesystem::path& weights, const Rig& rig) : net_(LoadNet(weights)) {
    RequireRig(rig, net_->config(), weights);
    net_->eval();
    net_->Fold();
  }

  const ModelConfig& config() const { return net_->config(); }

  PanoramaCode Encode(const Panorama& panorama) {
    const c10::InferenceMode inference;
    StayInThisThread();
    const PanoramaParts parts = net_->Describe(PrepareInput(config(), panorama));
    PanoramaCode code;
    code.reserve(layout().size());
    Append(parts.explorable.sigmoid(), &code);
    Append(parts.source_sum, &code);
    Append(parts.goal_sum, &code);
    Append(parts.source_match, &code);
    Append(parts.goal_match, &code);
    return code;
  }

  PairPrediction Compare(const PanoramaCode& source, const PanoramaCode& goal) {
    const c10::InferenceMode inference;
    StayInThisThread();
    const PairOutputs outputs = net_->Compare(Parts(source), Parts(goal));
    PairPrediction prediction;
    prediction.same_node = outputs.same_node.sigmoid().item<float>();
    prediction.direction = ToArray(outputs.direction.softmax(1));
    prediction.distance =
        static_cast<float>(kNodeRadius) * (1.0f - outputs.distance_score.item<float>());
    prediction.score = ToArray(outputs.scores);
    return prediction;
  }

  PixelLayout layout() const {
    return {config().pair_features, std::int64_t{Heads::kMatches} * Heads::kMatchSize};
  }

 private:
  PanoramaParts Parts(const PanoramaCode& code) const {
    BULLETNAV_CHECK_EQ(code.size(), layout().size());
    std::int64_t at = kDirections;
    const auto next = [&](std::int64_t features) {
      const std::int64_t begin = std::exchange(at, at + kDirections * features);
      return torch::from_blob(const_cast<float*>(code.data()) + begin, {1, kDirections, features},
                              torch::kFloat32);
    };
    PanoramaParts parts;
    parts.source_sum = next(layout().sum);
    parts.goal_sum = next(layout().sum);
    parts.source_match = next(layout().match);
    parts.goal_match = next(layout().match);
    return parts;
  }

  std::shared_ptr<SemanticNet> net_;
};

LearnedModel::LearnedModel(const std::filesystem::path& weights, const Rig& rig)
    : impl_(std::make_unique<Impl>(weights, rig)) {}

LearnedModel::~LearnedModel() = default;

const ModelConfig& LearnedModel::config() const {
  return impl_->config();
}

std::vector<PanoramaCode> LearnedModel::Encode(std::span<const Panorama> panoramas) {
  std::vector<PanoramaCode> codes;
  for (const Panorama& panorama : panoramas) codes.push_back(impl_->Encode(panorama));
  return codes;
}

std::array<float, kDirections> LearnedModel::Explorable(const PanoramaCode& source) {
  BULLETNAV_CHECK_EQ(source.size(), impl_->layout().size());
  std::array<float, kDirections> probabilities{};
  std::copy_n(source.begin(), kDirections, probabilities.begin());
  return probabilities;
}

std::vector<PairPrediction> LearnedModel::Compare(std::span<const PanoramaCode* const> sources,
                                                  const PanoramaCode& goal) {
  std::vector<PairPrediction> predictions;
  for (const PanoramaCode* source : sources) predictions.push_back(impl_->Compare(*source, goal));
  return predictions;
}

namespace {

const ModelRegistration registration(kModelKey,
                                     [](const std::filesystem::path& weights, const Rig& rig) {
                                       return std::make_shared<LearnedModel>(weights, rig);
                                     });

}  // namespace

}  // namespace bulletnav::agent
