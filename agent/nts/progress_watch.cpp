// SPDX-License-Identifier: MIT
#include "agent/nts/progress_watch.h"

namespace bulletnav::agent {

bool ProgressWatch::IsStuck(int target, double distance) {
  if (!is_on_ || target != target_ || distance <= best_ - least_) {
    is_on_ = true;
    target_ = target;
    best_ = distance;
    steps_ = 0;
    return false;
  }
  if (++steps_ < patience_) return false;
  Reset();
  return true;
}

}  // namespace bulletnav::agent
