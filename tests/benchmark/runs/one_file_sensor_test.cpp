// SPDX-License-Identifier: MIT
// A sensor added the way docs/extending.md says: one file, nothing else touched. Up to the line of
// slashes this is what would stand in sim/sensors/types/compass.cpp.
#include "sim/sensors/sensor.h"

namespace bulletnav::sim {
namespace {

/// Where the body looks: the angle from -z, counter-clockwise seen from above, with an error that
/// is drawn anew in each step.
class Compass final : public Sensor {
 public:
  static constexpr std::string_view kName = "compass";  // as the file

  struct Config {
    double error_deg = 0.0;  // standard deviation
    template <class V>
    void Visit(V& v) {
      v("error_deg", error_deg);  // wrong YAML is reported at file:line:column
    }
    void Validate() const {
      if (!(error_deg >= 0.0)) throw KeyError("error_deg", "error_deg must not be negative");
    }
  };

  static std::vector<ArraySpec> Arrays(const Config& /*config*/) {
    return {{"heading", {1}, Element::kFloat32, "rad"}};
  }

  Compass(const Config& config, const SensorScene& /*scene*/) : config_(config) {}

  void Read(const SensorInput& input, std::span<const std::span<std::byte>> out) override {
    const double error = DegToRad(config_.error_deg) * input.noise().Normal();
    ValuesIn<float>(out[0])[0] = static_cast<float>(input.pose.yaw + error);
  }

 private:
  Config config_;
};

const SensorRegistration<Compass> registration;

}  // namespace
}  // namespace bulletnav::sim

////////////////////////////////////////////////////////////////////////////////////////////////////

#include <cmath>

#include <gmock/gmock.h>

#include "benchmark/play/environment.h"
#include "benchmark/runs/run_agents.h"
#include "sim/simulator.h"
#include "tests/support/scenes.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

constexpr const char* kRun = R"(
sensors:
  with_compass:
    panorama: {type: panorama, rows: 16, cols: 64}
    north: {type: compass, error_deg: 5}
    south: {type: compass, error_deg: 5}
settings: [rgbd, with_compass]
episodes: {file: none.jsonl}
agents: [{agent: random}]
)";

std::shared_ptr<const sim::World> Room() {
  return sim::World::FromMesh(tests::BoxRoom(8, 2.6f, 8), "room");
}

EpisodeTask Ahead(const std::string& id) {
  EpisodeTask task;
  task.key = {"random", "with_compass", "noise", 1, "room", id};
  task.episode.id = id;
  task.episode.scene = "room";
  task.episode.start_position = {1, 0, -1};
  EpisodeGoal& goal = task.episode.goals.emplace_back();
  goal.position = {1, 0, -5};
  goal.rotation = Rotation::FromYaw(0.0);
  return task;
}

/// What the compasses of one episode say in its first steps.
std::vector<float> Headings(const std::string& sensor, const std::string& episode, int threads) {
  const RunConfig config = ParseRunConfig(kRun, "run.yaml");
  std::vector<GroundTruth> truths(2);
  Environment environment(TaskOf(config, "with_compass", Condition::kNoise, /*sees=*/true),
                          {&truths[0], &truths[1]}, threads);
  const int lane = 1;
  environment.Reset(lane, Ahead(episode), Room());
  std::vector<float> headings;
  for (int step = 0; step < 6; ++step) {
    environment.Observe({&lane, 1});
    headings.push_back(environment.observation(lane).array(sensor + ".heading").values<float>()[0]);
    const sim::Action action = sim::Action::kTurnLeft;
    environment.Step({&lane, 1}, {&action, 1});
  }
  return headings;
}

TEST(OneFileSensor, IsASettingOfARunByYamlAlone) {
  const RunConfig config = ParseRunConfig(kRun, "run.yaml");
  const agent::Rig rig = RigOf(config, "with_compass");
  EXPECT_EQ(rig.panorama.cols, 64);
  EXPECT_TRUE(rig.has_depth);
  ASSERT_NE(rig.FindArray("north.heading"), nullptr);
  EXPECT_EQ(rig.FindArray("north.heading")->units, "rad");
  EXPECT_EQ(RigOf(config, "rgbd").FindArray("north.heading"), nullptr);
  EXPECT_EQ(FindAgents(config)[0].settings, (std::vector<std::string>{"rgbd", "with_compass"}));
}

TEST(OneFileSensor, SurvivesTheConfigThatIsSavedWithResults) {
  const std::string saved = sim::ToYaml(ParseRunConfig(kRun, "run.yaml"));
  EXPECT_THAT(saved, HasSubstr("error_deg: 5"));
  EXPECT_EQ(sim::ToYaml(ParseRunConfig(saved, "saved.yaml")), saved);
}

TEST(OneFileSensor, IsReadByAgentsInEveryStep) {
  const std::vector<float> headings = Headings("north", "e", 1);
  for (std::size_t step = 0; step < headings.size(); ++step) {
    EXPECT_NEAR(headings[step], sim::DegToRad(10.0 * static_cast<double>(step)), 0.5);
    EXPECT_NE(headings[step], 0.0f);
  }
}

TEST(OneFileSensor, ItsNoiseIsAFunctionOfEpisodeStepAndName) {
  EXPECT_EQ(Headings("north", "e", 1), Headings("north", "e", 2));
  EXPECT_NE(Headings("north", "e", 1), Headings("south", "e", 1));
  EXPECT_NE(Headings("north", "e", 1), Headings("north", "f", 1));
}

TEST(OneFileSensor, BadSettingsAreErrorsAtTheirPlace) {
  const auto complaint = [](const std::string& from, const std::string& to) -> std::string {
    std::string text = kRun;
    text.replace(text.find(from), from.size(), to);
    try {
      ParseRunConfig(text, "run.yaml");
    } catch (const sim::FileError& e) {
      return e.what();
    }
    return "taken";
  };
  EXPECT_THAT(complaint("error_deg: 5", "error_deg: -5"),
              HasSubstr("run.yaml:5:39: error_deg must not be negative"));
  EXPECT_THAT(complaint("settings: [rgbd, with", "settings: [rgbd, no"),
              HasSubstr("run.yaml:7:18: unknown setting 'no_compass'; known are: rgb, rgbd, "
                        "with_compass"));
  EXPECT_THAT(complaint("  with_compass:\n", "  rgbd:\n"), HasSubstr("'rgbd' is there already"));
  EXPECT_THAT(complaint("panorama: {type", "ring: {type"),
              HasSubstr("needs a sensor 'panorama' of type panorama"));
}

}  // namespace
}  // namespace bulletnav::bench
