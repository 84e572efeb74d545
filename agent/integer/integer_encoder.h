// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "agent/integer/integer_input.h"
#include "agent/integer/integer_trunk.h"
#include "agent/models/semantic_model.h"

namespace bulletnav::agent {

/// 16-bit values of layers that feed others lie within this, so that sums fit into 32 bits.
inline constexpr int kLargest16 = 4095;

/// What is seen by a model with twelve patches: the trunk's last stage, pooled, and two layers.
/// Layers "encoder.first" and "encoder.second", scales of their outputs' steps; the trunk after
/// "encoder.trunk.".
class IntegerEncoder {
 public:
  /// A code of a panorama: [kDirections, size] 16-bit numbers of real value code_scale a step.
  using Codes = std::vector<std::int16_t>;

  /// Throws Error if layers are missing or do not fit.
  IntegerEncoder(const QuantisedNet& net, int rows, bool uses_depth);

  int code_size() const { return second_.padded_outputs(); }
  /// Of one panorama each, all together [panoramas, kDirections, code_size].
  Codes Encode(std::span<const Panorama> panoramas);
  /// The same of what IntegerInput made of them: bytes [panoramas, rows, cols, kInputChannels].
  Codes EncodePictures(std::span<const std::uint8_t> pictures);

  void Use(const IntegerKernels& kernels);

 private:
  /// `fill(i, slot)` puts number i into the trunk's input.
  Codes EncodeAll(std::size_t count, const std::function<void(std::size_t, int)>& fill);
  void Pool(int picture, std::int16_t* features) const;

  IntegerInput input_;
  IntegerTrunk trunk_;
  DotLayer first_;
  DotLayer second_;
};

/// Real value of one step of pooled features, of one byte step of the trunk's end: sums over four
/// rows and shares of columns in 1/24.
inline constexpr double kPooledStep = 1.0 / (4 * 24);
inline constexpr int kLargestPooled = 255 * 4 * 24;

/// [kDirections][16] shares of the map's columns in each patch, in 1/24. Column j is centred at
/// pixel 32 j of 512, a patch is four columns wide.
const std::array<std::array<int, 16>, kDirections>& PoolingShares24();

}  // namespace bulletnav::agent
