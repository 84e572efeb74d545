// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/mapping/metric_map.h"

namespace bulletnav::agent {

/// How far it is to places that were asked about on the metric map, when they were: walls that F_G
/// and the graph know nothing of make ways long. In the agent's plane.
class KnownWays {
 public:
  void Clear() { ways_.clear(); }

  /// From `from` to `to` it is `length` metres. What was known of that place is forgotten.
  void Learn(const Point& from, const Point& to, double length);

  /// Metres from `from` to `to` at least; 0 if nothing is known of places near `to`.
  double Least(const Point& from, const Point& to) const;

 private:
  struct Way {
    Point from;
    Point to;
    double length = 0.0;
  };
  std::vector<Way> ways_;
};

}  // namespace bulletnav::agent
