// SPDX-License-Identifier: MIT
#include "sim/navmesh/indoors.h"

#include <algorithm>
#include <array>

namespace bulletnav::sim {
namespace {

constexpr int kBarredWays = 11;        // of 16
constexpr float kLeastIndoors = 4.0f;  // m2
constexpr float kLeastShare = 0.01f;   // of all walkable area

struct Step {
  int x = 0;
  int y = 0;
};

/// A direction on the grid: to where a step leads, and what it passes on the way.
struct Way {
  Step step;
  std::vector<Step> passed;  // the step's end among them
};

std::vector<Way> Ways() {
  std::vector<Way> ways;
  for (const int sx : {-1, 1}) {
    ways.push_back({{sx, 0}, {{sx, 0}}});
    ways.push_back({{0, sx}, {{0, sx}}});
    for (const int sy : {-1, 1}) {
      ways.push_back({{sx, sy}, {{sx, sy}, {sx, 0}, {0, sy}}});
      ways.push_back({{2 * sx, sy}, {{2 * sx, sy}, {sx, 0}, {sx, sy}}});
      ways.push_back({{sx, 2 * sy}, {{sx, 2 * sy}, {0, sy}, {sx, sy}}});
    }
  }
  return ways;
}

/// Calls visit(column, span, lower spans that can be stood on) for each walkable span, in the order
/// of compact heightfields.
template <class Visit>
void ForEachWalkable(const rcHeightfield& heights, const Visit& visit) {
  const int columns = heights.width * heights.height;
  for (int column = 0; column < columns; ++column) {
    int below = 0;
    for (const rcSpan* span = heights.spans[column]; span != nullptr; span = span->next) {
      if (span->area != RC_NULL_AREA) visit(column, *span, below++);
    }
  }
}

/// How high whatever is in each column reaches.
std::vector<int> Tops(const rcHeightfield& heights) {
  const int columns = heights.width * heights.height;
  std::vector<int> tops(static_cast<std::size_t>(columns), 0);
  for (int column = 0; column < columns; ++column) {
    for (const rcSpan* span = heights.spans[column]; span != nullptr; span = span->next) {
      tops[static_cast<std::size_t>(column)] = static_cast<int>(span->smax);
    }
  }
  return tops;
}

/// The highest top on the way from each column out of the grid.
std::vector<int> HighestOnTheWay(const std::vector<int>& tops, int width, int height,
                                 const Way& way) {
  std::vector<int> highest(tops.size(), 0);
  const bool right = way.step.x > 0;
  const bool down = way.step.y > 0;
  const auto index = [width](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  };
  const auto is_inside = [&](int x, int y) {
    return x >= 0 && x < width && y >= 0 && y < height;
  };
  const auto higher = [&](int top, const std::vector<int>& of, int x, int y) {
    return is_inside(x, y) ? std::max(top, of[index(x, y)]) : top;
  };
  // From the far side back, so that where a step leads is known.
  for (int row = 0; row < height; ++row) {
    const int y = down ? height - 1 - row : row;
    for (int column = 0; column < width; ++column) {
      const int x = right ? width - 1 - column : column;
      int& top = highest[index(x, y)];
      for (const Step& p : way.passed) top = higher(top, tops, x + p.x, y + p.y);
      top = higher(top, highest, x + way.step.x, y + way.step.y);
    }
  }
  return highest;
}

void FindEnclosed(const rcHeightfield& heights, int body, std::vector<Surroundings>* all) {
  const std::vector<int> tops = Tops(heights);
  std::vector<int> barred(all->size(), 0);
  for (const Way& way : Ways()) {
    const std::vector<int> highest = HighestOnTheWay(tops, heights.width, heights.height, way);
    std::size_t i = 0;
    ForEachWalkable(heights, [&](int column, const rcSpan& span, int /*below*/) {
      const int eye = static_cast<int>(span.smax) + body;
      if (highest[static_cast<std::size_t>(column)] >= eye) ++barred[i];
      ++i;
    });
  }
  for (std::size_t i = 0; i < all->size(); ++i) (*all)[i].is_enclosed = barred[i] >= kBarredWays;
}

}  // namespace

std::vector<Surroundings> LookAround(const rcHeightfield& heights,
                                     const rcCompactHeightfield& compact) {
  std::vector<Surroundings> all;
  all.reserve(static_cast<std::size_t>(compact.spanCount));
  bool all_covered = true;
  ForEachWalkable(heights, [&](int /*column*/, const rcSpan& span, int below) {
    all.push_back({span.next != nullptr, below > 0, false});
    all_covered = all_covered && span.next != nullptr;
  });
  if (!all_covered) FindEnclosed(heights, compact.walkableHeight, &all);
  return all;
}

bool KeepIndoors(const std::vector<Surroundings>& surroundings, rcCompactHeightfield* compact) {
  const auto indoors =
      static_cast<float>(std::count_if(surroundings.begin(), surroundings.end(), [](const auto& s) {
        return s.is_indoors();
      }));
  const float area = indoors * compact->cs * compact->cs;
  if (area < kLeastIndoors || indoors < kLeastShare * static_cast<float>(surroundings.size())) {
    return false;
  }
  for (std::size_t i = 0; i < surroundings.size(); ++i) {
    if (!surroundings[i].is_indoors()) compact->areas[i] = RC_NULL_AREA;
  }
  return true;
}

}  // namespace bulletnav::sim
