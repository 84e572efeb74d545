// SPDX-License-Identifier: MIT
// What depth cameras make of glass, on surfaces whose range and angle are known.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/pose.h"
#include "sim/sensors/noise/picture_noise.h"

namespace bulletnav::sim {
namespace {

constexpr std::size_t kRows = 128;
constexpr std::size_t kCols = 512;
constexpr std::size_t kPixels = kRows * kCols;
using Mask = std::vector<std::uint8_t>;

PanoramaSpec FarSighted() {
  PanoramaSpec spec;
  spec.max_depth_m = 100.0f;
  return spec;
}

DepthNoise GlassAlone(double lost, double behind) {
  DepthNoise noise;
  noise.glass_lost = lost;
  noise.glass_behind = behind;
  return noise;
}

/// Columns [100, 300) and around the seam, at heights in the middle.
Mask Panes() {
  Mask glass(kPixels);
  for (std::size_t row = 30; row < 100; ++row) {
    for (std::size_t col = 0; col < kCols; ++col) {
      const bool is_glass = (col >= 100 && col < 300) || col < 20 || col >= 500;
      glass[row * kCols + col] = is_glass ? 1 : 0;
    }
  }
  return glass;
}

std::vector<float> Noisy(const SensorNoise& noise, std::vector<float> depth, const Mask& glass,
                         int seed) {
  PictureNoise(noise, FarSighted())
      .Apply(Rng(static_cast<std::uint64_t>(seed), "glass"), {}, depth, glass);
  return depth;
}

std::vector<float> Sphere(float range) {
  return std::vector<float>(kPixels, range);
}

struct Shares {
  double lost = 0.0;    // of the glass
  double behind = 0.0;  // of the rest
};

/// Over many pictures; nothing else may change.
Shares Measured(const DepthNoise& noise, const std::vector<float>& depth, const Mask& glass) {
  double pixels = 0.0;
  double lost = 0.0;
  double behind = 0.0;
  for (int seed = 0; seed < 40; ++seed) {
    const std::vector<float> noisy = Noisy({noise, {}}, depth, glass, seed);
    for (std::size_t i = 0; i < kPixels; ++i) {
      if (glass[i] == 0) {
        EXPECT_EQ(noisy[i], depth[i]);
        continue;
      }
      pixels += 1.0;
      lost += noisy[i] == 0.0f ? 1.0 : 0.0;
      behind += noisy[i] > depth[i] ? 1.0 : 0.0;
      EXPECT_TRUE(noisy[i] == 0.0f || (noisy[i] >= depth[i] && noisy[i] <= 2.0f * depth[i]));
    }
  }
  return {lost / pixels, behind / (pixels - lost)};
}

TEST(GlassNoise, LosesItsShareOfThePanesAlone) {
  for (const double lost : {0.3, 0.75, 1.0}) {
    const Shares found = Measured(GlassAlone(lost, 0.0), Sphere(2.0f), Panes());
    EXPECT_NEAR(found.lost, lost, 0.03) << lost;
    if (lost == 1.0) continue;
    EXPECT_EQ(found.behind, 0.0);
  }
}

TEST(GlassNoise, ReadsItsShareFromBehind) {
  for (const double behind : {0.2, 0.6}) {
    const Shares found = Measured(GlassAlone(0.5, behind), Sphere(2.0f), Panes());
    EXPECT_NEAR(found.lost, 0.5, 0.03);
    EXPECT_NEAR(found.behind, behind, 0.03) << behind;
  }
}

TEST(GlassNoise, LosesMoreTheFlatterItIsSeen) {
  const RayGrid grid{CameraSpec(FarSighted())};
  for (const double theta_deg : {30.0, 60.0, 75.0}) {
    const double theta = theta_deg * kPi / 180.0;
    std::vector<float> depth;
    for (std::size_t i = 0; i < kPixels; ++i) {
      const double height = std::atan(double{grid.y[i / kCols]});
      depth.push_back(static_cast<float>(2.0 * std::exp(std::tan(theta) * height)));
    }
    const Shares found = Measured(GlassAlone(0.4, 0.0), depth, Panes());
    EXPECT_NEAR(found.lost, 1.0 - 0.6 * std::cos(theta), 0.03) << theta_deg;
  }
}

TEST(GlassNoise, HolesArePatches) {
  const Mask all(kPixels, 1);
  double unlike = 0.0;
  double pairs = 0.0;
  for (int seed = 0; seed < 10; ++seed) {
    const std::vector<float> noisy = Noisy({GlassAlone(0.5, 0.0), {}}, Sphere(2.0f), all, seed);
    for (std::size_t i = 0; i < kPixels; ++i) {
      const std::size_t right = i / kCols * kCols + (i + 1) % kCols;
      unlike += (noisy[i] == 0.0f) != (noisy[right] == 0.0f) ? 1.0 : 0.0;
      pairs += 1.0;
    }
  }
  EXPECT_LT(unlike / pairs, 0.15);  // pepper has 0.5
  EXPECT_GT(unlike / pairs, 0.02);
}

TEST(GlassNoise, IsTheSameForOneGeneratorAndOtherForAnother) {
  const SensorNoise noise = NamedSensorNoise("depth_camera");
  const Mask panes = Panes();
  const std::vector<float> first = Noisy(noise, Sphere(2.0f), panes, 1);
  EXPECT_EQ(first, Noisy(noise, Sphere(2.0f), panes, 1));
  EXPECT_NE(first, Noisy(noise, Sphere(2.0f), panes, 2));
  PictureNoise reused(noise, FarSighted());
  for (const int seed : {5, 1}) {
    std::vector<float> depth = Sphere(2.0f);
    reused.Apply(Rng(static_cast<std::uint64_t>(seed), "glass"), {}, depth, panes);
    EXPECT_EQ(depth == first, seed == 1);
  }
}

TEST(GlassNoise, WithoutGlassAndBesideItNothingChanges) {
  const Mask panes = Panes();
  for (const char* name : {"depth_camera", "stereo_camera"}) {
    const SensorNoise noise = NamedSensorNoise(name);
    SensorNoise blind = noise;
    blind.depth.glass_lost = 0.0;
    const std::vector<float> bare = Noisy(noise, Sphere(2.0f), {}, 3);
    EXPECT_EQ(Noisy(noise, Sphere(2.0f), Mask(kPixels), 3), bare);
    EXPECT_EQ(Noisy(blind, Sphere(2.0f), panes, 3), bare);
    const std::vector<float> glazed = Noisy(noise, Sphere(2.0f), panes, 3);
    // Of the rows without glass, and of the panes.
    constexpr std::size_t kAbove = 29 * kCols;
    EXPECT_TRUE(std::equal(glazed.begin(), glazed.begin() + kAbove, bare.begin()));
    std::size_t changed = 0;
    for (std::size_t i = 0; i < kPixels; ++i) {
      changed += panes[i] != 0 && glazed[i] != bare[i] ? 1 : 0;
    }
    EXPECT_GT(changed, 1000u);
  }
}

TEST(GlassNoise, WhatGivesNoReturnGivesNone) {
  const std::vector<float> depth = Noisy({GlassAlone(0.1, 1.0), {}}, Sphere(0.0f), Panes(), 1);
  EXPECT_EQ(depth, Sphere(0.0f));
}

TEST(GlassNoise, SharesAreShares) {
  EXPECT_THROW(GlassAlone(1.1, 0.0).Validate(), Error);
  EXPECT_THROW(GlassAlone(0.5, -0.1).Validate(), Error);
  SensorNoise noise;
  noise.depth = GlassAlone(0.6, 0.3);
  EXPECT_DOUBLE_EQ(Scaled(noise, 0.5).depth.glass_lost, 0.3);
  EXPECT_DOUBLE_EQ(Scaled(noise, 4.0).depth.glass_lost, 1.0);
  EXPECT_DOUBLE_EQ(Scaled(noise, 4.0).depth.glass_behind, 0.3);
}

}  // namespace
}  // namespace bulletnav::sim
