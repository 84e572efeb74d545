// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "agent/integer/dot_layer.h"
#include "agent/integer/pictures.h"

namespace bulletnav::agent {

/// MapBranch in integers of 16 bits: from bytes of PolicyMap to its features, the same on every
/// processor. Not for several threads at once.
class IntegerMap {
 public:
  /// Layers "map.first" and so on, with scales of the same names. Throws Error if some are missing
  /// or of another shape. `largest`: of all values.
  IntegerMap(const QuantisedNet& net, int largest);

  /// [features], positive, in steps of the scale "map.whole".
  std::span<const std::int16_t> Run(std::span<const std::uint8_t> bytes);

  void Use(const IntegerKernels& kernels);

 private:
  /// A picture of 16-bit values with a border, one for each crop, and the layer that reads it.
  struct Stage {
    PictureShape shape;
    std::vector<std::int16_t> values;
    DotLayer layer;
    std::vector<std::int32_t> in_offsets;   // bytes
    std::vector<std::int32_t> out_offsets;  // numbers, in the next stage
  };
  void AddStage(const QuantisedNet& net, const std::string& name, const PictureShape& out);
  void SetPlanes(std::span<const std::uint8_t> bytes);

  int largest_;
  double step_ = 1.0;  // of the values of the stage at hand
  PictureShape shape_;
  std::vector<Stage> stages_;
  std::vector<std::int16_t> ends_;
  DotLayer whole_;
  std::vector<std::int16_t> features_;
};

}  // namespace bulletnav::agent
