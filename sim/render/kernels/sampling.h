// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "sim/render/kernels/kernels.h"
#include "sim/render/renderer.h"

namespace bulletnav::sim {

/// A camera's sampling pattern in the kernels' form, with the memory it points to, and the
/// buffers that one renderer keeps from picture to picture. Not copyable: the kernels' structs
/// point into it.
class Sampling {
 public:
  /// Throws Error on a bad spec.
  explicit Sampling(const CameraSpec& spec);
  Sampling(const Sampling&) = delete;
  Sampling& operator=(const Sampling&) = delete;
  Sampling(Sampling&&) = delete;
  Sampling& operator=(Sampling&&) = delete;
  ~Sampling() = default;

  const CameraSpec& spec() const { return spec_; }
  const RayGrid& rays() const { return rays_; }
  const KernelGrid& grid() const { return grid_; }
  const KernelHits& hits() const { return hits_; }

  /// Turns the rays to the camera; the result is valid until the next call. Expects: a
  /// finite pose.
  KernelFrame Frame(const CameraPose& camera);

 private:
  /// The least value of a monotonic function on each cell of its range, in fixed point, and how
  /// much larger it can get within a cell.
  struct Table {
    std::vector<std::int32_t> least;
    std::int32_t slack = 0;
  };
  template <class Function>
  static Table Tabulate(int cells, const Function& f);
  template <class Places>
  void FillTables(const Places& places);
  void FillGrid();
  /// Half of the least step from pixel to pixel, as in KernelGrid.
  float HalfPixel() const;

  CameraSpec spec_;
  RayGrid rays_;
  std::vector<float> y_squared_;
  Table columns_;
  Table rows_;
  KernelGrid grid_{};
  std::vector<float> x_;
  std::vector<float> z_;
  std::vector<float> xz_squared_;
  std::vector<float> inverse_t_;
  std::vector<std::int32_t> id_;
  KernelHits hits_{};
};

/// A caller's request, checked, and its output cut into pictures. Throws Error if a pose is not
/// finite, or a span neither is empty nor fits.
class PictureSlices {
 public:
  PictureSlices(const CameraSpec& spec, std::span<const CameraPose> cameras,
                const PictureMemory& out);
  /// Null where that output is not wanted.
  std::uint8_t* color(std::size_t i) const {
    return color_.empty() ? nullptr : &color_[3 * pixels_ * i];
  }
  float* depth(std::size_t i) const { return depth_.empty() ? nullptr : &depth_[pixels_ * i]; }

  /// What the i-th picture shows, as far as it is wanted, from the hits of a sampling. `objects` of
  /// each triangle, or empty; `shading` of each triangle.
  void WriteSeen(std::size_t i, const Sampling& sampling, std::span<const std::uint32_t> objects,
                 std::span<const TriangleShading> shading) const;

 private:
  std::size_t pixels_;
  std::span<std::uint8_t> color_;
  std::span<float> depth_;
  std::span<std::int32_t> objects_;
  std::span<std::uint8_t> glass_;
};

}  // namespace bulletnav::sim
