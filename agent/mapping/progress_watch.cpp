// SPDX-License-Identifier: MIT
#include "agent/mapping/progress_watch.h"

#include <algorithm>
#include <utility>

namespace bulletnav::agent {
namespace {

constexpr double kNews = 1.5;  // m2 of floor that count as progress

}  // namespace

void ProgressWatch::Forget(int target) {
  targets_.erase(target);
}

bool ProgressWatch::IsStuck(int target, double distance, double seen) {
  const bool is_resumed = std::exchange(last_, target) != target;
  const auto [found, is_new] = targets_.try_emplace(target, Target{distance, seen, 0});
  if (is_new) return false;
  // Meanwhile the body may have gone farther away; its steps back are steps towards the target.
  if (is_resumed) found->second.nearest = std::max(found->second.nearest, distance);
  if (distance <= found->second.nearest - least_) {
    found->second = {distance, seen, 0};
    return false;
  }
  if (seen >= found->second.seen + kNews) {
    found->second = {std::max(found->second.nearest, distance), seen, 0};
    return false;
  }
  if (++found->second.steps < patience_) return false;
  targets_.erase(found);
  return true;
}

}  // namespace bulletnav::agent
