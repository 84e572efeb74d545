// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <Eigen/Core>

#include "sim/config/yaml_reader.h"
#include "sim/render/projection.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

enum class Backend { kAuto, kEgl, kEmbree };

template <>
struct EnumNames<Backend> {
  static constexpr std::array kNames = {std::pair{"auto", Backend::kAuto},
                                        std::pair{"egl", Backend::kEgl},
                                        std::pair{"embree", Backend::kEmbree}};
};

/// An upright camera in the world: y up, yaw 0 looks along -z, positive turns left.
struct CameraPose {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  float yaw = 0.0f;
};

/// Where n pictures go: the caller's memory, one after the other. An empty span: not wanted.
struct PictureMemory {
  std::span<std::uint8_t> color;    // [n, rows, cols, 3]
  std::span<float> depth;           // [n, rows, cols], like those below
  std::span<std::int32_t> objects;  // see Renderer::RenderObjects
  std::span<std::uint8_t> glass;    // 1 where glass or a mirror is seen, see IsGlass; else 0
};

/// Draws RGBD pictures of one scene with one kind of camera; one renderer a thread, any number a
/// scene.
/// Output, for n cameras, into the caller's memory without a further copy:
///   color u8 [n, rows, cols, 3] RGB, black where nothing is seen;
///   depth f32 [n, rows, cols] metres, *range* along the ray, clipped at spec.max_depth_m,
///   0 = no return. An empty span: not wanted.
/// The middle of the picture looks forward; of a panorama, column 0 looks 180 degrees behind and
/// columns go clockwise; a pinhole camera's column 0 is on the left. Pixels are sampled at their
/// centres; both backends evaluate the same rays and textures. Throws: Error if a span does not fit
/// or a pose is not finite, RenderError if the GL context is lost. Source: ours, after the
/// observation of Neural Topological SLAM, section 5.
class Renderer {
 public:
  virtual ~Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  Renderer(Renderer&&) = delete;
  Renderer& operator=(Renderer&&) = delete;

  virtual const CameraSpec& spec() const = 0;
  /// How many cameras at once this backend likes: 1 on a CPU, many on a GPU.
  virtual int preferred_batch() const = 0;
  void Render(std::span<const CameraPose> cameras, std::span<std::uint8_t> color,
              std::span<float> depth) {
    Draw(cameras, {color, depth, {}, {}});
  }

  /// Whether this kind of renderer can tell which objects it sees.
  virtual bool sees_objects() const { return false; }
  /// As Render, and objects i32 [n, rows, cols]: numbers in SceneMesh::objects of what is seen, at
  /// any distance, 0 where nothing is seen or nothing known. Throws RenderError, naming the remedy,
  /// unless sees_objects.
  void RenderObjects(std::span<const CameraPose> cameras, std::span<std::uint8_t> color,
                     std::span<float> depth, std::span<std::int32_t> objects);

  /// All that can be drawn, at once. Throws as RenderObjects if objects are wanted.
  virtual void Draw(std::span<const CameraPose> cameras, const PictureMemory& out) = 0;

 protected:
  Renderer() = default;
};

/// A scene prepared for one backend: geometry, acceleration structure, textures. Immutable; threads
/// share it and each make their own renderers, which must not outlive it.
class RenderScene {
 public:
  virtual ~RenderScene() = default;
  RenderScene(const RenderScene&) = delete;
  RenderScene& operator=(const RenderScene&) = delete;
  RenderScene(RenderScene&&) = delete;
  RenderScene& operator=(RenderScene&&) = delete;

  virtual Backend backend() const = 0;
  /// What draws: "Embree 3, AVX-512" or the GL_RENDERER string.
  virtual std::string description() const = 0;
  /// Whether it is known what its triangles belong to.
  virtual bool has_objects() const = 0;
  /// Whether any of its triangles is of glass or a mirror.
  virtual bool has_glass() const = 0;
  /// Throws Error on a bad spec, RenderError where the device cannot do it.
  virtual std::unique_ptr<Renderer> MakeRenderer(const CameraSpec& spec) const = 0;

 protected:
  RenderScene() = default;
};

/// kAuto takes EGL if it finds a hardware GPU and Embree otherwise. The mesh need not live on.
/// Throws RenderError if EGL is asked for and there is no usable device.
std::unique_ptr<const RenderScene> MakeRenderScene(const SceneMesh& mesh, Backend backend);

}  // namespace bulletnav::sim
