// SPDX-License-Identifier: MIT
#include "benchmark/report/webp.h"

#include <gtest/gtest.h>
#include <webp/demux.h>

namespace bulletnav::bench {
namespace {

sim::Image Filled(std::uint8_t red, std::uint8_t blue) {
  sim::Image image(24, 10, 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = red;
    image.pixels[i + 2] = blue;
  }
  return image;
}

TEST(AnimatedWebpTest, HoldsTheFramesWithTheirTimes) {
  const std::vector<AnimationFrame> frames = {
      {Filled(200, 0), 100}, {Filled(0, 200), 250}, {Filled(100, 100), 3000}};
  const std::vector<std::uint8_t> bytes = ToAnimatedWebp(frames, 80.0F);
  EXPECT_EQ(bytes, ToAnimatedWebp(frames, 80.0F));
  const WebPData data = {bytes.data(), bytes.size()};
  WebPAnimDecoderOptions options = {};
  ASSERT_NE(WebPAnimDecoderOptionsInit(&options), 0);
  options.color_mode = MODE_RGBA;
  WebPAnimDecoder* const decoder = WebPAnimDecoderNew(&data, &options);
  ASSERT_NE(decoder, nullptr);
  int time_ms = 0;
  std::vector<int> ends;
  for (const AnimationFrame& frame : frames) {
    std::uint8_t* pixels = nullptr;
    ASSERT_NE(WebPAnimDecoderGetNext(decoder, &pixels, &time_ms), 0);
    ends.push_back(time_ms);
    for (const std::size_t channel : {0u, 1u, 2u}) {
      EXPECT_NEAR(pixels[channel], frame.image.pixels[channel], 12);
    }
  }
  EXPECT_EQ(WebPAnimDecoderHasMoreFrames(decoder), 0);
  EXPECT_EQ(ends, std::vector<int>({100, 350, 3350}));
  WebPAnimDecoderDelete(decoder);
}

}  // namespace
}  // namespace bulletnav::bench
