// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/example_scene.h"

#include <algorithm>

#include "benchmark/report/room_labels.h"
#include "benchmark/report/run_scene.h"
#include "sim/base/error.h"
#include "sim/scene/import.h"

namespace bulletnav::bench {
namespace {

constexpr int kRows = 256;
constexpr int kSmoothing = 3;  // rays a pixel, along each side

DataConfig Finer(const DataConfig& config) {
  DataConfig finer = config;
  finer.panorama = {.rows = kSmoothing * kRows, .cols = kSmoothing * 4 * kRows};
  return finer;
}

/// Of a generated house; a picture without room names will do where there is none.
std::optional<sim::FloorPlan> PlanBeside(const std::filesystem::path& scene, double scale,
                                         const std::vector<sim::DoorLeaf>& doors) {
  try {
    return PlanOfScene(scene, scale, doors);
  } catch (const sim::Error&) {
    return std::nullopt;
  }
}

}  // namespace

ExampleScene::ExampleScene(const SceneCases& cases, const DataConfig& config)
    : ExampleScene(cases, Finer(config), sim::ImportScene(cases.scene, config.import.options())) {}

ExampleScene::ExampleScene(const SceneCases& cases, const DataConfig& finer,
                           const sim::ImportedScene& scene)
    : cases_(cases),
      size_(finer.panorama),
      render_(sim::MakeRenderScene(scene.drawn_mesh(), sim::Backend::kEmbree)),
      panoramas_(*render_, finer),
      map_(MakeSceneMap(scene.mesh, sim::Navmesh(scene.mesh, finer.navmesh),
                        PlanBeside(cases.scene, finer.import.scale, scene.doors))) {}

sim::Image ExampleScene::Panorama(int place) {
  sim::BodyPose turned = cases_.samples.poses[static_cast<std::size_t>(place)];
  turned.yaw = sim::WrapAngle(turned.yaw + sim::kPi / agent::kDirections);
  sim::Image image(size_.cols, size_.rows, 3);
  const int only = 0;
  panoramas_.Render({&turned, 1}, {&only, 1}, image.pixels, {});
  return Resize(image, 4 * kRows, kRows);
}

std::string ExampleScene::RoomOf(int place) const {
  if (!map_.plan) return "";
  const Eigen::Vector3d& at = cases_.samples.poses[static_cast<std::size_t>(place)].position;
  const sim::PlanPoint point(static_cast<float>(at.x()), static_cast<float>(at.z()));
  const sim::Room* room = RoomAt(*map_.plan, point);
  if (room == nullptr) return "";
  std::string name(sim::NameOf(room->type));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace bulletnav::bench
