// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "agent/integer/aligned_vector.h"
#include "agent/integer/kernels/kernels.h"
#include "agent/integer/quantised_layer.h"

namespace bulletnav::agent {

/// What is added to the sums of a layer before they are rounded: 16-bit values of a scale of their
/// own (LayerScales), [outputs] from each pixel's offset on.
struct KeptValues {
  const std::int16_t* values = nullptr;   // null: nothing
  const std::int32_t* offsets = nullptr;  // [pixels] numbers
  const std::int16_t* values2 = nullptr;  // likewise; null: nothing
  const std::int32_t* offsets2 = nullptr;
};

/// Where results go: either may be null. Rows of outputs are padded to whole blocks.
struct LayerOutput {
  std::uint8_t* bytes = nullptr;  // negative values are 0
  const std::int32_t* byte_offsets = nullptr;
  std::int16_t* fine = nullptr;
  const std::int32_t* fine_offsets = nullptr;
  std::int32_t low = 0;  // of fine values: 0 is ReLU
  std::int32_t high = std::numeric_limits<std::int16_t>::max();
};

/// One layer with its weights packed for the kernels; see ScaleJob for how it rounds. Not for
/// several threads at once.
class DotLayer {
 public:
  /// Throws Error if weights or scales are of the wrong number or not usable: sums of the largest
  /// inputs must fit into 32 bits.
  DotLayer(const QuantisedLayer& layer, LayerWidth width, const LayerScales& scales);

  /// Whole blocks.
  int padded_outputs() const { return blocks_ * kOutputBlock; }

  /// `in` at `offsets`, both in bytes: a pixel's first segment; the others `segment_stride` bytes
  /// apart.
  struct Input {
    const void* in = nullptr;
    std::span<const std::int32_t> offsets;
    std::int32_t segment_stride = 0;
  };
  void Run(const Input& input, const KeptValues& kept, const LayerOutput& output);
  /// Of one input, to fine values in [low, high]; `out` gets padded_outputs() of them.
  void RunOne(const std::int16_t* in, std::int32_t low, std::int32_t high,
              std::vector<std::int16_t>* out);

  /// Instead of the fastest ones, for tests and measurements.
  void Use(const IntegerKernels& kernels) { kernels_ = &kernels; }

 private:
  void Pack(const QuantisedLayer& layer, LayerWidth width);
  void SetScales(const QuantisedLayer& layer, const LayerScales& scales);

  LayerWidth width_;
  int segments_;
  int steps_;  // words of a segment
  int blocks_;
  std::int32_t shift_;
  std::int32_t kept_factor_;
  AlignedVector<std::int32_t> weights_;
  std::vector<std::int32_t> bias_;
  std::vector<std::int32_t> factor_;
  AlignedVector<std::int32_t> sums_;  // of some pixels at a time
  const IntegerKernels* kernels_;
};

}  // namespace bulletnav::agent
