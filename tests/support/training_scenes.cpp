// SPDX-License-Identifier: MIT
#include "tests/support/training_scenes.h"

#include "benchmark/training/supervised/scene_panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::tests {

sim::SceneMesh TwoRooms() {
  sim::SceneMesh mesh = BoxRoom(8, 2.5f, 4);
  const sim::Rgb8 color = {180, 170, 150};
  AddBox({3.94f, 0, -4}, {4.06f, 2.5f, -2.45f}, color, &mesh);
  AddBox({3.94f, 0, -1.55f}, {4.06f, 2.5f, 0}, color, &mesh);
  AddBox({3.94f, 2.05f, -2.45f}, {4.06f, 2.5f, -1.55f}, color, &mesh);
  return mesh;
}

sim::BodyPose StandingAt(double x, double z, double yaw_deg) {
  return {Eigen::Vector3d(x, 0.0, z), sim::DegToRad(yaw_deg)};
}

std::vector<float> DepthFrom(const sim::SceneMesh& mesh, const bench::DataConfig& config,
                             const sim::BodyPose& pose) {
  const auto scene = sim::MakeRenderScene(mesh, sim::Backend::kEmbree);
  std::vector<float> depth(config.panorama.pixels());
  const int sample = 0;
  bench::ScenePanoramas(*scene, config).Render({&pose, 1}, {&sample, 1}, {}, depth);
  return depth;
}

}  // namespace bulletnav::tests
