// SPDX-License-Identifier: MIT
#include "agent/nts/known_ways.h"

#include <algorithm>

namespace bulletnav::agent {
namespace {

constexpr double kSamePlace = 1.0;  // metres

}  // namespace

void KnownWays::Learn(const Point& from, const Point& to, double length) {
  std::erase_if(ways_, [&](const Way& way) {
    return Distance(way.to, to) <= kSamePlace;
  });
  ways_.push_back({from, to, length});
}

double KnownWays::Least(const Point& from, const Point& to) const {
  double least = 0.0;
  for (const Way& way : ways_) {
    const double off = Distance(way.to, to);
    if (off > kSamePlace) continue;
    least = std::max(least, way.length - Distance(way.from, from) - off);
  }
  return least;
}

}  // namespace bulletnav::agent
