// SPDX-License-Identifier: MIT
#include "agent/nts/progress_watch.h"

namespace bulletnav::agent {

bool ProgressWatch::IsStuck(int target, double distance) {
  const auto [found, is_new] = targets_.try_emplace(target, Target{distance, 0});
  if (is_new) return false;
  if (distance <= found->second.nearest - least_) {
    found->second = {distance, 0};
    return false;
  }
  if (++found->second.steps < patience_) return false;
  targets_.erase(found);
  return true;
}

}  // namespace bulletnav::agent
