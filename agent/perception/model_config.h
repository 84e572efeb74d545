// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <utility>

#include "sim/config/enum_names.h"

namespace bulletnav::agent {

/// kPatches: twelve square crops of a panorama, each through the trunk, as in Neural Topological
/// SLAM. kPanorama: the trunk runs once over the whole panorama, whose ends meet, and the twelve
/// patches are pooled from its feature map: a third of the work. Ours.
enum class EncoderForm { kPanorama, kPatches };
/// kNone: colour alone. kChannel: depth is a fourth channel. kSeparate: depth has a trunk of its
/// own, joined after a 1x1 convolution, as in Neural Topological SLAM.
enum class DepthFusion { kNone, kChannel, kSeparate };
/// kBatch: by the batch in training, by running means after it. kFixed: by means and variances that
/// stay as they are, 0 and 1 if nothing else was loaded: a scale and a shift.
enum class Norm { kBatch, kFixed };
/// What the trunk computes in; all else is float32. Processors without bfloat16's instructions take
/// float32.
enum class Precision { kFloat32, kBfloat16 };

}  // namespace bulletnav::agent

template <>
struct bulletnav::sim::EnumNames<bulletnav::agent::EncoderForm> {
  static constexpr std::array kNames = {
      std::pair{"panorama", bulletnav::agent::EncoderForm::kPanorama},
      std::pair{"patches", bulletnav::agent::EncoderForm::kPatches}};
};
template <>
struct bulletnav::sim::EnumNames<bulletnav::agent::DepthFusion> {
  static constexpr std::array kNames = {
      std::pair{"none", bulletnav::agent::DepthFusion::kNone},
      std::pair{"channel", bulletnav::agent::DepthFusion::kChannel},
      std::pair{"separate", bulletnav::agent::DepthFusion::kSeparate}};
};
template <>
struct bulletnav::sim::EnumNames<bulletnav::agent::Precision> {
  static constexpr std::array kNames = {
      std::pair{"float32", bulletnav::agent::Precision::kFloat32},
      std::pair{"bfloat16", bulletnav::agent::Precision::kBfloat16}};
};

namespace bulletnav::agent {

inline constexpr int kPanoramaRows = 128;  // what models are given; columns are four times as many
inline constexpr int kPanoramaCols = 512;
inline constexpr int kCodeSize = 128;  // of a patch; Neural Topological SLAM, appendix A

/// The shape of the learned model; goes with its weights. Widths of layers that the paper leaves
/// open are ours, see heads.h.
struct ModelConfig {
  EncoderForm encoder = EncoderForm::kPanorama;
  DepthFusion depth = DepthFusion::kChannel;
  int width = 32;           // channels of the trunk's first stage; 64 is ResNet18
  int rows = 64;            // panoramas are averaged down to rows x 4 rows: 128, 64 or 32
  double dropout = 0.5;     // of the two layers after the trunk
  int pair_features = 128;  // of the layers that compare two panoramas
  Precision precision = Precision::kBfloat16;
  Norm norm = Norm::kBatch;  // not in files: the kind of model says it

  bool operator==(const ModelConfig&) const = default;
  bool uses_depth() const { return depth != DepthFusion::kNone; }
  int cols() const { return 4 * rows; }

  template <class V>
  void Visit(V& v) {
    v("encoder", encoder);
    v("depth", depth);
    v("width", width);
    v("rows", rows);
    v("dropout", dropout);
    v("pair_features", pair_features);
    v("precision", precision);
  }
  /// Throws Error.
  void Validate() const;
};

}  // namespace bulletnav::agent
