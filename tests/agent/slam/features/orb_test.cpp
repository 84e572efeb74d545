// SPDX-License-Identifier: MIT
#include "agent/slam/features/orb.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/slam/features/gftt.h"
#include "agent/slam/features/stereo.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kWidth = 200;
constexpr int kHeight = 150;

struct Picture {
  std::vector<std::uint8_t> rgb;
  std::uint8_t* at(int x, int y) { return &rgb[static_cast<std::size_t>(3 * (y * kWidth + x))]; }
};

/// Grey with rectangles of random colours, all moved by dx and dy.
Picture Rectangles(int dx, int dy) {
  Picture picture = {std::vector<std::uint8_t>(3 * kWidth * kHeight, 128)};
  sim::Rng rng(1, "rectangles");
  for (int i = 0; i < 250; ++i) {
    const int x0 = rng.Between(40, 140) + dx;
    const int y0 = rng.Between(40, 95) + dy;
    const int x1 = x0 + rng.Between(3, 8);
    const int y1 = y0 + rng.Between(3, 8);
    for (int channel = 0; channel < 3; ++channel) {
      const auto value = static_cast<std::uint8_t>(rng.Below(256));
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) picture.at(x, y)[channel] = value;
      }
    }
  }
  return picture;
}

OrbFeatures Find(const Picture& picture, const OrbSpec& spec = {}) {
  return FindOrb(picture.rgb, kWidth, kHeight, spec);
}

/// What moved is found again as far from where it was: of one level, so that all is by whole
/// pixels. Most nearest descriptors are those of the same corner.
TEST(FindOrb, FindsMovedCornersAgain) {
  constexpr int kDx = 6;
  constexpr int kDy = -4;
  const OrbSpec spec = {.features = 300, .levels = 1};
  const OrbFeatures before = Find(Rectangles(0, 0), spec);
  const OrbFeatures after = Find(Rectangles(kDx, kDy), spec);
  ASSERT_GT(before.corners.size(), 30u);
  ASSERT_EQ(before.corners.size(), before.descriptors.size());
  int right = 0;
  for (std::size_t i = 0; i < before.corners.size(); ++i) {
    const auto& all = after.descriptors;
    const auto nearest =
        std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
          return Distance(a, before.descriptors[i]) < Distance(b, before.descriptors[i]);
        });
    const Corner& corner = after.corners[static_cast<std::size_t>(nearest - all.begin())];
    const double off =
        std::hypot(corner.x - before.corners[i].x - kDx, corner.y - before.corners[i].y - kDy);
    right += off < 1.5 ? 1 : 0;
  }
  EXPECT_GE(right, static_cast<int>(0.9 * static_cast<double>(before.corners.size())));
}

TEST(FindOrb, IsTheSameEachTimeAndNoMoreThanAskedFor) {
  const Picture picture = Rectangles(0, 0);
  const OrbFeatures first = Find(picture, {.features = 40});
  const OrbFeatures second = Find(picture, {.features = 40});
  EXPECT_LE(first.corners.size(), 45u);  // OpenCV keeps those as good as the last
  EXPECT_EQ(first.descriptors, second.descriptors);
  ASSERT_EQ(first.corners.size(), second.corners.size());
  for (std::size_t i = 0; i < first.corners.size(); ++i) {
    EXPECT_EQ(first.corners[i].x, second.corners[i].x);
    EXPECT_EQ(first.corners[i].angle_deg, second.corners[i].angle_deg);
  }
}

TEST(FindOrb, FindsNothingInAPlainPicture) {
  const Picture plain = {std::vector<std::uint8_t>(3 * kWidth * kHeight, 90)};
  EXPECT_TRUE(Find(plain).corners.empty());
  EXPECT_TRUE(Find(plain).descriptors.empty());
}

TEST(FindOrb, TellsWhatIsWrong) {
  const Picture picture = Rectangles(0, 0);
  EXPECT_THAT(
      [&] {
        FindOrb(picture.rgb, kWidth + 1, kHeight, {});
      },
      ThrowsMessage<sim::Error>(HasSubstr("a picture of 201 x 150 cannot have 90000")));
  EXPECT_THAT(
      [&] {
        Find(picture, {.scale = 1.0});
      },
      ThrowsMessage<sim::Error>(HasSubstr("scale must be above 1")));
}

/// OpenCV would tell of it in its own words, or take what memory there is.
TEST(FindOrb, WhatAPictureCannotHaveIsRefused) {
  for (const OrbSpec& spec :
       {OrbSpec{.scale = 50.0}, OrbSpec{.levels = 60}, OrbSpec{.features = 2'000'000'000}}) {
    EXPECT_THAT(
        [&] {
          spec.Validate();
        },
        ThrowsMessage<sim::Error>(HasSubstr("at most")));
  }
  const Picture picture = Rectangles(0, 0);
  EXPECT_NO_THROW(Find(picture, {.levels = 20}));
  EXPECT_THAT(
      [&] {
        Find(picture, {.scale = 10.0, .levels = 4});
      },
      ThrowsMessage<sim::Error>(HasSubstr("too many for pictures of 200 x 150 pixels")));
  const std::vector<std::uint8_t> pixel(3);
  EXPECT_THAT(
      [&] {
        FindOrb(pixel, 1, 1, {});
      },
      ThrowsMessage<sim::Error>(HasSubstr("take larger pictures")));
}

/// Where OpenCV would read beyond the picture.
TEST(StereoDepth, NarrowPicturesAreRefused) {
  const StereoSpec spec = {.disparities = 16, .fx = 10.0, .baseline_m = 0.1};
  for (const int width : {1, 8, 15, 16}) {
    const std::vector<std::uint8_t> rgb(static_cast<std::size_t>(3 * 64 * width));
    EXPECT_THAT(
        [&] {
          StereoDepth(rgb, rgb, width, 64, spec);
        },
        ThrowsMessage<sim::Error>(HasSubstr("too narrow for stereo")));
  }
  const std::vector<std::uint8_t> rgb(std::size_t{3 * 64 * 17});
  EXPECT_EQ(StereoDepth(rgb, rgb, 17, 64, spec).size(), std::size_t{64 * 17});
}

/// Corners apart from each other, with descriptors of those that have enough around them.
TEST(FindGftt, FindsCornersApart) {
  const Picture picture = Rectangles(0, 0);
  const GfttSpec spec = {.features = 60};
  const OrbFeatures found = FindGftt(picture.rgb, kWidth, kHeight, spec);
  ASSERT_GT(found.corners.size(), 20u);
  EXPECT_LE(found.corners.size(), 60u);
  EXPECT_EQ(found.corners.size(), found.descriptors.size());
  for (std::size_t i = 0; i < found.corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Corner& a = found.corners[i];
      const Corner& b = found.corners[j];
      EXPECT_GE(std::hypot(a.x - b.x, a.y - b.y), spec.apart_px);
    }
  }
  EXPECT_EQ(FindGftt(picture.rgb, kWidth, kHeight, spec).descriptors, found.descriptors);
  GfttSpec bad;
  bad.quality = 0.0;
  EXPECT_THROW(FindGftt(picture.rgb, kWidth, kHeight, bad), sim::Error);
}

/// The same rectangles all around, begun at another column: corners are the same, moved along.
TEST(Orb, PanoramasHaveNoEnds) {
  const Picture picture = Rectangles(0, 0);
  constexpr int kTurn = 90;  // puts what was in the middle across the ends
  Picture turned = picture;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      std::copy_n(picture.rgb.begin() + 3 * (y * kWidth + x), 3,
                  turned.at((x + kTurn) % kWidth, y));
    }
  }
  OrbSpec spec;
  spec.levels = 1;
  spec.features = 5000;
  const OrbFeatures here = FindOrbAround(picture.rgb, kWidth, kHeight, spec);
  const OrbFeatures there = FindOrbAround(turned.rgb, kWidth, kHeight, spec);
  ASSERT_GT(here.corners.size(), 50u);
  ASSERT_EQ(here.corners.size(), here.descriptors.size());
  int found = 0;
  for (std::size_t i = 0; i < here.corners.size(); ++i) {
    for (std::size_t k = 0; k < there.corners.size(); ++k) {
      const float off = there.corners[k].x - here.corners[i].x - kTurn;
      if (std::abs(std::remainder(off, float{kWidth})) < 0.01f &&
          std::abs(there.corners[k].y - here.corners[i].y) < 0.01f &&
          Distance(there.descriptors[k], here.descriptors[i]) == 0) {
        ++found;
        break;
      }
    }
  }
  EXPECT_GT(found, 0.9 * static_cast<double>(here.corners.size()));
}

}  // namespace
}  // namespace bulletnav::agent
