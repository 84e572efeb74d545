// SPDX-License-Identifier: MIT
#include "agent/policy/exploration_view.h"

#include <algorithm>
#include <cmath>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kWindow = 2 * kExplorationSide;  // cells of the window's sides
constexpr int kWhole = 4 * kExplorationSide;   // and of the map's
constexpr int kObstacle = 1;
constexpr int kExplored = 2;
constexpr int kHere = 4;
constexpr int kBeen = 8;
constexpr int kWholeShift = 4;

/// Adds what is in a cell to the pixels that show it.
class Painter {
 public:
  Painter(const sim::Cell& low, std::span<std::uint8_t> view) : low_(low), view_(view) {}

  void Paint(const sim::Cell& cell, int what) {
    Add(cell.x / 4, cell.y / 4, what << kWholeShift);
    const int x = cell.x - low_.x;
    const int y = cell.y - low_.y;
    if (x >= 0 && y >= 0 && x < kWindow && y < kWindow) Add(x / 2, y / 2, what);
  }

 private:
  void Add(int x, int y, int what) {
    std::uint8_t& pixel =
        view_[static_cast<std::size_t>(y) * kExplorationSide + static_cast<std::size_t>(x)];
    pixel = static_cast<std::uint8_t>(pixel | what);
  }

  sim::Cell low_;
  std::span<std::uint8_t> view_;
};

}  // namespace

void RequireExplorationMap(const MapSpec& spec) {
  if (spec.cells() == kWhole && spec.cell == MapSpec{}.cell) return;
  throw sim::Error(
      "an exploration policy sees maps of 24 m with cells of 0.05 m; set size and "
      "cell of the navigator's map to these");
}

void WriteExplorationView(const MetricMap& map, const sim::PlanarPose& pose,
                          std::span<std::uint8_t> view) {
  BULLETNAV_CHECK_EQ(view.size(), kExplorationBytes);
  BULLETNAV_CHECK_EQ(map.states().size(), kWhole);
  std::fill(view.begin(), view.end(), std::uint8_t{0});
  const sim::Cell here = map.CellAt({pose.x, pose.y});
  Painter painter({here.x - kWindow / 2, here.y - kWindow / 2}, view);
  for (int y = 0; y < kWhole; ++y) {
    for (int x = 0; x < kWhole; ++x) {
      const sim::Cell cell{x, y};
      const int what = (map.IsObstacle(cell) ? kObstacle : 0) |
                       (map.IsExplored(cell) ? kExplored : 0) | (map.IsTrack(cell) ? kBeen : 0);
      if (what != 0) painter.Paint(cell, what);
    }
  }
  for (int i = 0; i < 9; ++i) {
    const sim::Cell cell{here.x + i % 3 - 1, here.y + i / 3 - 1};
    if (map.states().Contains(cell)) painter.Paint(cell, kHere);
  }
}

int HeadingBin(double yaw) {
  const double turned = sim::WrapAngle(yaw) + sim::kPi;
  return std::clamp(static_cast<int>(turned / (2.0 * sim::kPi) * kHeadings), 0, kHeadings - 1);
}

Point GoalAt(const MetricMap& map, const sim::PlanarPose& pose,
             const std::array<double, 2>& shares) {
  const sim::Cell here = map.CellAt({pose.x, pose.y});
  const auto along = [](int middle, double share) {
    const int cell = middle - kWindow / 2 + static_cast<int>(share * kWindow);
    return std::clamp(cell, 1, kWhole - 2);
  };
  return map.Centre({along(here.x, shares[0]), along(here.y, shares[1])});
}

}  // namespace bulletnav::agent
