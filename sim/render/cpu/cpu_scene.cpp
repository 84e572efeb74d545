// SPDX-License-Identifier: MIT
#include "sim/render/cpu/cpu_scene.h"

#include <vector>

#include "sim/render/cpu/bvh.h"
#include "sim/render/detail/levels_of_detail.h"
#include "sim/render/kernels/sampling.h"
#include "sim/render/render_mesh.h"

namespace bulletnav::sim {
namespace {

/// Geometry and shading, shared by all renderers of a scene.
struct EmbreeData {
  explicit EmbreeData(const SceneMesh& scene) : mesh(scene), bvh(mesh.corners) {
    if (scene.levels_of_detail) AddLevelsOfDetail(scene, &mesh, &bvh);
    mesh.corners.clear();
    mesh.corners.shrink_to_fit();
  }
  KernelScene kernel() const {
    return {bvh.nodes.data(),    bvh.leaves.data(),           nullptr,
            mesh.shading.data(), mesh.textures.texels.data(), mesh.textures.infos.data(),
            mesh.back_faces};
  }

  RenderMesh mesh;
  Bvh bvh;
};

class EmbreeRenderer final : public Renderer {
 public:
  EmbreeRenderer(const EmbreeData& data, const Kernels& kernels, const CameraSpec& spec)
      : scene_(data.kernel()), mesh_(data.mesh), kernels_(kernels), sampling_(spec) {
    tile_farthest_.resize(std::size_t{kTileRows} * kTileColumns);
    dirty_.resize(kTileColumns);
    entries_.resize(data.bvh.nodes.size() + data.bvh.leaves.size());
    buckets_.resize(kBuckets);
  }

  const CameraSpec& spec() const override { return sampling_.spec(); }
  int preferred_batch() const override { return 1; }

  bool sees_objects() const override { return true; }

  void Draw(std::span<const CameraPose> cameras, const PictureMemory& out) override {
    const KernelScratch scratch = {tile_farthest_.data(), dirty_.data(), entries_.data(),
                                   buckets_.data()};
    const PictureSlices slices(spec(), cameras, out);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      const KernelFrame frame = sampling_.Frame(cameras[i]);
      kernels_.find_visible(scene_, sampling_.grid(), frame, scratch, sampling_.hits());
      kernels_.shade(scene_, sampling_.grid(), frame, sampling_.hits(), slices.color(i),
                     slices.depth(i));
      slices.WriteSeen(i, sampling_, mesh_.objects, mesh_.shading);
    }
  }

 private:
  KernelScene scene_;
  const RenderMesh& mesh_;
  const Kernels& kernels_;
  Sampling sampling_;
  std::vector<float> tile_farthest_;
  std::vector<std::uint16_t> dirty_;
  std::vector<QueueEntry> entries_;
  std::vector<std::int32_t> buckets_;
};

class EmbreeRenderScene final : public RenderScene {
 public:
  EmbreeRenderScene(const SceneMesh& mesh, const Kernels& kernels)
      : data_(mesh), kernels_(kernels) {}

  Backend backend() const override { return Backend::kEmbree; }
  std::string description() const override { return std::string("Embree 3, ") + kernels_.name; }
  bool has_objects() const override { return !data_.mesh.objects.empty(); }
  bool has_glass() const override { return data_.mesh.has_glass; }
  std::unique_ptr<Renderer> MakeRenderer(const CameraSpec& spec) const override {
    return std::make_unique<EmbreeRenderer>(data_, kernels_, spec);
  }

 private:
  EmbreeData data_;
  const Kernels& kernels_;
};

}  // namespace

std::unique_ptr<const RenderScene> MakeCpuScene(const SceneMesh& mesh, const Kernels& kernels) {
  return std::make_unique<EmbreeRenderScene>(mesh, kernels);
}

}  // namespace bulletnav::sim
