// SPDX-License-Identifier: MIT
#include "agent/slam/loops/frame_windows.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "agent/slam/loops/loop_detector.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

constexpr int kSize = 16;
constexpr int kFrames = 12;

DescriptorFrames RandomFrames() {
  LoopContext context;
  context.descriptor_size = kSize;
  DescriptorFrames frames("test", context);
  sim::Rng rng(1, "frames");
  for (int i = 0; i < kFrames; ++i) {
    std::vector<std::int64_t> values;
    for (int k = 0; k < kSize; ++k) values.push_back(rng.Below(2001) - 1000);
    const PictureDescriptor descriptor = DirectionOf(values);
    LoopFrame frame;
    frame.number = i;
    frame.descriptor = descriptor;
    frames.Add(frame);
  }
  return frames;
}

TEST(FrameWindows, AreTheBestOfAllPairsOfTheTwoWindows) {
  const DescriptorFrames frames = RandomFrames();
  for (const int radius : {0, 1, 2, 20}) {
    const FrameWindows windows(frames, radius);
    for (int a = 0; a < kFrames; ++a) {
      for (int b = 0; b < kFrames; ++b) {
        double best = -1.0;
        for (int i = std::max(0, a - radius); i <= std::min(kFrames - 1, a + radius); ++i) {
          for (int k = std::max(0, b - radius); k <= std::min(kFrames - 1, b + radius); ++k) {
            best = std::max(best, Cosine(frames.descriptor(i), frames.descriptor(k)));
          }
        }
        EXPECT_FLOAT_EQ(static_cast<float>(windows.Best(a, b)), static_cast<float>(best))
            << a << " " << b << " " << radius;
      }
    }
  }
}

}  // namespace
}  // namespace bulletnav::agent
