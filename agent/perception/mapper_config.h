// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/model_config.h"

namespace bulletnav::agent {

/// The shape of the learned mapper; goes with its weights. It sees colour alone.
struct MapperConfig {
  int width = 32;        // channels of the trunk's first stage; 64 is ResNet18
  int rows = 64;         // panoramas are averaged down to rows x 4 rows: 128, 64 or 32
  int features = 256;    // of a column, in the layers after the trunk
  double dropout = 0.2;  // of those layers
  Precision precision = Precision::kBfloat16;

  bool operator==(const MapperConfig&) const = default;

  template <class V>
  void Visit(V& v) {
    v("width", width);
    v("rows", rows);
    v("features", features);
    v("dropout", dropout);
    v("precision", precision);
  }
  /// Throws Error.
  void Validate() const;

  /// A model that takes the same pictures through the same trunk.
  ModelConfig seeing() const;
};

}  // namespace bulletnav::agent
