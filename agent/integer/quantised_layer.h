// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

namespace bulletnav::agent {

/// Weights of a layer in integers: out = sum of scale[o] * weights[o, ...] * in + bias[o].
struct QuantisedLayer {
  int outputs = 0;
  int segments = 1;  // rows of a convolution's window; 1 for a fully connected layer
  int inputs = 0;    // values in a segment: columns of the window, channels within
  std::vector<std::int16_t> weights;  // [outputs, segments, inputs]
  std::vector<float> scale;           // [outputs], positive
  std::vector<float> bias;            // [outputs], in real units

  bool operator==(const QuantisedLayer&) const = default;
};

/// Inputs of a layer are bytes, and weights within kLargestWeight8; or both have 16 bits.
enum class LayerWidth { k8, k16 };

/// What the integers around a layer stand for.
struct LayerScales {
  double in = 1.0;    // real value of one step of the inputs
  int zero = 0;       // the input that stands for 0
  int largest = 255;  // of |input|
  double out = 1.0;   // real value of one fine step of the outputs
};

}  // namespace bulletnav::agent
