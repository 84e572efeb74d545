// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "sim/math/rng.h"
#include "sim/navmesh/navmesh.h"

namespace bulletnav::bench {

/// Places to go to, one after the other, without end: spread over the largest floor, each the
/// nearest to the one before on foot; then the same backwards; then at random.
class Route {
 public:
  /// From `start`, metres in the scene. The query must outlive the route.
  Route(const sim::NavmeshQuery& query, const Eigen::Vector3f& start, const sim::Rng& rng);

  Eigen::Vector3f Next();
  /// There, before it turns.
  const std::vector<Eigen::Vector3f>& places() const { return places_; }

 private:
  const sim::NavmeshQuery& query_;
  sim::Rng rng_;
  std::vector<Eigen::Vector3f> places_;
  std::size_t next_ = 0;
};

}  // namespace bulletnav::bench
