// SPDX-License-Identifier: MIT
#include "tests/support/grid_path.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace bulletnav::tests {
namespace {

struct Move {
  int dx;
  int dy;
};

std::vector<Move> Moves() {
  std::vector<Move> moves;
  for (int dx = -5; dx <= 5; ++dx) {
    for (int dy = -5; dy <= 5; ++dy) {
      if (std::gcd(dx, dy) == 1) moves.push_back({dx, dy});
    }
  }
  return moves;
}

}  // namespace

double GridPathLength(double width, double depth, double cell,
                      const std::function<bool(double, double)>& is_free, double from_x,
                      double from_y, double to_x, double to_y) {
  const int nx = static_cast<int>(width / cell) + 1;
  const int ny = static_cast<int>(depth / cell) + 1;
  std::vector<char> free(static_cast<std::size_t>(nx * ny));
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      free[static_cast<std::size_t>(y * nx + x)] = is_free(x * cell, y * cell) ? 1 : 0;
    }
  }
  const auto open = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < nx && y < ny && free[static_cast<std::size_t>(y * nx + x)] != 0;
  };
  const auto clear = [&](int x, int y, const Move& m) {
    const int steps = 2 * std::max(std::abs(m.dx), std::abs(m.dy));
    for (int i = 1; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      if (!open(static_cast<int>(std::lround(x + t * m.dx)),
                static_cast<int>(std::lround(y + t * m.dy)))) {
        return false;
      }
    }
    return true;
  };
  const auto index = [&](double x, double y) {
    return static_cast<int>(std::lround(y / cell)) * nx + static_cast<int>(std::lround(x / cell));
  };
  const int goal = index(to_x, to_y);
  std::vector<double> best(free.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>>
      queue;
  best[static_cast<std::size_t>(index(from_x, from_y))] = 0.0;
  queue.push({0.0, index(from_x, from_y)});
  const std::vector<Move> moves = Moves();
  while (!queue.empty()) {
    const auto [distance, at] = queue.top();
    queue.pop();
    if (at == goal) return distance;
    if (distance > best[static_cast<std::size_t>(at)]) continue;
    for (const Move& m : moves) {
      const int x = at % nx;
      const int y = at / nx;
      if (!clear(x, y, m)) continue;
      const int next = (y + m.dy) * nx + x + m.dx;
      const double longer = distance + cell * std::hypot(m.dx, m.dy);
      if (longer >= best[static_cast<std::size_t>(next)]) continue;
      best[static_cast<std::size_t>(next)] = longer;
      queue.push({longer, next});
    }
  }
  return -1.0;
}

}  // namespace bulletnav::tests
