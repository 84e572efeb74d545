// SPDX-License-Identifier: MIT
// What sensors write, alone and in batches, against renderers asked directly.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/batch_simulator.h"
#include "sim/sensors/cameras.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;
using tests::BoxRoom;

const BodyPose kStart{{1.5, 0, -2}, 0.7};

std::shared_ptr<const World> Room() {
  return World::FromMesh(BoxRoom(4, 2.6f, 6), "room");
}

PinholeSensorConfig Front() {
  PinholeSensorConfig config;
  config.camera = {.hfov_deg = 79, .rows = 24, .cols = 32, .pitch_deg = -15};
  config.mount = {.forward_m = 0.1, .left_m = 0.05, .above_m = -0.25, .yaw_deg = 90};
  return config;
}

/// A panorama of depth, a camera that looks to the left, and what every body has.
SimulatorSpec Spec() {
  SimulatorSpec spec;
  spec.sensors = SensorSet::Usual({.rows = 16, .cols = 64}, false, true);
  spec.sensors.Add("front", PinholeSensor(Front()));
  return spec;
}

TEST(Sensors, AMountedCameraDrawsWhatARendererThereWould) {
  const auto world = Room();
  Simulator simulator(world, Spec());
  const Observation& seen = simulator.Reset(kStart);
  // By hand: the body looks along (-sin yaw, 0, -cos yaw), its left is (-cos yaw, 0, sin yaw).
  const double s = std::sin(kStart.yaw);
  const double c = std::cos(kStart.yaw);
  const Eigen::Vector3d eye = kStart.position + Eigen::Vector3d(0, 1.25 - 0.25, 0) +
                              0.1 * Eigen::Vector3d(-s, 0, -c) + 0.05 * Eigen::Vector3d(-c, 0, s);
  const auto yaw = static_cast<float>(kStart.yaw) + static_cast<float>(DegToRad(90.0));
  const tests::Panorama drawn =
      tests::RenderPanorama(world->render_scene(), Front().camera, {eye.cast<float>(), yaw});
  EXPECT_THAT(seen.values<std::uint8_t>("front.color"), ElementsAreArray(drawn.color));
  EXPECT_THAT(seen.values<float>("front.depth"), ElementsAreArray(drawn.depth));
}

TEST(Sensors, ThePanoramaStandsInItsOwnFieldsToo) {
  Simulator simulator(Room(), Spec());
  const Observation& seen = simulator.Reset(kStart);
  EXPECT_TRUE(seen.color.empty());
  EXPECT_EQ(seen.depth.size(), 16u * 64);
  EXPECT_EQ(seen.values<float>("panorama.depth").data(), seen.depth.data());
}

TEST(Sensors, OdometryAndBumperAreArraysAsWell) {
  Simulator simulator(Room(), Spec());
  const Observation& seen = simulator.Reset(kStart);
  EXPECT_THAT(seen.values<double>("odometry.motion"), testing::Each(0.0));
  for (int step = 0; step < 20; ++step) {
    simulator.Step(Action::kMoveForward);
    const std::array motion = {seen.sensors.odometry.x, seen.sensors.odometry.y,
                               seen.sensors.odometry.yaw};
    EXPECT_THAT(seen.values<double>("odometry.motion"), ElementsAreArray(motion));
    EXPECT_EQ(seen.values<std::uint8_t>("bumper.collided")[0], seen.sensors.collided ? 1 : 0);
  }
  EXPECT_TRUE(seen.sensors.collided);  // a room is not five metres long
}

TEST(Sensors, ACameraTellsObjectsApart) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  mesh.objects = {{}, {"wall", "wall_1", "room"}, {"box", "box_1", "room"}};
  mesh.triangle_objects.assign(mesh.triangles.size(), 1);
  tests::AddBox({0.2f, 0, -3.5f}, {1.2f, 2, -3}, {90, 90, 90}, &mesh);
  mesh.triangle_objects.resize(mesh.triangles.size(), 2);
  WorldOptions options;
  options.backend = Backend::kEmbree;
  const auto world = World::FromMesh(mesh, "room", options);
  EXPECT_EQ(world->objects(), mesh.objects);
  SimulatorSpec spec;
  PanoramaSensorConfig around;
  around.panorama = {.rows = 32, .cols = 128};
  around.channels = {"semantic", "depth"};
  spec.sensors.Add("around", PanoramaSensor(around));
  Simulator simulator(world, spec);
  const Observation& seen = simulator.Reset(kStart);
  const auto objects = seen.values<std::int32_t>("around.semantic");
  EXPECT_THAT(objects, testing::Contains(2));
  EXPECT_THAT(objects, testing::Each(testing::AnyOf(1, 2)));
  around.channels = {"depth"};
  const tests::Panorama drawn =
      tests::RenderPanorama(world->render_scene(), around.panorama,
                            {kStart.position.cast<float>() + Eigen::Vector3f(0, 1.25f, 0),
                             static_cast<float>(kStart.yaw)});
  EXPECT_THAT(seen.values<float>("around.depth"), ElementsAreArray(drawn.depth));
}

TEST(Sensors, ASceneWithoutObjectsHasNoneToTellApart) {
  PinholeSensorConfig front = Front();
  front.channels = {"semantic"};
  SimulatorSpec spec = Spec();
  spec.sensors.Add("objects", PinholeSensor(front));
  try {
    Simulator simulator(Room(), spec);
    simulator.Reset(kStart);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("the channel semantic needs a scene whose objects are known"));
  }
}

TEST(Sensors, WrongNamesAndTypesAreErrors) {
  Simulator simulator(Room(), Spec());
  const Observation& seen = simulator.Reset(kStart);
  try {
    seen.array("back.depth");
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("panorama.depth, odometry.motion, bumper.collided, "
                                    "front.color, front.depth"));
  }
  EXPECT_THROW(seen.values<double>("front.depth"), Error);
}

void ExpectLanesReadAsIfAlone(const SimulatorSpec& spec) {
  constexpr int kLanes = 3;
  const auto world = Room();
  BatchSimulator batch({world, world, world}, spec, 2);
  std::vector<std::vector<std::byte>> memory;
  std::vector<BatchArray> arrays;
  memory.reserve(batch.arrays().size());
  for (const ArraySpec& array : batch.arrays()) {
    memory.emplace_back(kLanes * array.bytes());
    arrays.push_back({array.name, memory.back()});
  }
  const std::vector<Action> actions(kLanes, Action::kMoveForward);
  std::vector<Sensors> read(kLanes);
  for (int lane = 0; lane < kLanes; ++lane) batch.Reset(lane, {{1.5, 0, -2}, 0.9 * lane});
  batch.Step(actions, read, {{}, {}, arrays});
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    Simulator alone(world, spec);
    alone.Reset({{1.5, 0, -2}, 0.9 * static_cast<double>(lane)});
    const Observation& seen = alone.Step(Action::kMoveForward);
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      const std::size_t bytes = batch.arrays()[i].bytes();
      const auto mine = std::span(memory[i]).subspan(lane * bytes, bytes);
      EXPECT_TRUE(std::ranges::equal(mine, seen.array(arrays[i].name).bytes()))
          << arrays[i].name << " of lane " << lane;
    }
  }
}

TEST(Sensors, EveryLaneReadsWhatASimulatorOfItsOwnWould) {
  SimulatorSpec spec = Spec();
  ExpectLanesReadAsIfAlone(spec);
  spec.sensor_noise = NamedSensorNoise("depth_camera");
  ExpectLanesReadAsIfAlone(spec);
}

std::vector<float> FrontDepth(Simulator* simulator, const EpisodeKey& key, int steps) {
  const Observation* seen = &simulator->Reset(kStart, key);
  for (int i = 0; i < steps; ++i) seen = &simulator->Step(Action::kStop);
  const std::span<const float> depth = seen->values<float>("front.depth");
  return {depth.begin(), depth.end()};
}

TEST(Sensors, CamerasNoiseFollowsFromSeedEpisodeAndStep) {
  SimulatorSpec spec = Spec();
  Simulator clean(Room(), spec);
  spec.sensor_noise = NamedSensorNoise("stereo_camera");
  Simulator noisy(Room(), spec);
  EXPECT_EQ(FrontDepth(&clean, {1, 1}, 0), FrontDepth(&clean, {1, 1}, 1));
  const std::vector<float> first = FrontDepth(&noisy, {1, 1}, 0);
  EXPECT_NE(first, FrontDepth(&clean, {1, 1}, 0));
  EXPECT_NE(first, FrontDepth(&noisy, {1, 1}, 1));
  EXPECT_NE(first, FrontDepth(&noisy, {1, 2}, 0));
  EXPECT_NE(first, FrontDepth(&noisy, {2, 1}, 0));
  EXPECT_EQ(first, FrontDepth(&noisy, {1, 1}, 0));
}

TEST(Sensors, ABatchsPanoramaHasTheNoiseOfASimulators) {
  SimulatorSpec spec;
  spec.panorama = {.rows = 16, .cols = 64};
  spec.sensor_noise = NamedSensorNoise("depth_camera");
  BatchSimulator batch({Room(), Room()}, spec, 2);
  std::vector<std::uint8_t> color(2 * 3 * 16 * 64);
  std::vector<float> depth(2 * 16 * 64);
  for (const int lane : {0, 1}) batch.Reset(lane, kStart, {1, static_cast<std::uint64_t>(lane)});
  batch.Observe({color, depth});
  Simulator alone(Room(), spec);
  const Observation& seen = alone.Reset(kStart, {1, 1});
  EXPECT_TRUE(std::equal(seen.color.begin(), seen.color.end(), color.begin() + 3 * 16 * 64));
  EXPECT_TRUE(std::equal(seen.depth.begin(), seen.depth.end(), depth.begin() + 16 * 64));
  EXPECT_FALSE(std::equal(seen.color.begin(), seen.color.end(), color.begin()));
}

/// A room whose far wall is one pane, called so.
std::shared_ptr<const World> RoomWithAPane(const std::string& name) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  tests::AddQuad({0.5f, 0.5f, -5.9f}, {3.5f, 0.5f, -5.9f}, {3.5f, 2.2f, -5.9f}, {0.5f, 2.2f, -5.9f},
                 kWhite, &mesh);
  mesh.materials.back().name = name;
  return World::FromMesh(mesh, "room");
}

/// All that a body at the start sees, with colour.
Observation SeenAtTheStart(const std::shared_ptr<const World>& world, const SensorNoise& noise) {
  SimulatorSpec spec;
  spec.panorama = {.rows = 64, .cols = 256};
  spec.sensors = SensorSet::Usual(spec.panorama, true, true);
  PinholeSensorConfig ahead;
  ahead.camera = {.rows = 48, .cols = 64};
  spec.sensors.Add("front", PinholeSensor(ahead));
  spec.sensor_noise = noise;
  Simulator simulator(world, spec);
  return simulator.Reset(kStart, {1, 1});
}

TEST(Sensors, APaneLosesDepthInItsAreaAlone) {
  const SensorNoise noise = NamedSensorNoise("depth_camera");
  const auto glazed = RoomWithAPane("Window");
  const Observation pane = SeenAtTheStart(glazed, noise);
  const Observation wall = SeenAtTheStart(RoomWithAPane("wallpaper"), noise);
  EXPECT_EQ(pane.color, wall.color);
  EXPECT_TRUE(std::ranges::equal(pane.values<std::uint8_t>("front.color"),
                                 wall.values<std::uint8_t>("front.color")));
  std::vector<std::uint8_t> glass(pane.depth.size());
  const CameraPose eye = {kStart.position.cast<float>() + Eigen::Vector3f(0, 1.25f, 0),
                          static_cast<float>(kStart.yaw)};
  glazed->render_scene()
      .MakeRenderer(PanoramaSpec{.rows = 64, .cols = 256})
      ->Draw({&eye, 1}, {{}, {}, {}, glass});
  double of_glass = 0.0;
  double lost = 0.0;
  std::size_t others = 0;
  for (std::size_t i = 0; i < glass.size(); ++i) {
    if (glass[i] == 0) {
      others += pane.depth[i] != wall.depth[i] ? 1 : 0;
      continue;
    }
    of_glass += 1.0;
    lost += pane.depth[i] == 0.0f && wall.depth[i] > 0.0f ? 1.0 : 0.0;
  }
  EXPECT_GT(of_glass, 200.0);
  EXPECT_GT(lost / of_glass, 0.5);  // 0.75 and more is expected, but holes are large
  EXPECT_LE(others, 120u);          // at its edges, where rays go astray
  EXPECT_FALSE(
      std::ranges::equal(pane.values<float>("front.depth"), wall.values<float>("front.depth")));
}

TEST(Sensors, GlassDoesNothingToCamerasThatDoNotAsk) {
  for (const char* name : {"none", "phone_camera"}) {
    const Observation pane = SeenAtTheStart(RoomWithAPane("Window"), NamedSensorNoise(name));
    const Observation wall = SeenAtTheStart(RoomWithAPane("wallpaper"), NamedSensorNoise(name));
    EXPECT_EQ(pane.color, wall.color);
    EXPECT_EQ(pane.depth, wall.depth);
  }
}

TEST(Sensors, GlassIsTheSameForAnyNumberOfLanesAndWorkers) {
  constexpr std::size_t kLanes = 5;
  const SensorNoise noise = NamedSensorNoise("stereo_camera");
  const auto world = RoomWithAPane("Window");
  const Observation alone = SeenAtTheStart(world, noise);
  SimulatorSpec spec;
  spec.panorama = {.rows = 64, .cols = 256};
  spec.sensor_noise = noise;
  for (const int workers : {1, 3}) {
    BatchSimulator batch(std::vector(kLanes, world), spec, workers);
    for (int lane = 0; lane < static_cast<int>(kLanes); ++lane) {
      batch.Reset(lane, lane == 3 ? kStart : BodyPose{{1.5, 0, -2}, 0.4 * lane}, {1, 1});
    }
    std::vector<float> depth(kLanes * alone.depth.size());
    std::vector<std::uint8_t> color(3 * depth.size());
    batch.Observe({color, depth});
    const auto mine = std::span(depth).subspan(3 * alone.depth.size(), alone.depth.size());
    EXPECT_THAT(mine, ElementsAreArray(alone.depth)) << workers;
  }
}

TEST(Sensors, ABatchReadsWhatIsWantedAlone) {
  const auto world = Room();
  BatchSimulator batch({world, world}, Spec(), 1);
  for (const int lane : {0, 1}) batch.Reset(lane, kStart);
  std::vector<float> depth(2 * 24 * 32, -1.0f);
  const BatchArray wanted{"front.depth", std::as_writable_bytes(std::span(depth))};
  const int second = 1;
  batch.Observe({&second, 1}, {{}, {}, {&wanted, 1}});
  EXPECT_TRUE(std::all_of(depth.begin(), depth.begin() + 24 * 32, [](float d) {
    return d < 0;
  }));
  EXPECT_TRUE(std::all_of(depth.begin() + 24 * 32, depth.end(), [](float d) {
    return d >= 0;
  }));
  const BatchArray unknown{"back.depth", wanted.bytes};
  EXPECT_THROW(batch.Observe({{}, {}, {&unknown, 1}}), Error);
  const BatchArray too_small{"front.depth", wanted.bytes.subspan(4)};
  EXPECT_THROW(batch.Observe({{}, {}, {&too_small, 1}}), Error);
}

}  // namespace
}  // namespace bulletnav::sim
