// SPDX-License-Identifier: MIT
#include "sim/navmesh/tops.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace bulletnav::sim {
namespace {

constexpr float kDropShare = 0.15f;   // of a top's border
constexpr float kLargestTop = 10.0f;  // m2
constexpr float kLargestTopShare = 0.25f;
constexpr float kLowDrop = 1.2f;  // metres; from a storey to the one below it is more
constexpr float kReach = 1.0f;    // metres from a top's border to the floor, chairs between them

/// Regions between which a body can walk.
struct Part {
  int cells = 0;
  int upstairs = 0;
  int roofs = 0;  // cells that are upstairs and uncovered
  int border = 0;
  std::map<int, int> drops;      // how much of the border drops to which other part
  std::map<int, int> low_drops;  // and by less than kLowDrop

  bool IsUpstairs() const { return 2 * upstairs >= cells; }
};

class Judge {
 public:
  Judge(const rcHeightfield& heights, const rcCompactHeightfield& compact,
        const std::vector<Surroundings>& surroundings)
      : heights_(heights),
        compact_(compact),
        surroundings_(surroundings),
        reach_(static_cast<int>(kReach / compact.cs)) {}

  std::vector<bool> Run() {
    Join();
    ForEachCell([&](int x, int y, int i) {
      Measure(x, y, i);
    });
    std::vector<bool> off(part_of_region_.size(), false);
    for (std::size_t region = 1; region < off.size(); ++region) {
      const Part& part = parts_[part_of_region_[region]];
      off[region] = IsRoof(part) || IsTop(part);
    }
    return off;
  }

 private:
  template <class Visit>
  void ForEachCell(const Visit& visit) const {
    for (int y = 0; y < compact_.height; ++y) {
      for (int x = 0; x < compact_.width; ++x) {
        const rcCompactCell& cell = compact_.cells[x + y * compact_.width];
        VisitColumn(x, y, cell, visit);
      }
    }
  }
  template <class Visit>
  void VisitColumn(int x, int y, const rcCompactCell& cell, const Visit& visit) const {
    const auto first = static_cast<int>(cell.index);
    for (int i = first; i < first + static_cast<int>(cell.count); ++i) {
      if (compact_.spans[i].reg != 0) visit(x, y, i);
    }
  }

  /// The span that a body gets to in a direction, -1 if none.
  int Neighbour(int x, int y, int i, int direction) const {
    const int connection = rcGetCon(compact_.spans[i], direction);
    if (connection == RC_NOT_CONNECTED) return -1;
    const int column =
        x + rcGetDirOffsetX(direction) + (y + rcGetDirOffsetY(direction)) * compact_.width;
    return static_cast<int>(compact_.cells[column].index) + connection;
  }

  int Root(int region) {
    while (part_of_region_[static_cast<std::size_t>(region)] != region) {
      int& up = part_of_region_[static_cast<std::size_t>(region)];
      up = part_of_region_[static_cast<std::size_t>(up)];
      region = up;
    }
    return region;
  }

  void Join() {
    part_of_region_.resize(std::size_t{compact_.maxRegions} + 1);
    std::iota(part_of_region_.begin(), part_of_region_.end(), 0);
    ForEachCell([&](int x, int y, int i) {
      for (int direction = 0; direction < 4; ++direction) {
        const int other = Neighbour(x, y, i, direction);
        if (other < 0 || compact_.spans[other].reg == 0) continue;
        const int from = Root(compact_.spans[i].reg);
        part_of_region_[static_cast<std::size_t>(from)] = Root(compact_.spans[other].reg);
      }
    });
    for (std::size_t region = 0; region < part_of_region_.size(); ++region) {
      part_of_region_[region] = Root(static_cast<int>(region));
    }
  }

  int PartOf(int span) const { return part_of_region_[compact_.spans[span].reg]; }

  void Measure(int x, int y, int i) {
    Part& part = parts_[PartOf(i)];
    const Surroundings& around = surroundings_[static_cast<std::size_t>(i)];
    ++part.cells;
    part.upstairs += around.is_upstairs ? 1 : 0;
    part.roofs += around.is_upstairs && !around.is_covered ? 1 : 0;
    for (int direction = 0; direction < 4; ++direction) {
      const int other = Neighbour(x, y, i, direction);
      if (other >= 0 && compact_.spans[other].reg != 0) continue;
      ++part.border;
      const int below = DropFrom(x, y, i, direction);
      if (below < 0 || PartOf(below) == PartOf(i)) continue;
      ++part.drops[PartOf(below)];
      const int drop = compact_.spans[i].y - compact_.spans[below].y;
      if (static_cast<float>(drop) * compact_.ch < kLowDrop) ++part.low_drops[PartOf(below)];
    }
  }

  /// The floor that is seen below from a span, out there in a direction, and that no wall parts
  /// from it; -1 if none.
  int DropFrom(int x, int y, int i, int direction) const {
    const int low = compact_.spans[i].y;
    for (int step = 0; step < reach_; ++step) {
      x += rcGetDirOffsetX(direction);
      y += rcGetDirOffsetY(direction);
      if (x < 0 || y < 0 || x >= compact_.width || y >= compact_.height) return -1;
      if (IsWall(x, y, low)) return -1;
      const int seen = HighestTop(x, y, low + compact_.walkableClimb);
      if (seen + compact_.walkableClimb >= low) continue;  // its own edge
      const rcCompactCell& cell = compact_.cells[x + y * compact_.width];
      const auto first = static_cast<int>(cell.index);
      for (int k = first; k < first + static_cast<int>(cell.count); ++k) {
        const rcCompactSpan& span = compact_.spans[k];
        if (span.reg != 0 && span.y == seen) return k;
      }
    }
    return -1;
  }

  /// Of what is solid in a column, the highest top up to a height; -1 if there is none.
  int HighestTop(int x, int y, int most) const {
    int highest = -1;
    for (const rcSpan* span = heights_.spans[x + y * heights_.width]; span != nullptr;
         span = span->next) {
      if (static_cast<int>(span->smax) <= most) highest = static_cast<int>(span->smax);
    }
    return highest;
  }

  /// Whether a column bars the way of a body that stands at a height.
  bool IsWall(int x, int y, int low) const {
    for (const rcSpan* span = heights_.spans[x + y * heights_.width]; span != nullptr;
         span = span->next) {
      const auto bottom = static_cast<int>(span->smin);
      const auto top = static_cast<int>(span->smax);
      if (top > low + compact_.walkableClimb && bottom < low + compact_.walkableHeight) return true;
    }
    return false;
  }

  static bool IsRoof(const Part& part) { return 2 * part.roofs >= part.cells; }

  bool IsTop(const Part& part) const {
    const float cell = compact_.cs * compact_.cs;
    // An upper storey is no top of the lower one, but has tops of its own.
    const bool is_upstairs = part.IsUpstairs();
    const std::map<int, int>& drops = is_upstairs ? part.low_drops : part.drops;
    return std::any_of(drops.begin(), drops.end(), [&](const auto& drop) {
      const Part& floor = parts_.at(drop.first);
      if (is_upstairs && !floor.IsUpstairs()) return false;
      const auto area = static_cast<float>(part.cells) * cell;
      const float largest =
          std::max(kLargestTop, kLargestTopShare * static_cast<float>(floor.cells) * cell);
      return part.cells < floor.cells && area <= largest &&
             static_cast<float>(drop.second) >= kDropShare * static_cast<float>(part.border);
    });
  }

  const rcHeightfield& heights_;
  const rcCompactHeightfield& compact_;
  const std::vector<Surroundings>& surroundings_;
  int reach_;
  std::vector<int> part_of_region_;
  std::map<int, Part> parts_;
};

}  // namespace

std::vector<bool> RegionsOffTheFloor(const rcHeightfield& heights,
                                     const rcCompactHeightfield& compact,
                                     const std::vector<Surroundings>& surroundings) {
  return Judge(heights, compact, surroundings).Run();
}

}  // namespace bulletnav::sim
