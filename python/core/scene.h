// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "benchmark/episodes/drawn_grey.h"
#include "benchmark/episodes/import_spec.h"
#include "sim/navmesh/navmesh.h"
#include "sim/world.h"

namespace bulletnav::python {

/// The keyword arguments of bulletnav.Scene.
struct SceneConfig {
  bench::ImportSpec scene_import;
  sim::NavmeshSpec navmesh;
  sim::Backend backend = sim::Backend::kAuto;

  template <class V>
  void Visit(V& v) {
    v("import", scene_import);
    v("navmesh", navmesh);
    v("backend", backend);
  }
};

/// A sim::World to look at and ask the way in, safe to call from any thread, one after the other.
/// In a process that was forked off all calls throw sim::Error.
class Scene {
 public:
  /// `config`: a SceneConfig as YAML or JSON. Throws sim::Error.
  Scene(const std::filesystem::path& file, const std::string& config);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  Scene(Scene&&) = delete;
  Scene& operator=(Scene&&) = delete;

  /// Throws in another process than the one that made it.
  const sim::World& world() const;
  /// What of it is drawn grey; see bench::DrawnGrey.
  std::string grey() const { return bench::DrawnGrey(file_, world().report()); }
  sim::NavmeshQuery Query() const { return sim::NavmeshQuery(world().navmesh()); }
  /// Points drawn evenly from an island's area. Throws sim::Error for one that is not there.
  std::vector<Eigen::Vector3f> RandomPoints(int count, std::uint64_t seed, int island) const;
  /// Pictures at poses into memory for all of them; the renderer of the last camera is kept.
  void Render(const sim::CameraSpec& camera, std::span<const sim::CameraPose> poses,
              std::span<std::uint8_t> color, std::span<float> depth);

 private:
  std::filesystem::path file_;
  pid_t process_;
  std::shared_ptr<const sim::World> world_;
  std::mutex mutex_;  // of the renderer
  std::string camera_;
  std::unique_ptr<sim::Renderer> renderer_;
};

}  // namespace bulletnav::python
