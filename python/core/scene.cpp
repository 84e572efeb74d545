// SPDX-License-Identifier: MIT
#include "python/core/scene.h"

#include "python/core/arguments.h"

#include <fmt/core.h>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::python {
namespace {

/// What tells a camera from others.
std::string TextOf(const sim::CameraSpec& camera) {
  return std::visit(
      [&]<class Spec>(const Spec& spec) {
        return fmt::format("{}: {}", camera.index(), sim::ToYaml(spec));
      },
      camera);
}

}  // namespace

Scene::Scene(const std::filesystem::path& file, const std::string& config)
    : file_(file), process_(::getpid()) {
  const auto read = ReadArguments<SceneConfig>(config);
  world_ = sim::World::Load(file, {read.scene_import.options(), read.navmesh, read.backend});
}

Scene::~Scene() {
  if (::getpid() == process_) return;
  // The threads of a renderer are not there in a process that was forked off.
  renderer_.release();                                       // NOLINT: left alone
  new std::shared_ptr<const sim::World>(std::move(world_));  // NOLINT: likewise
}

const sim::World& Scene::world() const {
  if (::getpid() != process_) {
    throw sim::Error(
        "bulletnav scene: it belongs to the process that loaded it; load it after forking");
  }
  return *world_;
}

std::vector<Eigen::Vector3f> Scene::RandomPoints(int count, std::uint64_t seed, int island) const {
  const auto islands = static_cast<int>(world().navmesh().islands().size());
  if (island < -1 || island >= islands || islands == 0) {
    throw sim::Error(
        fmt::format("bulletnav scene: there is no island {} of walkable floor; there "
                    "are {}, and -1 stands for all of them",
                    island, islands));
  }
  if (count < 0) throw sim::Error("bulletnav scene: count must not be negative");
  const sim::NavmeshQuery query = Query();
  sim::Rng rng(seed, "random points");
  std::vector<Eigen::Vector3f> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) points.push_back(query.RandomPoint(&rng, island));
  return points;
}

void Scene::Render(const sim::CameraSpec& camera, std::span<const sim::CameraPose> poses,
                   std::span<std::uint8_t> color, std::span<float> depth) {
  const sim::World& own = world();
  const std::lock_guard lock(mutex_);
  const std::string text = TextOf(camera);
  if (!renderer_ || camera_ != text) {
    renderer_ = own.render_scene().MakeRenderer(camera);
    camera_ = text;
  }
  renderer_->Render(poses, color, depth);
}

}  // namespace bulletnav::python
