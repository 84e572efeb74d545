// SPDX-License-Identifier: MIT
// What is done to pictures and codes around the network.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/slam/descriptors/code_descriptor.h"
#include "agent/slam/descriptors/gem.h"
#include "agent/slam/descriptors/shrink_picture.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using Bytes = std::vector<std::uint8_t>;

Bytes RandomBytes(std::size_t count, std::uint64_t seed) {
  sim::Rng rng(seed, "bytes");
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng.Below(256));
  return bytes;
}

/// The mean over an area, by cutting each pixel into as many as there are cells.
Bytes ShrunkPlainly(const Bytes& rgb, int width, int height, int rows, int cols) {
  Bytes out;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      for (int channel = 0; channel < 3; ++channel) {
        double sum = 0.0;
        for (int y = row * height; y < (row + 1) * height; ++y) {
          for (int x = col * width; x < (col + 1) * width; ++x) {
            sum += rgb[static_cast<std::size_t>((y / rows * width + x / cols) * 3 + channel)];
          }
        }
        out.push_back(
            static_cast<std::uint8_t>(std::floor(sum * 254.0 / 255.0 / width / height + 0.5)));
      }
    }
  }
  return out;
}

TEST(ShrinkPicture, IsTheMeanOverAreas) {
  for (const auto& [width, height] : {std::pair{20, 15}, {16, 12}, {8, 6}, {11, 17}}) {
    const Bytes rgb = RandomBytes(static_cast<std::size_t>(width * height * 3), 1);
    EXPECT_EQ(ShrinkPicture(rgb, width, height, 6, 8), ShrunkPlainly(rgb, width, height, 6, 8))
        << width << " x " << height;
  }
}

TEST(ShrinkPicture, BlackIsZeroAndWhiteIs254) {
  EXPECT_THAT(ShrinkPicture(Bytes(320 * 240 * 3, 255), 320, 240, 96, 128), Each(254));
  EXPECT_THAT(ShrinkPicture(Bytes(320 * 240 * 3, 0), 320, 240, 96, 128), Each(0));
}

TEST(ShrinkPicture, RefusesWhatIsNoPicture) {
  EXPECT_THAT(
      [] {
        ShrinkPicture(Bytes(10), 4, 4, 6, 8);
      },
      ThrowsMessage<sim::Error>(HasSubstr("too small; give at least 8 x 6")));
  EXPECT_THAT(
      [] {
        ShrinkPicture(Bytes(10), 8, 6, 6, 8);
      },
      ThrowsMessage<sim::Error>(HasSubstr("cannot have 10 bytes")));
}

std::vector<std::int16_t> Pooled(double exponent, const Bytes& map, int channels) {
  std::vector<const std::uint8_t*> places;
  for (std::size_t i = 0; i < map.size(); i += static_cast<std::size_t>(channels)) {
    places.push_back(map.data() + i);
  }
  return Gem(exponent).Pool(places, channels);
}

TEST(Gem, IsTheGeneralisedMean) {
  const Bytes map = RandomBytes(48 * 5, 2);
  for (const double p : {1.0, 2.0, 3.0, 4.7, 8.0}) {
    const auto pooled = Pooled(p, map, 5);
    for (std::size_t channel = 0; channel < 5; ++channel) {
      double sum = 0.0;
      for (std::size_t i = channel; i < map.size(); i += 5) sum += std::pow(map[i], p);
      EXPECT_NEAR(pooled[channel] / 16.0, std::pow(sum / 48.0, 1.0 / p), 0.04) << p;
    }
  }
}

TEST(Gem, LiesBetweenTheMeanAndTheLargestAndDoesNotKnowOrder) {
  Bytes map = RandomBytes(30, 3);
  const auto pooled = Pooled(3.0, map, 1);
  EXPECT_GT(pooled[0], 16 * std::accumulate(map.begin(), map.end(), 0) / 30);
  EXPECT_LT(pooled[0], 16 * *std::max_element(map.begin(), map.end()));
  std::reverse(map.begin(), map.end());
  EXPECT_EQ(Pooled(3.0, map, 1), pooled);
  EXPECT_EQ(Pooled(3.0, Bytes(7, 255), 1)[0], Gem::kLargest);
  EXPECT_EQ(Pooled(3.0, Bytes(7, 0), 1)[0], 0);
}

TEST(Gem, RefusesOtherExponents) {
  EXPECT_THROW(Gem(0.5), sim::Error);
  EXPECT_THROW(Gem(9.0), sim::Error);
  EXPECT_THROW(Gem(std::nan("")), sim::Error);
}

std::vector<std::int16_t> Codes(std::uint64_t seed) {
  sim::Rng rng(seed, "codes");
  std::vector<std::int16_t> codes(12 * 128);
  for (std::int16_t& code : codes)
    code = static_cast<std::int16_t>(std::max(0, rng.Between(-2000, 4095)));
  return codes;
}

TEST(DescribeCodes, DoesNotDependOnTheHeading) {
  std::vector<std::int16_t> codes = Codes(4);
  const PictureDescriptor descriptor = DescribeCodes(codes, 128);
  EXPECT_NEAR(Cosine(descriptor, descriptor), 1.0, 1e-3);
  std::rotate(codes.begin(), codes.begin() + 128 * 5, codes.end());
  EXPECT_EQ(DescribeCodes(codes, 128), descriptor);
  EXPECT_LT(Cosine(DescribeCodes(Codes(5), 128), descriptor), 0.999);
}

TEST(Descriptor, CosineIsThatOfTheNumbers) {
  sim::Rng rng(6, "numbers");
  std::vector<std::int64_t> a(256);
  std::vector<std::int64_t> b(256);
  double aa = 0.0;
  double bb = 0.0;
  double ab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = rng.Between(-30000, 30000);
    b[i] = a[i] / 2 + rng.Between(-9000, 9000);
    aa += static_cast<double>(a[i] * a[i]);
    bb += static_cast<double>(b[i] * b[i]);
    ab += static_cast<double>(a[i] * b[i]);
  }
  const double expected = ab / std::sqrt(aa * bb);
  EXPECT_NEAR(Cosine(DirectionOf(a), DirectionOf(b)), expected, 1e-3);
  for (std::int64_t& number : a) number <<= 24;  // sums of very many
  EXPECT_NEAR(Cosine(DirectionOf(a), DirectionOf(b)), expected, 1e-3);
  EXPECT_EQ(DirectionOf(std::vector<std::int64_t>(4, 0)), PictureDescriptor(4, 0));
}

TEST(Descriptor, TheMeanOfEqualOnesIsThatOne) {
  const PictureDescriptor one = DescribeCodes(Codes(7), 128);
  const PictureDescriptor mean = MeanDirection(std::vector<PictureDescriptor>(9, one));
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(mean[i], one[i], 1);
}

}  // namespace
}  // namespace bulletnav::agent
