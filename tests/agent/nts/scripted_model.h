// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>

#include "agent/mapping/metric_map.h"
#include "agent/models/semantic_model.h"
#include "agent/perception/relative_pose.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// Where a scripted panorama was taken.
inline PanoramaCode CodeAt(double x, double y, double yaw = 0.0) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(yaw)};
}

/// A world told by functions, in which a code says where its panorama was taken.
class ScriptedModel final : public SemanticModel {
 public:
  std::function<bool(const Point& from, const Point& to)> sees = [](const Point& a,
                                                                    const Point& b) {
    return Distance(a, b) <= kNodeRadius;
  };
  std::function<bool(const Point& from, double heading)> is_open = [](const Point& /*from*/,
                                                                      double /*heading*/) {
    return false;
  };
  std::function<double(const Point& from, double heading, const Point& goal)> score =
      [](const Point& from, double heading, const Point& goal) {
        const Point there{from.x + kNodeRadius * std::cos(heading),
                          from.y + kNodeRadius * std::sin(heading)};
        return std::max(0.0, 1.0 - Distance(there, goal) / kFarthestScored);
      };
  std::function<PanoramaCode(const Panorama&)> encode;
  int encoded = 0;   // panoramas
  int compared = 0;  // pairs

  std::vector<PanoramaCode> Encode(std::span<const Panorama> panoramas) override {
    std::vector<PanoramaCode> codes;
    for (const Panorama& panorama : panoramas) {
      codes.push_back(encode(panorama));
      ++encoded;
    }
    return codes;
  }

  std::array<float, kDirections> Explorable(const PanoramaCode& source) override {
    std::array<float, kDirections> open = {};
    for (std::size_t i = 0; i < open.size(); ++i) {
      open[i] = is_open(At(source), source[2] + BearingOf(static_cast<int>(i))) ? 0.9f : 0.1f;
    }
    return open;
  }

  std::vector<PairPrediction> Compare(std::span<const PanoramaCode* const> sources,
                                      const PanoramaCode& goal) override {
    std::vector<PairPrediction> predictions;
    for (const PanoramaCode* source : sources) predictions.push_back(ComparePair(*source, goal));
    compared += static_cast<int>(sources.size());
    return predictions;
  }

 private:
  static Point At(const PanoramaCode& code) { return {code[0], code[1]}; }

  PairPrediction ComparePair(const PanoramaCode& source, const PanoramaCode& goal) const {
    PairPrediction p;
    const Point from = At(source);
    const Point to = At(goal);
    p.same_node = sees(from, to) ? 0.97f : 0.1f;
    p.distance = static_cast<float>(Distance(from, to));
    const double bearing = std::atan2(to.y - from.y, to.x - from.x) - source[2];
    p.direction[static_cast<std::size_t>(DirectionOf(bearing))] = 1.0f;
    for (std::size_t i = 0; i < p.score.size(); ++i) {
      const double heading = source[2] + BearingOf(static_cast<int>(i));
      p.score[i] = static_cast<float>(score(from, heading, to));
    }
    return p;
  }
};

}  // namespace bulletnav::agent
