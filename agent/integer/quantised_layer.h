// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <string>
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
  double kept = 0.0;  // of one step of what is added; 0: nothing is
};

/// A network in integers, as a file holds it: layers and scales of activations by name.
struct QuantisedNet {
  std::map<std::string, QuantisedLayer> layers;
  std::map<std::string, float> scales;

  bool operator==(const QuantisedNet&) const = default;
  /// Throw Error if there is none of this name; scales are positive.
  const QuantisedLayer& Layer(const std::string& name) const;
  float Scale(const std::string& name) const;
};

}  // namespace bulletnav::agent
