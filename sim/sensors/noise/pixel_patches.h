// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bulletnav::sim {

/// A row of pixels, or a column of them.
struct PixelAxis {
  int pixels = 0;
  double pixel_rad = 0.0;  // angle from one to the next
  bool wraps = false;      // the first follows the last
};

/// Random numbers of pixels that change slowly from one to the next, for holes that are no pepper:
/// patches of some 9 degrees with edges of some 2 degrees. Source: ours.
class PixelPatches {
 public:
  PixelPatches(const PixelAxis& across, const PixelAxis& upwards);

  /// Draws those of the next picture. Cost: some thousand random numbers.
  void Draw(const std::array<std::uint32_t, 2>& key);
  /// Uniform in (0, 1), within 0.01; the same bits on every processor.
  float At(std::size_t row, std::size_t col) const;

 private:
  /// Where a pixel is between two nodes, with weights whose squares add up to 1.
  struct Place {
    std::uint32_t before = 0;
    std::uint32_t after = 0;
    float weight_before = 0.0f;
    float weight_after = 0.0f;
  };
  struct Side {
    std::vector<Place> places;  // of each pixel
    std::uint32_t nodes = 0;
  };
  struct Octave {
    Side across;
    Side upwards;
    float weight = 0.0f;
    std::vector<float> normals;  // [upwards.nodes, across.nodes]

    float At(std::size_t row, std::size_t col) const;
  };
  static Side SideOf(const PixelAxis& axis, double size_rad);

  std::array<Octave, 2> octaves_;
};

}  // namespace bulletnav::sim
