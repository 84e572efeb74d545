// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/slam/loops/descriptor_frames.h"

namespace bulletnav::agent {

/// How alike the surroundings of two frames are: the best cosine of any two frames of which one
/// lies within `radius` frames of the one and one within as many of the other. Ours: what is known
/// of neighbours makes up for a view that shows little.
class FrameWindows {
 public:
  /// Of all frames of a drive. Cost: cosines of all pairs, which are kept, 4 bytes each. Expects:
  /// radius >= 0 (checked).
  FrameWindows(const DescriptorFrames& frames, int radius);

  double Best(int one, int other) const {
    return best_[static_cast<std::size_t>(one) * count_ + static_cast<std::size_t>(other)];
  }

 private:
  std::size_t count_;
  std::vector<float> best_;  // [frames, frames]
};

}  // namespace bulletnav::agent
