// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/scene_panoramas.h"

#include <string>
#include <utility>
#include <vector>

#include "sim/base/check.h"
#include "sim/scene/import.h"

namespace bulletnav::bench {

std::unique_ptr<const sim::RenderScene> LoadForPanoramas(const std::filesystem::path& scene,
                                                         const DataConfig& config,
                                                         const Warn& warn) {
  sim::ImportedScene imported = sim::ImportScene(scene, config.import.options());
  sim::SceneMesh mesh = std::move(imported.drawn ? *imported.drawn : imported.mesh);
  const std::string grey = DrawnGrey(scene, imported.report);
  if (warn && !grey.empty()) warn(grey);
  if (config.looks) {
    const sim::Finish look = DrawLook(*config.looks, config.seed, scene.filename().string());
    sim::ApplyFinish(look, &mesh);
    sim::ApplyDamage(look.damage, &mesh);
  }
  return sim::MakeRenderScene(mesh, sim::Backend::kEmbree);
}

ScenePanoramas::ScenePanoramas(const sim::RenderScene& scene, const DataConfig& config)
    : renderer_(scene.MakeRenderer(config.panorama)),
      camera_height_(double{config.body.camera_height}) {}

void ScenePanoramas::Render(std::span<const sim::BodyPose> poses, std::span<const int> samples,
                            std::span<std::uint8_t> color, std::span<float> depth) {
  std::vector<sim::CameraPose> cameras;
  cameras.reserve(samples.size());
  for (const int sample : samples) {
    BULLETNAV_CHECK(sample >= 0 && static_cast<std::size_t>(sample) < poses.size());
    const sim::BodyPose& pose = poses[static_cast<std::size_t>(sample)];
    const Eigen::Vector3d eye = pose.position + Eigen::Vector3d(0.0, camera_height_, 0.0);
    cameras.push_back({eye.cast<float>(), static_cast<float>(pose.yaw)});
  }
  renderer_->Render(cameras, color, depth);
}

}  // namespace bulletnav::bench
