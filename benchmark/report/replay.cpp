// SPDX-License-Identifier: MIT
#include "benchmark/report/replay.h"

#include <fmt/core.h>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/simulated_body.h"

namespace bulletnav::bench {
namespace {

constexpr double kMostDeviation = 0.01;  // metres

sim::Image Render(const sim::CameraPose& camera, sim::Renderer* renderer) {
  const sim::PictureSize size = sim::SizeOf(renderer->spec());
  sim::Image image(size.cols, size.rows, 3);
  renderer->Render({&camera, 1}, image.pixels, {});
  return image;
}

void RequireRecorded(const EpisodeTrajectory& trajectory, std::size_t step,
                     const sim::BodyPose& pose) {
  const double deviation = (pose.position - trajectory.steps[step].pose.position).norm();
  if (deviation <= kMostDeviation) return;
  throw sim::Error(fmt::format(
      "episode '{}' of {}: replayed, step {} ends {:.2f} m off what was recorded: the scene or the "
      "program has changed since; run the episode again",
      trajectory.result.key.episode, trajectory.result.key.scene, step + 1, deviation));
}

/// Takes the steps from one number to another.
void Walk(const EpisodeTrajectory& trajectory, std::size_t from, std::size_t to,
          sim::SimulatedBody* body) {
  BULLETNAV_CHECK_LE(from, to);
  BULLETNAV_CHECK_LE(to, trajectory.steps.size());
  for (std::size_t i = from; i < to; ++i) {
    body->Step(trajectory.steps[i].action);
    RequireRecorded(trajectory, i, body->true_pose());
  }
}

}  // namespace

sim::Image LookFrom(const sim::World& world, const sim::BodySpec& body,
                    const sim::PanoramaSpec& panorama, const sim::BodyPose& pose) {
  const Eigen::Vector3d eye = pose.position + Eigen::Vector3d(0, body.camera_height, 0);
  const auto renderer = world.render_scene().MakeRenderer(panorama);
  return Render({eye.cast<float>(), static_cast<float>(pose.yaw)}, renderer.get());
}

std::vector<sim::Image> ReplayPanoramas(const std::shared_ptr<const sim::World>& world,
                                        const EpisodeTrajectory& trajectory,
                                        const sim::PanoramaSpec& panorama,
                                        std::span<const int> steps) {
  const auto renderer = world->render_scene().MakeRenderer(panorama);
  sim::SimulatedBody body(world, trajectory.body, sim::NoiseModel(trajectory.noise));
  body.Reset(trajectory.start, trajectory.key);
  std::vector<sim::Image> pictures;
  std::size_t done = 0;
  for (const int number : steps) {
    const auto wanted = static_cast<std::size_t>(number);
    Walk(trajectory, done, wanted, &body);
    done = wanted;
    pictures.push_back(Render(body.camera_pose(), renderer.get()));
  }
  return pictures;
}

}  // namespace bulletnav::bench
