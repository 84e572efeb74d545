// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/torch.h"

namespace bulletnav::agent {

/// Torch works in the calling thread alone from now on. Its own pool would make small work slower,
/// sums depend on its size, and stall where processors are shared.
inline void StayInThisThread() {
  if (at::get_num_threads() != 1) at::set_num_threads(1);
}

}  // namespace bulletnav::agent
