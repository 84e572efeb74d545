// SPDX-License-Identifier: MIT
// configs/habitat plays sets in Habitat's form by Habitat's rules: here a tiny one.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "agent/registry.h"
#include "benchmark/runs/run_agents.h"
#include "benchmark/runs/runner.h"
#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/// Sees flat pictures and a flat goal, and walks on until the goal looks like what is before it.
class FlatPictures final : public agent::Agent {
 public:
  static constexpr std::string_view kName = "test_flat_pictures";
  struct Config {
    template <class V>
    void Visit(V& /*v*/) {}
  };

  FlatPictures(const Config& /*config*/, const agent::AgentContext& context) {
    const sim::ArraySpec* goal = context.rig.FindArray(kGoalPicture);
    const sim::ArraySpec* seen = context.rig.FindArray("front.color");
    if (goal == nullptr || seen == nullptr || goal->shape != seen->shape) {
      throw sim::Error("flat pictures are needed");
    }
    EXPECT_EQ(goal->shape, (std::vector<int>{256, 256, 3}));
    EXPECT_FALSE(context.rig.has_color);
  }

  void Reset(const agent::Panorama& goal, std::uint64_t /*seed*/) override {
    goal_.assign(goal.color.begin(), goal.color.end());
    EXPECT_EQ(goal_.size(), std::size_t{3 * 256 * 256});
    EXPECT_TRUE(goal.depth.empty());
  }

  sim::Action Act(const agent::Observation& observation) override {
    const auto seen = observation.array("front.color").values<std::uint8_t>();
    std::int64_t difference = 0;
    for (std::size_t i = 0; i < goal_.size(); ++i) difference += std::abs(goal_[i] - seen[i]);
    const double mean = static_cast<double>(difference) / static_cast<double>(goal_.size());
    return mean < 0.5 ? sim::Action::kStop : sim::Action::kMoveForward;
  }

 private:
  std::vector<std::uint8_t> goal_;
};

const agent::AgentRegistration<FlatPictures> registration;

/// Episodes as habitat-lab writes them: the first's goal is straight ahead and looked at in the
/// heading of the start, the last starts inside a wall.
constexpr const char* kSet = R"({"episodes": [
  {"episode_id": "0", "scene_id": "data/scene_datasets/gibson/Room.basis.glb",
   "start_position": [2, 0, -1], "start_rotation": [0, 0, 0, 1],
   "info": {"geodesic_distance": 4.0, "goal_rotation": [0, 0, 0, 1]},
   "goals": [{"position": [2, 0, -5], "radius": null}], "start_room": null},
  {"episode_id": "1", "scene_id": "data/scene_datasets/gibson/Room.basis.glb",
   "start_position": [1, 0, -1], "start_rotation": [0, 1, 0, 0],
   "info": {"geodesic_distance": 6.7},
   "goals": [{"position": [4, 0, -7], "radius": null}], "start_room": null},
  {"episode_id": "2", "scene_id": "data/scene_datasets/gibson/Room.basis.glb",
   "start_position": [0, 0, -1], "start_rotation": [0, 0, 0, 1],
   "info": {"geodesic_distance": 4.0},
   "goals": [{"position": [2, 0, -5], "radius": null}], "start_room": null}]})";

class HabitatConfigTest : public testing::TestWithParam<const char*> {
 protected:
  HabitatConfigTest() {
    sim::SceneMesh room = tests::BoxRoom(6, 2.6f, 8);
    for (Eigen::Vector3f& p : room.positions) p = {p.x(), -p.z(), p.y()};  // z up, as scans lie
    sim::WriteFileAtomically(folder_.path() / "scenes" / "gibson" / "Room.glb",
                             sim::EncodeGlb(room));
    const fs::path set = folder_.Write("val.json", kSet);
    overrides_ = {"episodes.file=" + set.string(),
                  "episodes.scene_folders=[" + (folder_.path() / "scenes").string() + "]"};
  }
  RunConfig Config() const {
    return LoadRunConfig(fs::path(BULLETNAV_CONFIGS) / "habitat" / GetParam(), overrides_);
  }

  tests::TemporaryFolder folder_;
  std::vector<std::string> overrides_;
};

TEST_P(HabitatConfigTest, PlaysItsRules) {
  const RunConfig config = Config();
  const Task task = TaskOf(config, "habitat", Condition::kNoNoise, true);
  EXPECT_EQ(task.goal_camera->hfov_deg, 90.0);
  EXPECT_EQ(task.noise, sim::NoiseMode::kNone);
  EXPECT_EQ(task.max_steps, 1000);
  EXPECT_FALSE(task.color);
  RunHooks hooks;
  std::vector<std::string> warnings;
  hooks.warn = [&](const std::string& line) {
    warnings.push_back(line);
  };
  const RunOutcome outcome =
      RunBenchmark(config, folder_.path() / "results", {.episodes = {}, .workers = 2}, hooks);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("1 of 3 episodes are left out (skip_unplayable)")));
  ASSERT_EQ(outcome.results.size(), 4u);  // two agents
  for (const EpisodeResult& result : outcome.results) {
    EXPECT_EQ(result.failure, "");
    if (result.key.agent == "shortest_path") {
      EXPECT_TRUE(result.goals.front().success());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, HabitatConfigTest,
                         testing::Values("gibson.yaml", "hm3d.yaml", "mp3d.yaml"));

class FlatGoalTest : public HabitatConfigTest {};

TEST_P(FlatGoalTest, AgentsOfFlatPicturesSeeTheGoalAsTheySeeTheWay) {
  overrides_.emplace_back("agents=[{agent: test_flat_pictures}, {agent: metric_map_fbe}]");
  RunConfig config = Config();
  const RunOutcome outcome =
      RunBenchmark(std::move(config), folder_.path() / "results", {.episodes = 1, .workers = 1});
  ASSERT_EQ(outcome.results.size(), 1u);  // who needs panoramas does not play
  EXPECT_EQ(outcome.results.front().failure, "");
  EXPECT_TRUE(outcome.results.front().goals.front().success());
  EXPECT_LT(outcome.results.front().goals.front().Find("distance_to_goal"), 0.2);
}

INSTANTIATE_TEST_SUITE_P(All, FlatGoalTest, testing::Values("gibson.yaml"));

TEST(FlatGoals, GoWithoutPanoramas) {
  const auto error_of = [](const std::string& text) {
    try {
      ParseRunConfig(text, "run.yaml");
    } catch (const sim::Error& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  const std::string rest = "episodes: {file: a}\nagents: [{agent: random}]\n";
  EXPECT_THAT(error_of("goal: {hfov_deg: 90}\n" + rest), HasSubstr("shows panoramas, but goals"));
  EXPECT_THAT(error_of("goal: {}\nsensors: {a: {panorama: panorama}}\nsettings: [a]\n" + rest),
              HasSubstr("has a panorama, but goals are flat"));
  EXPECT_THAT(error_of("sensors: {a: {front: pinhole}}\nsettings: [a]\n" + rest),
              HasSubstr("unless 'goal' gives another camera"));
}

}  // namespace
}  // namespace bulletnav::bench
