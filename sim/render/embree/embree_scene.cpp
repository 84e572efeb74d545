// SPDX-License-Identifier: MIT
#include "sim/render/embree/embree_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "sim/base/check.h"
#include "sim/math/pose.h"
#include "sim/render/embree/bvh.h"
#include "sim/render/render_mesh.h"

namespace bulletnav::sim {
namespace {

constexpr int kFixedOne = 256;  // KernelGrid's fixed point
constexpr int kRounding = 2;    // of the float arithmetic around a table, in fixed point

/// Clockwise angle from behind, in turns, of a diamond-angle position in [0, 4].
double TurnsOfDiamond(double p) {
  const double q = p <= 1.0 ? -p : (p <= 3.0 ? p - 2.0 : 4.0 - p);
  const double sine = q;
  const double cosine = p > 1.0 && p < 3.0 ? 1.0 - std::abs(q) : std::abs(q) - 1.0;
  const double angle = std::atan2(sine, cosine);
  if (p <= 0.0) return 0.0;
  if (p >= 4.0) return 1.0;
  return angle / (2.0 * kPi) + 0.5;
}

/// Column position (0 at the left edge of the picture) of a heading.
double ColumnOfTurns(const PanoramaSpec& spec, double turns) {
  if (spec.projection != Projection::kCubeStrip) return turns * spec.cols;
  const double side = std::min(3.0, std::floor(turns * 4.0));
  const double off_centre = (turns * 4.0 - side - 0.5) * 0.5 * kPi;
  return (side + 0.5 + 0.5 * std::tan(off_centre)) * spec.cols / 4.0;
}

/// Row whose centre samples slope y.
double RowOfSlope(const PanoramaSpec& spec, double y) {
  const double from_top = spec.projection == Projection::kEquirectangular
                              ? 0.5 - std::atan(y) / kPi
                              : 0.5 - 0.5 * y;
  return std::clamp(from_top * spec.rows - 0.5, -1.0, static_cast<double>(spec.rows));
}

/// The least value of a monotonic function on each of `cells` cells, in fixed point, and how much
/// larger it can get within a cell.
struct Table {
  std::vector<std::int32_t> least;
  std::int32_t slack = 0;
};

template <class Function>
Table Tabulate(int cells, const Function& f) {
  Table table;
  double largest_step = 0.0;
  for (int i = 0; i <= cells; ++i) {
    const double a = f(static_cast<double>(i) / cells);
    const double b = f(static_cast<double>(std::min(i + 1, cells)) / cells);
    table.least.push_back(static_cast<std::int32_t>(std::floor(std::min(a, b) * kFixedOne)) -
                          kRounding);
    largest_step = std::max(largest_step, std::abs(b - a));
  }
  table.slack = static_cast<std::int32_t>(std::ceil(largest_step * kFixedOne)) + 2 * kRounding + 1;
  return table;
}

/// The sampling pattern in the kernels' form, with the arrays it points to.
class Grid {
 public:
  explicit Grid(const PanoramaSpec& spec) : rays_(spec) {
    const int column_cells = std::max(16384, 32 * spec.cols);
    const int row_cells = std::max(8192, 64 * spec.rows);
    columns_ = Tabulate(column_cells, [&](double p) {
      return ColumnOfTurns(spec, TurnsOfDiamond(4.0 * p));
    });
    rows_ = Tabulate(row_cells, [&](double p) {
      const double s = 2.0 * p - 1.0;
      return RowOfSlope(spec, s / std::max(1e-9, 1.0 - std::abs(s)));
    });
    for (const float y : rays_.y) y_squared_.push_back(y * y);
    kernel_ = {
        .rows = spec.rows,
        .cols = spec.cols,
        .stride = (spec.cols + kRowPadding - 1) / kRowPadding * kRowPadding,
        .tile_row_shift = TileShift(spec.rows, kTileRows, 2),
        .tile_column_shift = TileShift(spec.cols, kTileColumns, 4),
        .y = rays_.y.data(),
        .y_squared = y_squared_.data(),
        .area = rays_.area.data(),
        .xz_max = 1.0f,
        .max_depth = spec.max_depth_m,
        .column_of_angle = columns_.least.data(),
        .row_of_slope = rows_.least.data(),
        .angle_scale = static_cast<float>(column_cells) / 4.0f,
        .slope_scale = static_cast<float>(row_cells) / 2.0f,
        .column_slack = columns_.slack,
        .row_slack = rows_.slack,
    };
    for (std::size_t c = 0; c < rays_.x.size(); ++c) {
      kernel_.xz_max = std::max(kernel_.xz_max, std::hypot(rays_.x[c], rays_.z[c]));
    }
  }

  const RayGrid& rays() const { return rays_; }
  const KernelGrid& kernel() const { return kernel_; }

 private:
  /// The least shift, from `least` on, that fits `size` into `tiles`.
  static int TileShift(int size, int tiles, int least) {
    int shift = least;
    while (tiles << shift < size) ++shift;
    return shift;
  }

  RayGrid rays_;
  std::vector<float> y_squared_;
  Table columns_;
  Table rows_;
  KernelGrid kernel_{};
};

/// Geometry and shading, shared by all renderers of a scene.
struct EmbreeData {
  explicit EmbreeData(const SceneMesh& scene) : mesh(scene), bvh(mesh.corners) {
    mesh.corners.clear();
    mesh.corners.shrink_to_fit();
  }
  KernelScene kernel() const {
    return {bvh.nodes.data(), bvh.leaves.data(), mesh.shading.data(), mesh.textures.texels.data(),
            mesh.textures.infos.data()};
  }

  RenderMesh mesh;
  Bvh bvh;
};

class EmbreeRenderer final : public PanoramaRenderer {
 public:
  EmbreeRenderer(const EmbreeData& data, const Kernels& kernels, const PanoramaSpec& spec)
      : spec_(spec), scene_(data.kernel()), kernels_(kernels), grid_(spec) {
    const auto stride = static_cast<std::size_t>(grid_.kernel().stride);
    const std::size_t pixels = stride * static_cast<std::size_t>(spec.rows);
    x_.resize(stride);
    z_.resize(stride);
    xz_squared_.resize(stride);
    inverse_t_.resize(pixels);
    id_.resize(pixels);
    tile_farthest_.resize(std::size_t{kTileRows} * kTileColumns);
    dirty_.resize(kTileRows);
    entries_.resize(data.bvh.nodes.size() + data.bvh.leaves.size());
    buckets_.resize(kBuckets);
  }

  const PanoramaSpec& spec() const override { return spec_; }
  int preferred_batch() const override { return 1; }

  void Render(std::span<const CameraPose> cameras, std::span<std::uint8_t> color,
              std::span<float> depth) override {
    const std::size_t pixels = spec_.pixels();
    CHECK(color.empty() || color.size() == 3 * pixels * cameras.size());
    CHECK(depth.empty() || depth.size() == pixels * cameras.size());
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      RenderOne(cameras[i], color.empty() ? nullptr : &color[3 * pixels * i],
                depth.empty() ? nullptr : &depth[pixels * i]);
    }
  }

 private:
  void RenderOne(const CameraPose& camera, std::uint8_t* color, float* depth) {
    const KernelFrame frame = MakeFrame(camera);
    const KernelScratch scratch = {inverse_t_.data(), id_.data(),      tile_farthest_.data(),
                                   dirty_.data(),     entries_.data(), buckets_.data()};
    kernels_.find_visible(scene_, grid_.kernel(), frame, scratch);
    kernels_.shade(scene_, grid_.kernel(), frame, scratch, color, depth);
  }

  KernelFrame MakeFrame(const CameraPose& camera) {
    const float c = std::cos(camera.yaw);
    const float s = std::sin(camera.yaw);
    const RayGrid& rays = grid_.rays();
    for (std::size_t i = 0; i < rays.x.size(); ++i) {
      x_[i] = rays.x[i] * c + rays.z[i] * s;
      z_[i] = rays.z[i] * c - rays.x[i] * s;
      xz_squared_[i] = rays.x[i] * rays.x[i] + rays.z[i] * rays.z[i];
    }
    const Eigen::Vector3f& p = camera.position;
    return {{p.x(), p.y(), p.z()}, c, s, x_.data(), z_.data(), xz_squared_.data()};
  }

  PanoramaSpec spec_;
  KernelScene scene_;
  const Kernels& kernels_;
  Grid grid_;
  std::vector<float> x_;
  std::vector<float> z_;
  std::vector<float> xz_squared_;
  std::vector<float> inverse_t_;
  std::vector<std::int32_t> id_;
  std::vector<float> tile_farthest_;
  std::vector<std::uint32_t> dirty_;
  std::vector<QueueEntry> entries_;
  std::vector<std::int32_t> buckets_;
};

class EmbreeRenderScene final : public RenderScene {
 public:
  EmbreeRenderScene(const SceneMesh& mesh, const Kernels& kernels)
      : data_(mesh), kernels_(kernels) {}

  Backend backend() const override { return Backend::kEmbree; }
  std::string description() const override { return std::string("Embree 3, ") + kernels_.name; }
  std::unique_ptr<PanoramaRenderer> MakeRenderer(const PanoramaSpec& spec) const override {
    return std::make_unique<EmbreeRenderer>(data_, kernels_, spec);
  }

 private:
  EmbreeData data_;
  const Kernels& kernels_;
};

}  // namespace

std::vector<const Kernels*> SupportedKernels() {
  std::vector<const Kernels*> supported;
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
      __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0) {
    supported.push_back(&kKernelsAvx512);
  }
  if (__builtin_cpu_supports("avx2") != 0) supported.push_back(&kKernelsAvx2);
#endif
  supported.push_back(&kKernelsGeneric);
  return supported;
}

std::unique_ptr<const RenderScene> MakeEmbreeScene(const SceneMesh& mesh, const Kernels& kernels) {
  return std::make_unique<EmbreeRenderScene>(mesh, kernels);
}

}  // namespace bulletnav::sim
