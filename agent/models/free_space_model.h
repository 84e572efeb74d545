// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string_view>

#include "agent/models/model.h"
#include "agent/observation.h"
#include "sim/grid/grid.h"

namespace bulletnav::agent {

/// What a mapper makes of a panorama: 128 x 128 cells of 5 cm in the frame of the body, x ahead and
/// y left. The body stands where the four middle cells meet; cells more than 3.2 m away hold
/// nothing of use. Source: Active Neural SLAM maps 64 x 64 cells ahead of the body; this is as far
/// in all directions, for the panorama, with as many cells as four such maps.
struct FreeSpace {
  static constexpr int kSide = 128;
  static constexpr double kCell = 0.05;  // metres
  static constexpr double kReach = 0.5 * kSide * kCell;

  sim::Grid<float> explored = sim::Grid<float>(kSide);  // probability that a cell is seen
  sim::Grid<float> obstacle = sim::Grid<float>(kSide);  // and that it is an obstacle, if it is seen

  /// A place in the body's plane: metres.
  struct Place {
    double x = 0.0;
    double y = 0.0;
  };
  static Place CentreOf(const sim::Cell& cell) {
    return {(cell.x + 0.5) * kCell - kReach, (cell.y + 0.5) * kCell - kReach};
  }
  /// None beyond kReach.
  static std::optional<sim::Cell> CellAt(const Place& place) {
    if (!(std::hypot(place.x, place.y) < kReach)) return std::nullopt;
    return sim::Cell{static_cast<int>((place.x + kReach) / kCell),
                     static_cast<int>((place.y + kReach) / kCell)};
  }
};

/// Tells from what a body senses where it can walk. Deterministic: the same panorama, the same map.
class FreeSpaceModel : public virtual Model {
 public:
  static constexpr std::string_view kWhat = "mapper";

  virtual FreeSpace Predict(const Panorama& panorama) = 0;
};

}  // namespace bulletnav::agent
