// SPDX-License-Identifier: MIT
#pragma once
#include "sim/sensors/noise/kernels/noise_kernels.h"
#include "sim/sensors/noise/kernels/pixel_random.h"

namespace bulletnav::sim {
namespace {

inline float PixelAbs(float a) {
  return __builtin_fabsf(a);
}

/// (theta / (pi/2 - theta))^2 of tan(theta) >= 0. The arc tangent is within 0.005 radians.
inline float GrazingFactor(float tangent) {
  constexpr float kQuarterTurn = 1.5707964f;
  const float t = PixelMin(tangent, 50.0f);
  const bool is_steep = t > 1.0f;
  const float x = PixelMin(t, 1.0f) / PixelMax(t, 1.0f);
  const float arc = x / (1.0f + 0.28f * (x * x));
  const float rest = kQuarterTurn - arc;
  const float ratio = (is_steep ? rest : arc) / (is_steep ? arc : rest);
  return ratio * ratio;
}

/// Noise of a depth picture, row by row. Loops are short and free of branches, and write to memory
/// that nothing else points to, so that the compiler makes vectors of them.
class DepthRows {
 public:
  explicit DepthRows(const DepthNoiseFrame& frame) : frame_(frame) {}

  void Run() const {
    for (int row = 0; row < frame_.rows; ++row) {
      FindShadows(row);
      FindSlopes(row);
      if (frame_.color != nullptr && frame_.min_signal > 0.0f) {
        FindSurfaces<true>(row);
      } else {
        FindSurfaces<false>(row);
      }
      if (frame_.disparity > 0.0f) {
        Read<true>(row);
      } else {
        Read<false>(row);
      }
    }
  }

 private:
  static constexpr float kEdge = 0.1f;  // share of the range by which neighbours differ there

  int line_size() const { return frame_.cols + frame_.window + 1; }
  float* line(int number) const { return frame_.line + std::int64_t{number} * line_size(); }
  float* hidden() const { return line(0); }  // see FindShadows
  float* least() const { return line(1); }
  float* squared_slopes() const { return line(2); }
  float* surfaces() const { return line(3); }  // the range read of, 0: lost

  const float* Depth(int row) const {
    const int last = frame_.rows - 1;
    const int inside = row < 0 ? 0 : (row > last ? last : row);
    return frame_.depth + static_cast<std::int64_t>(inside) * frame_.stride + 1;
  }

  static std::uint32_t Place(int index) { return static_cast<std::uint32_t>(2 * index); }

  /// Seen from the partner, a ray's azimuth is less by baseline / distance. What is passed there
  /// by a ray from further right, is hidden. `hidden` becomes 1 there, and 0 elsewhere.
  void FindShadows(int row) const {
    const int size = line_size();
    const float* depth = Depth(row);
    const float* level = frame_.azimuth;
    const float shift = frame_.baseline * frame_.stretch[row];
    float* __restrict azimuth = hidden();
    for (int i = 0; i < frame_.cols; ++i) {
      const float d = depth[i];
      azimuth[i] = level[i] - (d > 0.0f ? shift / d : 0.0f);
    }
    for (int i = frame_.cols; i < size; ++i) {
      azimuth[i] = level[i] + (azimuth[i - frame_.cols] - level[i - frame_.cols]);
    }
    FindLeastOnTheRight(azimuth);
    const float* __restrict right = least();
    const float* across = frame_.across;
    for (int i = 0; i < frame_.cols; ++i) {
      azimuth[i] = (azimuth[i] - right[i]) * across[i] > 0.01f ? 1.0f : 0.0f;
    }
  }

  /// Of a window's values, those of the place itself left out.
  void FindLeastOnTheRight(const float* values) const {
    const int size = line_size();
    float* __restrict found = least();
    for (int i = 0; i + 1 < size; ++i) found[i] = values[i + 1];
    found[size - 1] = values[size - 1];
    for (int step = 1; step < frame_.window; step *= 2) {
      float* now = least();
      for (int i = 0; i + step < size; ++i) now[i] = PixelMin(now[i], now[i + step]);
    }
  }

  void FindSlopes(int row) const {
    const float* here = Depth(row);
    const float* above = Depth(row - 1);
    const float* below = Depth(row + 1);
    const float* across = frame_.across;
    const float stretch = frame_.stretch[row];
    const float upwards = frame_.upwards[row];
    float* __restrict slopes = squared_slopes();
    for (int i = 0; i < frame_.cols; ++i) {
      const float d = here[i];
      const float inverse = 1.0f / (d > 0.0f ? d : 1.0f);
      const float x = PixelMin(PixelAbs(d - here[i - 1]), PixelAbs(here[i + 1] - d));
      const float y = PixelMin(PixelAbs(d - above[i]), PixelAbs(below[i] - d));
      const float rise_x = x * inverse * across[i] * stretch;
      const float rise_y = y * inverse * upwards;
      slopes[i] = rise_x * rise_x + rise_y * rise_y;
    }
  }

  static float Albedo(const std::uint8_t* color, int first) {
    const auto sum =
        static_cast<std::int32_t>(2u * color[first] + 5u * color[first + 1] + color[first + 2]);
    const float luminance = static_cast<float>(sum) * (1.0f / (8.0f * 255.0f));
    return luminance * luminance;
  }

  template <bool kHasColor>
  void FindSurfaces(int row) const {
    const DepthNoiseFrame f = frame_;
    const float* here = Depth(row);
    const float* above = Depth(row - 1);
    const float* below = Depth(row + 1);
    const float* slopes = squared_slopes();
    const float* shadow = hidden();
    const std::uint8_t* color = kHasColor ? f.color + std::int64_t{3} * row * f.cols : nullptr;
    const float stretch = f.stretch[row];
    const float astray_y = f.lateral * f.upwards[row];
    float* __restrict seen = surfaces();
    for (int i = 0; i < f.cols; ++i) {
      const float d = here[i];
      const float cosine = 1.0f / __builtin_sqrtf(1.0f + slopes[i]);
      const std::uint32_t bits = PixelBits(Place(row * f.cols + i), f.key);
      const float limit = 0.5f + Share(bits & 0xFFFFu);
      const float albedo = kHasColor ? Albedo(color, 3 * i) : 0.25f;
      const float met = Neighbour({here[i - 1], here[i + 1], above[i], below[i]}, d,
                                  Share(bits >> 16), f.lateral * f.across[i] * stretch, astray_y);
      const bool is_lost = (d <= 0.0f) | (met < f.min_range) | (met >= f.max_range) |
                           (cosine < f.min_cos * limit) |
                           (albedo * cosine < f.min_signal * limit * (d * d)) | (shadow[i] > 0.0f);
      seen[i] = is_lost ? 0.0f : met;
    }
  }

  /// 16 bits as a number in [0, 1).
  static float Share(std::uint32_t bits) {
    return static_cast<float>(static_cast<std::int32_t>(bits)) * 0x1p-16f;
  }

  struct Around {
    float left;
    float right;
    float above;
    float below;
  };

  /// What a ray meets that goes astray, with `x` and `y` as the chances to go to either side.
  static float Neighbour(const Around& around, float d, float random, float x, float y) {
    float other = random < x + 0.5f * y ? around.above : around.below;
    other = random < x + y ? other : d;
    const float side = random < 0.5f * x ? around.left : around.right;
    other = random < x ? side : other;
    const bool is_edge = (PixelAbs(other - d) > kEdge * d) & (other > 0.0f);
    return is_edge ? other : d;
  }

  /// Readings of `surfaces`, with the steps as a part of the standard deviation.
  template <bool kSteps>
  void Read(int row) const {
    const DepthNoiseFrame f = frame_;
    const float* seen = surfaces();
    const float* slopes = squared_slopes();
    float* __restrict out = f.out + static_cast<std::int64_t>(row) * f.cols;
    for (int i = 0; i < f.cols; ++i) {
      const float r = PixelMax(seen[i], 0.01f);
      const float beyond = r - f.axial_from;
      const float grazing =
          f.grazing / __builtin_sqrtf(r) * GrazingFactor(__builtin_sqrtf(slopes[i]));
      const float sigma = f.axial + f.axial_per_m2 * (beyond * beyond) + grazing;
      const float normal = PixelNormal(PixelBits(Place(row * f.cols + i) + 1u, f.key));
      float read = r + sigma * normal;
      if constexpr (kSteps) {
        const float step = r * r / f.disparity;
        const float variance = PixelMax(0.0f, sigma * sigma - step * step * (1.0f / 12.0f));
        const float shaken = PixelMax(0.01f, r + __builtin_sqrtf(variance) * normal);
        const float steps = PixelMin(1e6f, f.disparity / shaken);
        const auto whole = PixelRound(PixelMax(1.0f, steps));
        read = f.disparity / static_cast<float>(whole);
      }
      // A product, as a choice would be made before the reckoning.
      const float is_read = seen[i] > 0.0f ? 1.0f : 0.0f;
      out[i] = is_read * PixelMin(PixelMax(0.01f, read), f.clip);
    }
  }

  const DepthNoiseFrame& frame_;
};

}  // namespace
}  // namespace bulletnav::sim
