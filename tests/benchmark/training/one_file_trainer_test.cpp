// SPDX-License-Identifier: MIT
// A learned agent added the way docs/extending.md says: its network, how it is trained, the model
// that agents load and the agent, in one file, nothing else touched. Up to the line of slashes this
// is what would stand in the files of such an agent.
#include <bit>
#include <cmath>
#include <memory>

#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "agent/perception/torch.h"
#include "agent/perception/weights.h"
#include "agent/registry.h"
#include "benchmark/training/core/registry.h"
#include "sim/math/rng.h"

namespace bulletnav {
namespace {

constexpr const char* kLineKey = "line_net";  // of weights' metadata

/// y = weight x + bias.
class LineNet final : public torch::nn::Module {
 public:
  LineNet() {
    weight_ = register_parameter("weight", torch::zeros({1}));
    bias_ = register_parameter("bias", torch::zeros({1}));
  }
  torch::Tensor forward(const torch::Tensor& x) { return x * weight_ + bias_; }

 private:
  torch::Tensor weight_;
  torch::Tensor bias_;
};

/// Learns a line with noise from points; where they are drawn goes on from step to step.
class LineTraining final : public bench::Training {
 public:
  static constexpr std::string_view kName = "line";

  struct Config : bench::TrainPlan {
    double slope = 3.0;
    bool torch_adam = false;
    template <class V>
    void Visit(V& v) {
      TrainPlan::Visit(v);
      v("slope", slope);
      v("torch_adam", torch_adam);
    }
  };

  LineTraining(const Config& config, const bench::TrainContext& /*context*/) : config_(config) {}

  torch::nn::Module& net() override { return net_; }

  std::unique_ptr<bench::Optimiser> MakeOptimiser() override {
    return config_.torch_adam ? bench::MakeTorchAdam(net_, config_.optimiser) : nullptr;
  }

  double Learn(const bench::TrainStep& step) override {
    sim::Rng rng =
        sim::Rng(config_.seed, "line").Fork("step", static_cast<std::uint64_t>(step.step));
    centre_ = 0.9 * centre_ + rng.Uniform(-0.5, 0.5);
    const torch::Tensor x = torch::full({1}, centre_ + rng.Uniform(-1.0, 1.0));
    const torch::Tensor loss = Loss(x);
    loss.backward();
    step.optimiser->Step(step.rate);
    return loss.item<double>();
  }

  bench::Measures Validate() override {
    const torch::NoGradGuard no_grad;
    bench::Measures measures;
    measures("loss", Loss(torch::full({1}, 2.0)).item<double>());
    return measures;
  }

  std::int64_t FramesAfter(int steps) const override { return steps; }

  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    notes[kLineKey] = "a line";
    agent::SaveWeights(net_, std::move(notes), agent::StoredType::kFloat32, file);
  }

  void AppendState(agent::TensorFile* content) const override {
    content->metadata["centre"] = std::to_string(std::bit_cast<std::uint64_t>(centre_));
  }
  void SetState(const agent::TensorFile& content, const std::filesystem::path& /*file*/) override {
    centre_ = std::bit_cast<double>(std::uint64_t{std::stoull(content.metadata.at("centre"))});
  }

  std::string title() const override { return "A line"; }
  std::string Describe(const bench::Measures& measures) const override {
    return "loss " + std::to_string(measures.at("loss"));
  }

 private:
  torch::Tensor Loss(const torch::Tensor& x) {
    return (net_.forward(x) - (config_.slope * x + 1.0)).square().mean();
  }

  Config config_;
  LineNet net_;
  double centre_ = 0.0;
};

const bench::TrainerRegistration<LineTraining> training;

/// What agents ask.
class LineModel final : public agent::Model {
 public:
  static constexpr std::string_view kWhat = "line";

  explicit LineModel(const std::filesystem::path& weights) {
    agent::SetWeights(agent::ReadTensorFile(weights), "", weights, &net_);
  }
  double At(double x) {
    const torch::NoGradGuard no_grad;
    return net_.forward(torch::full({1}, x)).item<double>();
  }

 private:
  LineNet net_;
};

const agent::ModelRegistration model(kLineKey, [](const std::filesystem::path& weights,
                                                  const agent::Rig& /*rig*/) {
  return std::make_shared<LineModel>(weights);
});

/// Turns as often as the line says at 2, then stops.
class LineAgent final : public agent::Agent {
 public:
  static constexpr std::string_view kName = "line_follower";
  struct Config {
    template <class V>
    void Visit(V& /*v*/) {}
  };

  static std::vector<agent::ModelSlot> ModelSlots(const agent::Rig& /*rig*/) {
    return {agent::NeededSlot<LineModel>("line", "line")};
  }

  LineAgent(const Config& /*config*/, const agent::AgentContext& context)
      : line_(context.models.Need<LineModel>("line")) {}

  void Reset(const agent::Panorama& /*goal*/, std::uint64_t /*seed*/) override {
    left_ = static_cast<int>(std::lround(line_->At(2.0)));
  }
  sim::Action Act(const agent::Observation& /*observation*/) override {
    return left_-- > 0 ? sim::Action::kTurnLeft : sim::Action::kStop;
  }

 private:
  std::shared_ptr<LineModel> line_;
  int left_ = 0;
};

const agent::AgentRegistration<LineAgent> registration;

}  // namespace
}  // namespace bulletnav

////////////////////////////////////////////////////////////////////////////////////////////////////

#include <array>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using tests::Killed;
using tests::Watcher;

class OneFileTrainer : public testing::TestWithParam<bool> {
 protected:
  TrainJob Job(const std::string& name, const std::string& more = "") const {
    const std::string text = "task: line\nout: " + (folder_.path() / name).string() +
                             "\nsteps: 400\nvalidate_every: 50\n"
                             "optimiser: {learning_rate: 0.1, warmup_steps: 10}\ntorch_adam: " +
                             (GetParam() ? "true" : "false") + "\n" + more;
    return MakeTraining(sim::ParseYaml(text, "line.yaml"), "nts", {});
  }
  fs::path Weights(const std::string& name) const {
    return folder_.path() / name / "weights.safetensors";
  }
  tests::TemporaryFolder folder_;
};

TEST_P(OneFileTrainer, ResumedIsTheSameAsUninterruptedBitForBit) {
  Watcher whole;
  RunTraining(Job("whole"), &whole);
  Watcher killed(230);
  EXPECT_THROW(RunTraining(Job("parts"), &killed), Killed);
  EXPECT_FALSE(fs::exists(Weights("parts")));
  Watcher rest;
  RunTraining(Job("parts"), &rest);
  EXPECT_EQ(rest.resumed(), 200);
  EXPECT_EQ(agent::ReadTensorFile(Weights("whole")).tensors,
            agent::ReadTensorFile(Weights("parts")).tensors);
}

TEST_P(OneFileTrainer, AnAgentActsByWhatWasTrained) {
  Watcher watcher;
  RunTraining(Job("out"), &watcher);
  const auto notes = agent::ReadTensorFile(Weights("out")).metadata;
  EXPECT_EQ(notes.at("task"), "line");
  EXPECT_EQ(notes.at("step"), "400");
  EXPECT_THAT(notes.at("training"), HasSubstr("slope: 3\n"));
  EXPECT_EQ(agent::FramesTrained(Weights("out")), 400);

  std::array contexts = {agent::AgentContext{}};
  EXPECT_THROW(agent::ConfigureAgent("line_follower")(contexts), sim::Error);
  contexts[0].models.Set("line", agent::LoadModel(Weights("out"), {}));
  const auto agent = agent::ConfigureAgent("line_follower")(contexts);
  agent->Reset(0, {}, 1);
  std::array actions = {sim::Action::kTurnLeft};
  int steps = 0;
  while (actions[0] != sim::Action::kStop && steps < 100) {
    const std::array seen = {agent::LaneObservation{0, {{}, {}, false, steps++}}};
    agent->Act(seen, actions);
  }
  EXPECT_EQ(steps, 8);  // 3 * 2 + 1 turns and the stop
}

INSTANTIATE_TEST_SUITE_P(Optimisers, OneFileTrainer, testing::Bool());

TEST_P(OneFileTrainer, ADeviceThatIsMissingIsNamedAtItsPlace) {
  if (at::hasCUDA()) GTEST_SKIP() << "torch has cuda here";
  try {
    Job("out", "device: cuda\n");
    FAIL();
  } catch (const sim::FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("line.yaml:7:9: device is cuda, but torch finds none here"));
  }
}

TEST(OneFileTrainers, ASecondOneOfTheSameNameIsRefused) {
  EXPECT_THROW(const TrainerRegistration<LineTraining> again, sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
