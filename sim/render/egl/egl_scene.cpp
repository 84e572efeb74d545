// SPDX-License-Identifier: MIT
#include "sim/render/egl/egl_scene.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/render/egl/id_pass.h"
#include "sim/render/egl/scene_buffers.h"
#include "sim/render/egl/shader_resolve.h"
#include "sim/render/egl/views.h"
#include "sim/render/egl_backend.h"
#include "sim/render/kernels/sampling.h"

namespace bulletnav::sim {
namespace {

constexpr int kHardwareBatch = 32;
constexpr int kSoftwareBatch = 2;
constexpr int kMaxTarget = 16384;

/// The views are sampled finer than the panorama, so that the ids around a ray hold what it meets;
/// finer where triangles are finer. Measured in docs/rendering.md.
double Oversampling(const SceneBuffers& scene, const CameraSpec& spec) {
  const double triangles = static_cast<double>(scene.mesh.corners.size());
  const double wanted =
      scene.shade_on_device ? 3.0 : std::clamp(std::sqrt(triangles / 10'000.0), 2.6, 3.0);
  return std::min(wanted, 0.8 * kMaxTarget / SizeOf(spec).cols);
}

void CheckTarget(const ViewLayout& layout) {
  if (layout.width > kMaxTarget || layout.height > kMaxTarget) {
    throw RenderError(
        fmt::format("the camera needs a picture of {} x {} pixels, and OpenGL draws {} at most; "
                    "make it smaller, or use the backend embree",
                    layout.width, layout.height, kMaxTarget));
  }
}

/// Both passes on the device, many cameras at once.
class DeviceRenderer final : public Renderer {
 public:
  DeviceRenderer(const SceneBuffers& scene, const CameraSpec& spec)
      : spec_(spec), layout_(spec, Oversampling(scene, spec)), context_(scene.context.Share()) {
    CheckTarget(layout_);
    batch_ = scene.context.is_hardware() ? kHardwareBatch : kSoftwareBatch;
    const EglContext::Current current(*context_);
    ids_ = std::make_unique<IdPass>(scene, layout_, batch_);
    resolve_ = std::make_unique<ShaderResolve>(scene, layout_, spec, batch_);
  }
  ~DeviceRenderer() override {
    const EglContext::Current current(*context_);
    resolve_.reset();
    ids_.reset();
  }
  DeviceRenderer(const DeviceRenderer&) = delete;
  DeviceRenderer& operator=(const DeviceRenderer&) = delete;
  DeviceRenderer(DeviceRenderer&&) = delete;
  DeviceRenderer& operator=(DeviceRenderer&&) = delete;

  const CameraSpec& spec() const override { return spec_; }
  int preferred_batch() const override { return batch_; }

  void Draw(std::span<const CameraPose> cameras, const PictureMemory& out) override {
    if (!out.objects.empty()) RenderObjects(cameras, out.color, out.depth, out.objects);  // throws
    const PictureSlices checked(spec_, cameras, out);
    const EglContext::Current current(*context_);
    const std::size_t pixels = SizeOf(spec_).pixels();
    const auto batch = static_cast<std::size_t>(batch_);
    for (std::size_t first = 0; first < cameras.size(); first += batch) {
      const std::size_t n = std::min(batch, cameras.size() - first);
      ids_->Draw(cameras.subspan(first, n), /*leave_out_hidden=*/false);
      const auto part = [&](auto all, std::size_t values) {
        return all.empty() ? all : all.subspan(values * first, values * n);
      };
      resolve_->Run(
          cameras.subspan(first, n), ids_->ids(),
          {part(out.color, 3 * pixels), part(out.depth, pixels), {}, part(out.glass, pixels)});
    }
  }

 private:
  CameraSpec spec_;
  ViewLayout layout_;
  std::unique_ptr<EglContext> context_;
  int batch_ = 1;
  std::unique_ptr<IdPass> ids_;
  std::unique_ptr<ShaderResolve> resolve_;
};

/// The id pass by the driver, the rest with the CPU's kernels.
class CpuResolveRenderer final : public Renderer {
 public:
  CpuResolveRenderer(const SceneBuffers& scene, const CameraSpec& spec)
      : mesh_(scene.mesh),
        sampling_(spec),
        layout_(spec, Oversampling(scene, spec)),
        context_(scene.context.Share()) {
    CheckTarget(layout_);
    const EglContext::Current current(*context_);
    ids_ = std::make_unique<IdPass>(scene, layout_, 1);
    places_ = PlacesOfRays(layout_, sampling_.rays(), sampling_.grid().stride);
    scene_ = {nullptr,
              nullptr,
              scene.mesh.corners.front().front().data(),
              scene.mesh.shading.data(),
              scene.mesh.textures.texels.data(),
              scene.mesh.textures.infos.data(),
              scene.mesh.back_faces};
  }
  ~CpuResolveRenderer() override {
    const EglContext::Current current(*context_);
    ids_.reset();
  }
  CpuResolveRenderer(const CpuResolveRenderer&) = delete;
  CpuResolveRenderer& operator=(const CpuResolveRenderer&) = delete;
  CpuResolveRenderer(CpuResolveRenderer&&) = delete;
  CpuResolveRenderer& operator=(CpuResolveRenderer&&) = delete;

  const CameraSpec& spec() const override { return sampling_.spec(); }
  int preferred_batch() const override { return 1; }

  bool sees_objects() const override { return true; }

  void Draw(std::span<const CameraPose> cameras, const PictureMemory& out) override {
    const PictureSlices slices(spec(), cameras, out);
    const EglContext::Current current(*context_);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      ids_->Draw(cameras.subspan(i, 1), /*leave_out_hidden=*/true);
      ids_->ReadIds(&id_picture_);
      const KernelFrame frame = sampling_.Frame(cameras[i]);
      const KernelIdPicture picture = {id_picture_.data(), layout_.width, places_.data()};
      kernels_.resolve(scene_, sampling_.grid(), frame, picture, sampling_.hits());
      kernels_.shade(scene_, sampling_.grid(), frame, sampling_.hits(), slices.color(i),
                     slices.depth(i));
      slices.WriteSeen(i, sampling_, mesh_.objects, mesh_.shading);
    }
  }

 private:
  const Kernels& kernels_ = *SupportedKernels()[0];
  const RenderMesh& mesh_;
  Sampling sampling_;
  ViewLayout layout_;
  std::unique_ptr<EglContext> context_;
  std::unique_ptr<IdPass> ids_;
  KernelScene scene_{};
  std::vector<std::int32_t> places_;
  std::vector<std::uint32_t> id_picture_;
};

class EglScene final : public RenderScene {
 public:
  EglScene(const SceneMesh& mesh, GlDevice device, ResolveOn resolve)
      : buffers_(mesh, device, resolve) {}

  Backend backend() const override { return Backend::kEgl; }
  std::string description() const override { return "EGL, " + buffers_.context.renderer(); }
  bool has_objects() const override { return !buffers_.mesh.objects.empty(); }
  bool has_glass() const override { return buffers_.mesh.has_glass; }
  std::unique_ptr<Renderer> MakeRenderer(const CameraSpec& spec) const override {
    if (buffers_.shade_on_device) return std::make_unique<DeviceRenderer>(buffers_, spec);
    return std::make_unique<CpuResolveRenderer>(buffers_, spec);
  }

 private:
  SceneBuffers buffers_;
};

}  // namespace

std::unique_ptr<const RenderScene> MakeEglScene(const SceneMesh& mesh, GlDevice device,
                                                ResolveOn resolve) {
  return std::make_unique<EglScene>(mesh, device, resolve);
}

std::unique_ptr<const RenderScene> MakeEglRenderScene(const SceneMesh& mesh, bool on_hardware) {
  return MakeEglScene(mesh, on_hardware ? GlDevice::kHardware : GlDevice::kAny);
}

}  // namespace bulletnav::sim
