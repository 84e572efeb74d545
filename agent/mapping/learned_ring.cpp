// SPDX-License-Identifier: MIT
#include "agent/mapping/learned_ring.h"

#include <algorithm>
#include <cmath>

#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

constexpr float kSeen = 0.5f;
constexpr float kObstacle = 0.5f;
constexpr float kFloor = 0.3f;  // an obstacle less probable than this: the floor is free

}  // namespace

LearnedRing::LearnedRing(std::shared_ptr<FreeSpaceModel> model, const MapSpec& spec)
    : ViewWindow(static_cast<int>(std::ceil(spec.vision / spec.cell)) + 1),
      model_(std::move(model)),
      vision_(std::min(spec.vision, FreeSpace::kReach)),
      cell_(spec.cell),
      obstacle_(static_cast<std::uint16_t>(spec.obstacle_points)) {
  BULLETNAV_CHECK(model_ != nullptr);
}

/// Asks for each cell of the window where its middle lies in the mapper's map. A line of cells as
/// wide as one of the window's stays a line without gaps, whatever the yaw.
void LearnedRing::Project(const Panorama& panorama, double x, double y, double yaw) {
  const FreeSpace space = model_->Predict(panorama);
  Clear();
  const double c = sim::Cos(yaw);
  const double s = sim::Sin(yaw);
  for (int row = 0; row < seen_.size(); ++row) {
    for (int col = 0; col < seen_.size(); ++col) {
      const double dx = (col + 0.5 - reach_ - x) * cell_;
      const double dy = (row + 0.5 - reach_ - y) * cell_;
      if (dx * dx + dy * dy > vision_ * vision_) continue;
      const auto told = FreeSpace::CellAt({c * dx + s * dy, c * dy - s * dx});
      if (told) Take(space, *told, {col, row});
    }
  }
}

void LearnedRing::Take(const FreeSpace& space, const sim::Cell& told, const sim::Cell& cell) {
  // Written so that what is no number is not seen.
  if (!(space.explored[told] >= kSeen)) return;
  seen_[cell] = 1;
  if (space.obstacle[told] >= kObstacle) obstacle_points_[cell] = obstacle_;
  if (space.obstacle[told] < kFloor) floor_points_[cell] = 1;
}

}  // namespace bulletnav::agent
