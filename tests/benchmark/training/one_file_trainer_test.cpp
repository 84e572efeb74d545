// SPDX-License-Identifier: MIT
// A learned agent added the way docs/extending.md says: its network, the trainer of it and the
// agent, in one file, nothing else touched. Up to the line of slashes this is what would stand in
// such files.
#include "agent/models/model_registry.h"
#include "agent/models/model_slot.h"
#include "agent/models/safetensors.h"
#include "agent/perception/torch.h"
#include "agent/registry.h"
#include "benchmark/training/core/learner.h"
#include "benchmark/training/core/trainer_registry.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

/// The network: how likely it is that one should turn, from how far the middle pixel is.
struct TurnNet final : torch::nn::Module {
  TurnNet() {
    weight = register_parameter("weight", torch::zeros({1}));
    bias = register_parameter("bias", torch::zeros({1}));
  }
  torch::Tensor forward(const torch::Tensor& depth) { return depth * weight + bias; }

  torch::Tensor weight;
  torch::Tensor bias;
};

/// What agents see of it; here two numbers are enough, without torch.
class TurnModel final : public virtual Model {
 public:
  static constexpr std::string_view kWhat = "turn model";
  explicit TurnModel(const TensorFile& file)
      : weight_(file.tensors.at("weight").values.at(0)),
        bias_(file.tensors.at("bias").values.at(0)) {}
  bool ShouldTurn(float depth) const { return depth * weight_ + bias_ > 0.0f; }

 private:
  float weight_;
  float bias_;
};

const ModelRegistration model_registration("turn_net", [](const std::filesystem::path& weights,
                                                          const Rig& /*rig*/) {
  return std::make_shared<TurnModel>(ReadTensorFile(weights));
});

/// Goes on while the way is free, else turns.
class TurnerAgent final : public Agent {
 public:
  static constexpr std::string_view kName = "turner";
  struct Config {
    template <class V>
    void Visit(V& /*v*/) {}
  };
  static std::vector<ModelSlot> ModelSlots(const Rig& /*rig*/) {
    return {NeededSlot<TurnModel>("policy", "turner")};
  }

  TurnerAgent(const Config& /*config*/, const AgentContext& context)
      : policy_(context.models.Need<TurnModel>("policy")) {}

  void Reset(const Panorama& /*goal*/, std::uint64_t /*seed*/) override {}
  sim::Action Act(const Observation& observation) override {
    const bool turns = policy_->ShouldTurn(observation.panorama.depth.front());
    return turns ? sim::Action::kTurnLeft : sim::Action::kMoveForward;
  }

 private:
  std::shared_ptr<TurnModel> policy_;
};

const AgentRegistration<TurnerAgent> agent_registration;

}  // namespace
}  // namespace bulletnav::agent

namespace bulletnav::bench {
namespace {

struct TurnConfig : TrainPlan {
  double wall = 1.0;  // metres; nearer than this, one should turn

  template <class V>
  void Visit(V& v) {
    v("task", task);
    v.Required("out", out);
    v("optimiser", optimiser);
    v("steps", steps);
    v("lanes", lanes);
    v("validate_every", validate_every);
    v("seed", seed);
    v("wall", wall);
  }
};

class TurnLearner final : public Learner {
 public:
  explicit TurnLearner(const TurnConfig& config) : config_(config) {}

  torch::nn::Module& net() override { return net_; }
  torch::Tensor Loss(const LaneWork& work) override {
    torch::Tensor loss = torch::zeros({});
    for (int i = 0; i < work.count; ++i) {
      loss = loss + LossOf(work.first + static_cast<std::uint64_t>(i));
    }
    return loss / work.count;
  }
  Measures Validate(sim::WorkerPool* /*pool*/) override {
    const torch::NoGradGuard no_grad;
    Measures measures;
    measures("loss", LossOf(1'000'000).item<double>());
    return measures;
  }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    agent::TensorFile content;
    content.tensors["weight"] = {{1}, {net_.weight.item<float>()}};
    content.tensors["bias"] = {{1}, {net_.bias.item<float>()}};
    content.metadata = std::move(notes);
    content.metadata["turn_net"] = "{}";
    agent::WriteTensorFile(file, content);
  }

 private:
  torch::Tensor LossOf(std::uint64_t batch) {
    sim::Rng rng = sim::Rng(config_.seed, "depths").Fork("batch", batch);
    std::vector<float> depths;
    std::vector<float> turns;
    for (int i = 0; i < 32; ++i) {
      depths.push_back(static_cast<float>(rng.Uniform(0.0, 2.0 * config_.wall)));
      turns.push_back(depths.back() < config_.wall ? 1.0f : 0.0f);
    }
    return torch::binary_cross_entropy_with_logits(net_.forward(torch::tensor(depths)),
                                                   torch::tensor(turns));
  }

  TurnConfig config_;
  agent::TurnNet net_;
};

struct TurnTrainer {
  static constexpr std::string_view kName = "turner";
  using Config = TurnConfig;
  static TrainTask Prepare(const Config& config, const TrainerContext& /*context*/) {
    TrainTask task = TrainTask::Of(config);
    task.name = kName;
    task.title = "When to turn";
    task.batches = 2;
    task.frames = 64;
    task.make = [config] {
      return std::make_unique<TurnLearner>(config);
    };
    task.describe = [](const Measures& measures) {
      return "loss " + std::to_string(measures.at("loss"));
    };
    task.curves_label = "loss, validation";
    task.curves = {{"loss", "loss"}};
    return task;
  }
};

const TrainerRegistration<TurnTrainer> trainer_registration;

}  // namespace
}  // namespace bulletnav::bench

////////////////////////////////////////////////////////////////////////////////////////////////////

#include <algorithm>
#include <array>

#include <gmock/gmock.h>

#include "benchmark/training/core/trainer.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class OneFileTrainer : public testing::Test {
 protected:
  fs::path Config(const std::string& name, const std::string& more = "") const {
    const fs::path file = folder_.path() / (name + ".yaml");
    sim::WriteFileAtomically(file, "task: turner\nout: " + (folder_.path() / name).string() +
                                       "\nsteps: 300\nvalidate_every: 50\n"
                                       "optimiser: {learning_rate: 0.1, warmup_steps: 5}\n" +
                                       more);
    return file;
  }
  fs::path Weights(const std::string& name) const {
    return folder_.path() / name / "weights.safetensors";
  }
  std::string Complaint(const fs::path& file) const {
    try {
      RunTrainer(file, {});
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "none";
  }

  tests::TemporaryFolder folder_;
};

TEST_F(OneFileTrainer, TeachesAnAgentThatRunsCanPlay) {
  const fs::path out = RunTrainer(Config("a"), {});
  for (const char* file : {"weights.md", "curves.csv", "curves.png", "weights_best.safetensors"}) {
    EXPECT_TRUE(fs::exists(out / file)) << file;
  }
  EXPECT_EQ(agent::FramesTrained(Weights("a")), 300 * 64);
  EXPECT_EQ(agent::ReadTensorFile(Weights("a")).metadata.at("task"), "turner");

  std::array contexts = {agent::AgentContext{}};
  const auto slots = agent::ModelSlotsOf("turner", contexts[0].rig);
  ASSERT_EQ(slots.size(), 1u);
  const auto model = agent::LoadModel(Weights("a"), contexts[0].rig);
  ASSERT_TRUE(slots[0].accepts(*model));
  contexts[0].models.Set(slots[0].name, model);
  const auto turner = agent::ConfigureAgent("turner")(contexts);
  const auto act = [&](float depth) {
    std::array actions = {sim::Action::kStop};
    const std::array seen = {agent::LaneObservation{0, {{{}, std::span(&depth, 1)}, {}, false, 0}}};
    turner->Act(seen, actions);
    return actions[0];
  };
  EXPECT_EQ(act(0.5f), sim::Action::kTurnLeft);
  EXPECT_EQ(act(1.5f), sim::Action::kMoveForward);
}

/// Ends a training as a kill would.
struct Killed {};
class Killer final : public TrainObserver {
 public:
  explicit Killer(int at) : at_(at) {}
  void Resumed(int step) override { resumed_ = step; }
  void Stepped(int step, double /*loss*/) override {
    if (step == at_) throw Killed();
  }
  void Validated(int /*step*/, const Measures& /*measures*/, const std::string& /*text*/) override {
  }
  int resumed() const { return resumed_; }

 private:
  int at_;
  int resumed_ = 0;
};

TEST_F(OneFileTrainer, GoesOnAfterAKillToTheSameBits) {
  RunTrainer(Config("whole"), {});
  const auto task = TurnTrainer::Prepare(sim::LoadYaml<TurnConfig>(Config("killed")), {});
  Killer killer(170);
  EXPECT_THROW(RunTraining(task, &killer), Killed);
  Killer witness(0);
  RunTraining(task, &witness);
  EXPECT_EQ(witness.resumed(), 150);
  EXPECT_EQ(agent::ReadTensorFile(Weights("killed")).tensors,
            agent::ReadTensorFile(Weights("whole")).tensors);
}

TEST_F(OneFileTrainer, IsKnownByItsName) {
  EXPECT_THAT(TrainerNames(), testing::IsSupersetOf({"mapper", "nts", "turner"}));
  EXPECT_THROW(const TrainerRegistration<TurnTrainer> again, sim::Error);
  const fs::path bad = folder_.path() / "bad.yaml";
  sim::WriteFileAtomically(bad, "out: x\ntask: turnip\n");
  EXPECT_THAT(Complaint(bad), AllOf(HasSubstr("bad.yaml:2:7: nothing trains 'turnip'"),
                                    HasSubstr("mapper, nts, turner")));
  EXPECT_THAT(Complaint(Config("typo", "wal: 2\n")), HasSubstr("did you mean 'wall'?"));
}

}  // namespace
}  // namespace bulletnav::bench
