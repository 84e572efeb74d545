// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <utility>

#include "agent/perception/model_config.h"

namespace bulletnav::agent {

/// How a policy compares what it sees with its goal. kLate: both are coded alone, and the codes and
/// their products go on. kCorrelation: also each twelfth of one with each twelfth of the other, at
/// all turns, so that a place is known from another heading.
enum class Fusion { kLate, kCorrelation };

}  // namespace bulletnav::agent

template <>
struct bulletnav::sim::EnumNames<bulletnav::agent::Fusion> {
  static constexpr std::array kNames = {
      std::pair{"late", bulletnav::agent::Fusion::kLate},
      std::pair{"correlation", bulletnav::agent::Fusion::kCorrelation}};
};

namespace bulletnav::agent {

/// The key of a file's metadata that holds a policy's configuration as YAML.
inline constexpr const char* kPolicyKey = "policy";

/// The shape of a learned policy; goes with its weights. The paper leaves it open but for a
/// ResNet18 and a GRU (Neural Topological SLAM, section 5.1).
struct PolicyConfig {
  int width = 16;        // channels of the trunk's first stage; 64 is ResNet18
  int rows = 64;         // panoramas are averaged down to rows x 4 rows: 128, 64 or 32
  int features = 512;    // of what is seen, of the goal, and of both together
  int memory = 512;      // numbers of the GRU's state
  int step_limit = 500;  // steps of an episode: the policy is told how much of them is gone
  Fusion fusion = Fusion::kCorrelation;
  /// Its own encoder is trained with it; else it sees with a semantic model's, in integers.
  bool own_encoder = true;
  bool map = false;  // is shown its metric map, too (PolicyMap); needs depth
  Precision precision = Precision::kBfloat16;

  bool operator==(const PolicyConfig&) const = default;

  template <class V>
  void Visit(V& v) {
    v("width", width);
    v("rows", rows);
    v("features", features);
    v("memory", memory);
    v("step_limit", step_limit);
    v("fusion", fusion);
    v("own_encoder", own_encoder);
    v("map", map);
    v("precision", precision);
  }
  /// Throws Error.
  void Validate() const;

  /// The encoder of a semantic model that takes the same pictures through the same layers, without
  /// normalisation by batches.
  ModelConfig seeing() const;
};

}  // namespace bulletnav::agent
