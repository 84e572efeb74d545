// SPDX-License-Identifier: MIT
#pragma once
// Kernels::shade. A vector of pixels at a time; neighbours mostly see the same triangle, so its
// record is read once for all lanes that do, and only the texels are gathered lane by lane. Where
// they see many, each lane reads a record of its own. Records and texels are all over memory: they
// are fetched while the vectors before are worked on.
#include "sim/render/kernels/kernels.h"
#include "sim/render/kernels/simd.h"
#include "sim/render/kernels/tilt.h"
#include "sim/render/kernels/triangle_shadings.h"

namespace bulletnav::sim {
namespace {

constexpr float kUnseen = 1e-6f;  // 1 / t beyond any scene

/// Interpolated attributes of a vector of pixels.
struct Fragment {
  FW u = {};
  FW v = {};
  FW color[3] = {};
  FW texels = {};  // texels of level 0 that a pixel covers
  IW first = {};   // TextureInfo
  IW log2_side = {};
};

using Bytes4 = std::uint8_t __attribute__((vector_size(4)));

/// Red, green, blue and what is above them.
inline F4 Channels(const std::uint32_t& packed) {
  return __builtin_convertvector(__builtin_convertvector(Load<Bytes4>(&packed), I4), F4);
}

inline FW Channel(UW packed, int c) {
  return ToFloat(reinterpret_cast<IW>((packed >> (8 * c)) & 255u));
}

inline FW Clamp(FW v, FW low, FW high) {
  return Min(Max(v, low), high);
}

/// Blends the attributes of one triangle into the lanes of `mask`.
inline void Interpolate(const TriangleShading& t, const TextureInfo& info, const FW (&point)[3],
                        FW footprint, float height, IW mask, Fragment* out) {
  const FW zero = {};
  const FW one = Splat<FW>(1.0f);
  const FW b1 =
      Clamp(point[0] * t.g1[0] + point[1] * t.g1[1] + point[2] * t.g1[2] + t.h1, zero, one);
  const FW b2 =
      Clamp(point[0] * t.g2[0] + point[1] * t.g2[1] + point[2] * t.g2[2] + t.h2, zero, one - b1);
  out->u = mask ? t.uv0[0] + b1 * t.duv1[0] + b2 * t.duv2[0] : out->u;
  out->v = mask ? t.uv0[1] + b1 * t.duv1[1] + b2 * t.duv2[1] : out->v;
  const F4 c0 = Channels(t.color[0]);
  const F4 dc1 = Channels(t.color[1]) - c0;
  const F4 dc2 = Channels(t.color[2]) - c0;
  for (int c = 0; c < 3; ++c) {
    out->color[c] = mask ? c0[c] + b1 * dc1[c] + b2 * dc2[c] : out->color[c];
  }
  out->texels = mask ? footprint * (t.texel_density / height) : out->texels;
  out->first = mask ? Splat<IW>(info.first) : out->first;
  out->log2_side = mask ? Splat<IW>(info.log2_side) : out->log2_side;
}

inline IW Floor(FW v) {
  const IW truncated = ToInt(v);
  return truncated + (ToFloat(truncated) > v);  // a true comparison is -1
}

/// Red and blue, or green and alpha, of a weighted texel, in 16 bits each.
inline HalfW Weighted(UW texel, int shift, UW weight) {
  const UW pair = (texel >> shift) & 0x00ff00ffu;
  return reinterpret_cast<HalfW>(pair) * reinterpret_cast<HalfW>(weight | weight << 16);
}

/// Where four texels of a vector of pixels are, and how much of the later ones counts, of 256.
struct TexelPlaces {
  IW at[4];  // of t00, t10, t01, t11 in KernelScene::texels
  UW wx;
  UW wy;
};

/// Of the nearest pyramid level.
inline TexelPlaces FindTexels(const Fragment& f) {
  const IW exponent = (reinterpret_cast<IW>(f.texels * 2.0f) >> 23) - 127;
  const IW level = Min(Max(exponent >> 1, IW{}), f.log2_side);
  const IW log2_side = f.log2_side - level;
  const IW side = Splat<IW>(1) << log2_side;
  const IW largest = Splat<IW>(1) << f.log2_side;
  const IW start = f.first + (4 * (largest * largest - side * side)) / 3;
  const FW side_f = ToFloat(side);
  const FW x = f.u * side_f - 0.5f;
  const FW y = f.v * side_f - 0.5f;
  const IW x_floor = Floor(x);
  const IW y_floor = Floor(y);
  const IW wrap = side - 1;
  const IW x0 = x_floor & wrap;
  const IW x1 = (x_floor + 1) & wrap;
  const IW row0 = start + ((y_floor & wrap) << log2_side);
  const IW row1 = start + (((y_floor + 1) & wrap) << log2_side);
  return {{row0 + x0, row0 + x1, row1 + x0, row1 + x1},
          reinterpret_cast<UW>(ToInt((x - ToFloat(x_floor)) * 256.0f)),
          reinterpret_cast<UW>(ToInt((y - ToFloat(y_floor)) * 256.0f))};
}

/// Has texels fetched from memory. Four pixels side by side mostly share a line of the cache.
inline void PrefetchTexels(const KernelScene& scene, const TexelPlaces& places) {
  for (int k = 0; k < 4; k += 2) {
    for (int i = 0; i < kWidth; i += 4) __builtin_prefetch(scene.texels + places.at[k][i]);
  }
}

/// Bilinear samples; `red_blue` holds R and B, `green` G.
struct Samples {
  UW red_blue;
  UW green;
};

inline Samples Sample(const KernelScene& scene, const TexelPlaces& places) {
  UW texels[4];
  for (int k = 0; k < 4; ++k) texels[k] = Gather(scene.texels, places.at[k]);
  const UW wx = places.wx;
  const UW wy = places.wy;
  const UW w11 = (wx * wy) >> 8;
  const UW w10 = wx - w11;
  const UW w01 = wy - w11;
  const UW w00 = 256u - wx - w01;
  HalfW sums[2];
  for (int i = 0; i < 2; ++i) {
    const int shift = 8 * i;
    sums[i] = Weighted(texels[0], shift, w00) + Weighted(texels[1], shift, w10) +
              Weighted(texels[2], shift, w01) + Weighted(texels[3], shift, w11);
  }
  return {reinterpret_cast<UW>(sums[0] >> 8), reinterpret_cast<UW>(sums[1] >> 8) & 0xffu};
}

class Shader {
 public:
  Shader(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
         const KernelHits& hits)
      : scene_(scene), grid_(grid), frame_(frame), hits_(hits) {}

  /// Texels of a vector come from memory while those of the one before are blended.
  void Run(std::uint8_t* color, float* depth) const {
    for (int r = 0; r < grid_.rows; ++r) {
      Seen before = {};
      for (int c = 0; c < grid_.cols; c += kWidth) {
        const FW inverse_t = Load<FW>(hits_.inverse_t + r * grid_.stride + c);
        const FW t = 1.0f / Max(inverse_t, Splat<FW>(kUnseen));
        const std::int64_t pixel = static_cast<std::int64_t>(r) * grid_.cols + c;
        if (depth != nullptr) WriteDepth(r, c, t, inverse_t, Lanes(c), depth + pixel);
        if (color == nullptr) continue;
        if (c + kWidth < grid_.cols) PrefetchRecords(r, c + kWidth);
        const Seen seen = Look(r, c, t);
        if (c > 0) WriteColor(before, kWidth, color + 3 * (pixel - kWidth));
        before = seen;
        if (c + kWidth >= grid_.cols) WriteColor(seen, Lanes(c), color + 3 * pixel);
      }
    }
  }

 private:
  /// What a vector of pixels sees, before its texels are read.
  struct Seen {
    FW color[3];
    TexelPlaces texels;
  };

  int Lanes(int column) const {
    return grid_.cols - column < kWidth ? grid_.cols - column : kWidth;
  }

  void WriteDepth(int row, int column, FW t, FW inverse_t, int lanes, float* out) const {
    const FW length = Sqrt(Load<FW>(frame_.xz_squared + column) + grid_.y_squared[row]);
    const FW range = Min(t * length, Splat<FW>(grid_.max_depth));
    const FW seen = inverse_t > kUnseen ? range : FW{};
    if (lanes == kWidth) {
      Store(out, seen);
    } else {
      for (int i = 0; i < lanes; ++i) out[i] = seen[i];
    }
  }

  /// Has the records of what a vector of pixels sees fetched from memory.
  void PrefetchRecords(int row, int column) const {
    const std::int32_t* ids = hits_.id + row * grid_.stride + column;
    const IW seen = Load<IW>(ids);
    std::uint32_t left = (Bits(seen != Rotated(seen)) | 1u) & Bits(seen >= 0);
    for (; left != 0; left &= left - 1) {
      const char* at = reinterpret_cast<const char*>(scene_.shading + ids[__builtin_ctz(left)]);
      __builtin_prefetch(at);
      __builtin_prefetch(at + 64);
    }
  }

  Seen Look(int row, int column, FW t) const {
    const IW ids = Load<IW>(hits_.id + row * grid_.stride + column);
    FW ray[3] = {Load<FW>(frame_.x + column), Splat<FW>(grid_.y[row]), Load<FW>(frame_.z + column)};
    MakeWorld(frame_, ray);
    const FW point[3] = {frame_.origin[0] + t * ray[0], frame_.origin[1] + t * ray[1],
                         frame_.origin[2] + t * ray[2]};
    const FW footprint = t * t * t * grid_.area[row];
    Fragment fragment;
    if (__builtin_popcount(Bits(ids != Rotated(ids))) > kManyTriangles) {
      InterpolateEach(ids, point, footprint, &fragment);
    } else {
      InterpolateRuns(ids, Bits(ids >= 0), point, footprint, &fragment);
    }
    const TexelPlaces texels = FindTexels(fragment);
    PrefetchTexels(scene_, texels);
    return {{fragment.color[0], fragment.color[1], fragment.color[2]}, texels};
  }

  void WriteColor(const Seen& seen, int lanes, std::uint8_t* out) const {
    const Samples samples = Sample(scene_, seen.texels);
    const UW red = Product(samples.red_blue & 0xffffu, seen.color[0]);
    const UW green = Product(samples.green, seen.color[1]);
    const UW blue = Product(samples.red_blue >> 16, seen.color[2]);
    WriteRgb(red | green << 8 | blue << 16, lanes, out);
  }

  static IW Rotated(IW v) {
#if defined(__AVX512F__)
    return __builtin_shufflevector(v, v, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0);
#elif defined(__AVX2__)
    return __builtin_shufflevector(v, v, 1, 2, 3, 4, 5, 6, 7, 0);
#else
    return __builtin_shufflevector(v, v, 1, 2, 3, 0);
#endif
  }

  /// One triangle after the other, for all lanes that see it.
  void InterpolateRuns(IW ids, std::uint32_t left, const FW (&point)[3], FW footprint,
                       Fragment* fragment) const {
    while (left != 0) {
      const std::int32_t id = ids[__builtin_ctz(left)];
      const IW mask = ids == id;
      left &= ~Bits(mask);
      const TriangleShading& triangle = scene_.shading[id];
      const float offset = triangle.plane - (triangle.normal[0] * frame_.origin[0] +
                                             triangle.normal[1] * frame_.origin[1] +
                                             triangle.normal[2] * frame_.origin[2]);
      const float height = offset < 0.0f ? -offset : offset;
      Interpolate(triangle, scene_.textures[triangle.texture], point, footprint,
                  height > kNearestPlane ? height : kNearestPlane, mask, fragment);
    }
  }

  /// A triangle of its own for each lane.
  void InterpolateEach(IW ids, const FW (&point)[3], FW footprint, Fragment* out) const {
    const IW mask = ids >= 0;
    const TriangleShadings t(scene_.shading, ids & mask);
    const FW zero = {};
    const FW one = Splat<FW>(1.0f);
    const FW offset = t.plane() - (t.normal(0) * frame_.origin[0] + t.normal(1) * frame_.origin[1] +
                                   t.normal(2) * frame_.origin[2]);
    const FW height = offset < 0.0f ? -offset : offset;
    const FW b1 =
        Clamp(point[0] * t.g1(0) + point[1] * t.g1(1) + point[2] * t.g1(2) + t.h1(), zero, one);
    const FW b2 = Clamp(point[0] * t.g2(0) + point[1] * t.g2(1) + point[2] * t.g2(2) + t.h2(), zero,
                        one - b1);
    out->u = mask ? t.uv0(0) + b1 * t.duv1(0) + b2 * t.duv2(0) : zero;
    out->v = mask ? t.uv0(1) + b1 * t.duv1(1) + b2 * t.duv2(1) : zero;
    for (int c = 0; c < 3; ++c) {
      const FW c0 = Channel(t.color(0), c);
      const FW value = c0 + b1 * (Channel(t.color(1), c) - c0) + b2 * (Channel(t.color(2), c) - c0);
      out->color[c] = mask ? value : zero;
    }
    out->texels =
        mask ? footprint * (t.texel_density() / Max(height, Splat<FW>(kNearestPlane))) : zero;
    const auto* infos = reinterpret_cast<const std::uint32_t*>(scene_.textures);
    const IW info = t.texture() * 2;
    out->first = mask & reinterpret_cast<IW>(Gather(infos, info));
    out->log2_side = mask & reinterpret_cast<IW>(Gather(infos, info + 1));
  }

  static UW Product(UW texel, FW color) {
    const FW product = ToFloat(reinterpret_cast<IW>(texel)) * color * (1.0f / 255.0f) + 0.5f;
    return reinterpret_cast<UW>(ToInt(product));
  }

  static void WriteRgb(UW rgb, int lanes, std::uint8_t* out) {
    using Bytes16 = std::uint8_t __attribute__((vector_size(16)));
    if (lanes == kWidth) {
      Bytes16 quads[kWidth / 4];
      std::memcpy(quads, &rgb, sizeof(rgb));
      for (int i = 0; i < kWidth / 4; ++i) {
        const Bytes16 packed = __builtin_shufflevector(quads[i], quads[i], 0, 1, 2, 4, 5, 6, 8, 9,
                                                       10, 12, 13, 14, 3, 7, 11, 15);
        std::memcpy(out + 12 * i, &packed, 12);
      }
      return;
    }
    for (int i = 0; i < lanes; ++i) {
      for (int c = 0; c < 3; ++c) out[3 * i + c] = static_cast<std::uint8_t>(rgb[i] >> (8 * c));
    }
  }

  static constexpr float kNearestPlane = 1e-6f;
  static constexpr int kManyTriangles = 3 * kWidth / 16;

  const KernelScene& scene_;
  const KernelGrid& grid_;
  const KernelFrame& frame_;
  const KernelHits& hits_;
};

}  // namespace
}  // namespace bulletnav::sim
