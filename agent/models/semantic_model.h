// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "agent/models/model.h"
#include "agent/observation.h"

namespace bulletnav::agent {

/// Directions around a panorama: number i is centred at bearing 2 pi i / 12, radians
/// counter-clockwise from straight ahead.
inline constexpr int kDirections = 12;
inline constexpr double kNodeRadius = 3.0;       // metres: r of Neural Topological SLAM
inline constexpr double kFarthestScored = 20.0;  // metres: d_max, where a score reaches 0

/// What a model keeps of a panorama to compare it with others; its meaning is the model's.
using PanoramaCode = std::vector<float>;

/// What is said about an ordered pair of panoramas, source and goal.
struct PairPrediction {
  float same_node = 0.0f;                         // probability: the goal can be seen, within r
  std::array<float, kDirections> direction = {};  // probabilities of the goal's direction; sum 1
  float distance = 0.0f;                          // metres to the goal, if it is of the same node
  std::array<float, kDirections> score = {};  // 1 - geodesic / d_max to the goal by each direction
};

/// The four functions of Neural Topological SLAM, section 4, in the form of its multi-task model:
/// F_L is same_node, F_R direction and distance, F_S score, F_G Explorable. Deterministic; answers
/// for one panorama do not depend on what else is asked in the same call.
class SemanticModel : public virtual Model {
 public:
  static constexpr std::string_view kWhat = "semantic model";

  /// One code a panorama; done once for each observation and goal.
  virtual std::vector<PanoramaCode> Encode(std::span<const Panorama> panoramas) = 0;

  /// Probability for each direction that there is somewhere to go, 3 m away and farther.
  virtual std::array<float, kDirections> Explorable(const PanoramaCode& source) = 0;

  /// The goal as told from each of the sources.
  virtual std::vector<PairPrediction> Compare(std::span<const PanoramaCode* const> sources,
                                              const PanoramaCode& goal) = 0;
};

}  // namespace bulletnav::agent
