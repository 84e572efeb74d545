// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "benchmark/base/warn_line.h"
#include "benchmark/cli/camera_options.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/scene_options.h"
#include "benchmark/episodes/drawn_grey.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/image/image.h"
#include "sim/math/rng.h"
#include "sim/sensors/noise/picture_noise.h"
#include "sim/simulated_body.h"

namespace bulletnav::bench {
namespace {

using sim::BodyPose;
using sim::Error;

constexpr int kTries = 100;

struct RenderOptions {
  SceneOptions scene;
  sim::Backend backend = sim::Backend::kAuto;
  CameraOptions camera;
  std::string sensor_noise = "none";
  std::vector<double> pose;  // x, y, z, yaw in degrees
  int random = 0;
  std::uint64_t seed = 0;
  std::filesystem::path out;
};

/// The body's pose at a random free place. Throws sim::PoseError if none is found.
BodyPose RandomPose(const sim::NavmeshQuery& query, sim::CapsuleBody* body, sim::Rng* rng) {
  for (int attempt = 0;; ++attempt) {
    const Eigen::Vector3f p = query.RandomPoint(rng, 0);
    try {
      body->Reset({p.cast<double>(), rng->Uniform(-sim::kPi, sim::kPi)});
      return body->pose();
    } catch (const sim::PoseError&) {
      if (attempt == kTries) throw;
    }
  }
}

/// Free places drawn evenly from the walkable floor, seen in random directions.
std::vector<BodyPose> RandomPoses(const sim::World& world, const RenderOptions& options) {
  sim::RequireFloor(options.scene.file, world.report(), world.navmesh());
  const sim::NavmeshQuery query(world.navmesh());
  sim::Rng rng(sim::RngKey{options.seed, world.id()});
  sim::CapsuleBody body(world.physics(), {});
  const int count = std::max(1, options.random);
  std::vector<BodyPose> poses;
  poses.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) poses.push_back(RandomPose(query, &body, &rng));
  return poses;
}

BodyPose GivenPose(const sim::World& world, const RenderOptions& options) {
  const std::vector<double>& pose = options.pose;
  sim::CapsuleBody body(world.physics(), {});
  try {
    body.Reset({{pose[0], pose[1], pose[2]}, sim::DegToRad(pose[3])});
  } catch (const sim::PoseError& e) {
    throw sim::FileError(options.scene.file, "", std::string("--pose: ").append(e.what()));
  }
  return body.pose();
}

void WritePictures(const std::filesystem::path& folder, const std::string& stem,
                   const sim::PictureSize& size, const std::vector<std::uint8_t>& color,
                   const std::vector<float>& depth) {
  sim::Image image(size.cols, size.rows, 3);
  image.pixels = color;
  sim::WritePng(folder / (stem + "_color.png"), image);
  std::vector<std::uint16_t> millimetres;
  millimetres.reserve(depth.size());
  for (const float d : depth) {
    millimetres.push_back(static_cast<std::uint16_t>(std::min(65535.0f, std::round(1000.0f * d))));
  }
  sim::WriteFileAtomically(folder / (stem + "_depth.png"),
                           sim::EncodePng16(millimetres, size.cols, size.rows));
}

std::shared_ptr<const sim::World> LoadWorld(const std::filesystem::path& file,
                                            const sim::WorldOptions& options) {
  const Progress loading("loading " + file.string());
  return sim::World::Load(file, options);
}

void Render(const RenderOptions& options) {
  const sim::CameraSpec spec = options.camera.spec();
  const sim::PictureSize size = sim::SizeOf(spec);
  sim::WorldOptions world_options;
  world_options.import = options.scene.import();
  world_options.backend = options.backend;
  const auto world = LoadWorld(options.scene.file, world_options);
  const std::string grey = DrawnGrey(options.scene.file, world->report());
  if (!grey.empty()) WarnLine(grey);
  const auto renderer = world->render_scene().MakeRenderer(spec);
  const std::vector<BodyPose> poses = options.pose.empty()
                                          ? RandomPoses(*world, options)
                                          : std::vector<BodyPose>{GivenPose(*world, options)};
  sim::PictureNoise noise(sim::NamedSensorNoise(options.sensor_noise), spec);
  const sim::Rng random(options.seed, "render");
  std::vector<std::uint8_t> color(3 * size.pixels());
  std::vector<float> depth(size.pixels());
  const bool asks_for_glass = noise.asks_for_glass() && world->render_scene().has_glass();
  std::vector<std::uint8_t> glass(asks_for_glass ? size.pixels() : 0);
  sim::MakeFolder(options.out);
  nlohmann::json list = nlohmann::json::array();
  Progress progress("rendering", static_cast<int>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const BodyPose& pose = poses[i];
    const Eigen::Vector3d eye =
        pose.position + Eigen::Vector3d(0, sim::BodySpec().camera_height, 0);
    const sim::CameraPose camera{eye.cast<float>(), static_cast<float>(pose.yaw)};
    renderer->Draw({&camera, 1}, {color, depth, {}, glass});
    noise.Apply(random.Fork("picture", i), color, depth, glass);
    const std::string stem = fmt::format("{:04}", i);
    WritePictures(options.out, stem, size, color, depth);
    list.push_back({{"name", stem},
                    {"position", {pose.position.x(), pose.position.y(), pose.position.z()}},
                    {"yaw_deg", sim::RadToDeg(pose.yaw)}});
    progress.Advance();
  }
  sim::WriteFileAtomically(options.out / "poses.json", list.dump(1) + "\n");
  const char* what = std::holds_alternative<sim::PanoramaSpec>(spec) ? "panorama" : "picture";
  fmt::print("{} {}{} in {} ({})\n", poses.size(), what, poses.size() == 1 ? "" : "s",
             options.out.string(), world->render_scene().description());
}

}  // namespace

void AddRenderCommand(CLI::App* program) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program->add_subcommand(
      "render", "Draw panoramas or flat pictures: colour PNG and 16-bit depth PNG in millimetres");
  options->scene.AddTo(command);
  CLI::Option* pose =
      command->add_option("--pose", options->pose, "Place on the floor and heading: X,Y,Z,YAW_DEG")
          ->delimiter(',')
          ->expected(4);
  command->add_option("--random", options->random, "This many random free places (default 1)")
      ->check(CLI::Range(1, 1'000'000))
      ->excludes(pose);
  command->add_option("--seed", options->seed, "Seed of the random places and the noise")
      ->check(CLI::Range(0, 1'000'000'000));
  AddBackendOption(command, &options->backend);
  options->camera.AddTo(command);
  command
      ->add_option("--sensor-noise", options->sensor_noise,
                   "Noise of the camera (default none); see docs/rendering.md")
      ->check(CLI::IsMember(sim::SensorNoiseNames()));
  command->add_option("--out", options->out, "Folder for the pictures")->required();
  command->callback([options] {
    Render(*options);
  });
}

}  // namespace bulletnav::bench
