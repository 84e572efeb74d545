// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "sim/math/pose.h"
#include "sim/sensors/noise/picture_noise.h"

namespace bulletnav::sim {
namespace {

constexpr int kRows = 128;
constexpr int kCols = 512;
constexpr double kColumn = 2.0 * kPi / kCols;

std::vector<float> Depth(const std::function<double(int row, int col)>& range) {
  std::vector<float> depth;
  for (int row = 0; row < kRows; ++row) {
    for (int col = 0; col < kCols; ++col) depth.push_back(static_cast<float>(range(row, col)));
  }
  return depth;
}

std::vector<float> Sphere(double range) {
  return Depth([=](int, int) {
    return range;
  });
}

PanoramaSpec FarSighted() {
  PanoramaSpec spec;
  spec.max_depth_m = 100.0f;
  return spec;
}

std::vector<float> Noisy(const DepthNoise& noise, std::vector<float> depth, int grey = -1,
                         int seed = 7) {
  std::vector<std::uint8_t> color;
  if (grey >= 0) color.assign(3 * depth.size(), static_cast<std::uint8_t>(grey));
  PictureNoise({noise, {}}, FarSighted())
      .Apply(Rng(static_cast<std::uint64_t>(seed), "depth"), color, depth);
  return depth;
}

double LostShare(const std::vector<float>& depth) {
  const auto lost = std::count(depth.begin(), depth.end(), 0.0f);
  return static_cast<double>(lost) / static_cast<double>(depth.size());
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

Moments Of(const std::vector<double>& values) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(values.size());
  return {sum / n, std::sqrt(std::max(0.0, squares / n - std::pow(sum / n, 2.0)))};
}

std::vector<double> Returns(const std::vector<float>& depth) {
  std::vector<double> returns;
  for (const float d : depth) {
    if (d > 0.0f) returns.push_back(d);
  }
  return returns;
}

TEST(DepthNoise, HasTheDeviationOfThePublishedModel) {
  const DepthNoise noise = NamedSensorNoise("depth_camera").depth;
  for (const double z : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    const std::vector<float> depth = Noisy(noise, Sphere(z));
    const double expected = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    const Moments found = Of(Returns(depth));
    EXPECT_EQ(LostShare(depth), 0.0) << z;
    EXPECT_NEAR(found.mean, z, 0.03 * expected + 0.001 * z) << z;
    EXPECT_NEAR(found.deviation, expected, 0.04 * expected) << z;
  }
}

TEST(DepthNoise, OfTwoCamerasGrowsWithTheSquareOfTheRange) {
  const DepthNoise noise = NamedSensorNoise("stereo_camera").depth;
  const double focal = 848.0 / 2.0 / std::tan(87.0 / 2.0 * kPi / 180.0);
  for (const double z : {1.0, 3.0, 6.0}) {
    const double expected = 0.08 * z * z / (focal * 0.05);
    EXPECT_NEAR(Of(Returns(Noisy(noise, Sphere(z)))).deviation, expected, 0.04 * expected) << z;
  }
}

TEST(DepthNoise, ReadsStepsOfDisparity) {
  const DepthNoise noise = NamedSensorNoise("depth_camera").depth;
  for (const double z : {1.0, 3.0, 5.0}) {
    std::vector<double> steps;
    for (const double d : Returns(Noisy(noise, Sphere(z)))) steps.push_back(351.3 / d);
    for (const double step : steps) EXPECT_NEAR(step, std::round(step), 1e-4 * step);
  }
  // 7 cm at five metres: Khoshelham and Elberink, Sensors 2012.
  std::vector<double> readings = Returns(Noisy(noise, Sphere(5.0)));
  std::sort(readings.begin(), readings.end());
  readings.erase(std::unique(readings.begin(), readings.end()), readings.end());
  const auto above = std::upper_bound(readings.begin(), readings.end(), 5.0);
  EXPECT_NEAR(*above - *(above - 1), 0.07, 0.004);
}

TEST(DepthNoise, GrowsOnSurfacesSeenAtAGrazingAngle) {
  DepthNoise noise;
  noise.axial_m = 0.001;
  noise.grazing_m = 0.001;
  const RayGrid grid{CameraSpec(FarSighted())};
  for (const double tangent : {0.5, 2.0, 4.0}) {
    const auto range = [&](int row) {
      return 2.0 * std::exp(tangent * std::atan(double{grid.y[static_cast<std::size_t>(row)]}));
    };
    const std::vector<float> depth = Noisy(noise, Depth([&](int row, int) {
                                             return range(row);
                                           }));
    const double theta = std::atan(tangent);
    const double ratio = theta / (kPi / 2.0 - theta);
    std::vector<double> errors;
    for (int row = 30; row < 98; ++row) {
      const double r = range(row);
      const double sigma = 0.001 + 0.001 / std::sqrt(r) * ratio * ratio;
      for (int col = 0; col < kCols; ++col) {
        errors.push_back((depth[static_cast<std::size_t>(row * kCols + col)] - r) / sigma);
      }
    }
    EXPECT_NEAR(Of(errors).mean, 0.0, 0.03) << tangent;
    EXPECT_NEAR(Of(errors).deviation, 1.0, 0.1) << tangent;
  }
}

TEST(DepthNoise, LosesWhatIsDarkOrFar) {
  DepthNoise noise;
  noise.min_signal = 0.003;
  for (const int grey : {20, 60, 120, 250}) {
    for (const double z : {0.7, 2.0, 4.0, 9.0}) {
      const double signal = std::pow(grey / 255.0, 2.0) / (z * z);
      const double expected = 1.0 - std::clamp(signal / 0.003 - 0.5, 0.0, 1.0);
      EXPECT_NEAR(LostShare(Noisy(noise, Sphere(z), grey)), expected, 0.01) << grey << " " << z;
    }
  }
}

TEST(DepthNoise, LosesWhatIsOutOfRange) {
  DepthNoise noise;
  noise.min_range_m = 0.5;
  noise.max_range_m = 6.0;
  EXPECT_EQ(LostShare(Noisy(noise, Sphere(0.45))), 1.0);
  EXPECT_EQ(Noisy(noise, Sphere(2.0)), Sphere(2.0));
  EXPECT_EQ(LostShare(Noisy(noise, Sphere(6.5))), 1.0);
  EXPECT_EQ(LostShare(Noisy(NamedSensorNoise("depth_camera").depth, Sphere(0.0))), 1.0);
}

TEST(DepthNoise, LosesWhatIsFlat) {
  DepthNoise noise;
  noise.max_angle_deg = 80.0;
  const RayGrid grid{CameraSpec(FarSighted())};
  for (const double theta_deg : {60.0, 78.0, 81.0, 88.0}) {
    const double theta = theta_deg * kPi / 180.0;
    const auto depth = Depth([&](int row, int) {
      return 2.0 *
             std::exp(std::tan(theta) * std::atan(double{grid.y[static_cast<std::size_t>(row)]}));
    });
    const std::vector<float> noisy = Noisy(noise, depth);
    const double expected =
        1.0 - std::clamp(std::cos(theta) / std::cos(80.0 * kPi / 180.0) - 0.5, 0.0, 1.0);
    EXPECT_NEAR(LostShare(noisy), expected, 0.06) << theta_deg;
  }
}

/// Of the middle row.
std::vector<int> LostColumns(const std::vector<float>& depth) {
  std::vector<int> lost;
  for (int col = 0; col < kCols; ++col) {
    if (depth[static_cast<std::size_t>(64 * kCols + col)] == 0.0f) lost.push_back(col);
  }
  return lost;
}

TEST(DepthNoise, NearThingsThrowShadowsToTheirLeft) {
  DepthNoise noise;
  noise.baseline_m = 0.075;
  for (const int first : {200, 3}) {
    const std::vector<float> depth = Noisy(noise, Depth([=](int, int col) {
                                             return col >= first && col < first + 100 ? 1.0 : 3.0;
                                           }));
    const std::vector<int> lost = LostColumns(depth);
    const double expected = 0.075 * (1.0 / 1.0 - 1.0 / 3.0) / kColumn;
    EXPECT_NEAR(static_cast<double>(lost.size()), expected, 1.0);
    for (const int col : lost) EXPECT_LE((first - 1 - col + kCols) % kCols, 5) << col;
  }
  EXPECT_TRUE(LostColumns(Noisy(noise, Sphere(2.0))).empty());
}

TEST(DepthNoise, RaysAtEdgesGoAstray) {
  DepthNoise noise;
  noise.lateral_rad = 0.2 * kColumn;
  const std::vector<float> before = Depth([](int, int col) {
    return col < 256 ? 2.0 : 4.0;
  });
  double astray = 0.0;
  for (int seed = 0; seed < 20; ++seed) {
    const std::vector<float> depth = Noisy(noise, before, -1, seed);
    for (int i = 60 * kCols; i < 68 * kCols; ++i) {
      const auto pixel = static_cast<std::size_t>(i);
      if (depth[pixel] == before[pixel]) continue;
      EXPECT_TRUE((i + 1) % 256 < 2) << i;
      EXPECT_EQ(depth[pixel], 6.0f - before[pixel]);
      astray += 1.0;
    }
  }
  // Half of those that go astray go to the other side of an edge; there are 4 a row.
  EXPECT_NEAR(astray / (4.0 * 8.0 * 20.0), 0.5 * 0.2 * std::sqrt(2.0 / kPi), 0.03);
}

TEST(DepthNoise, PanesGiveNoReturn) {
  DepthNoise noise;
  noise.panes = 2.0;
  const std::vector<float> depth = Noisy(noise, Sphere(2.0));
  EXPECT_GT(LostShare(depth), 0.001);
  EXPECT_LT(LostShare(depth), 0.25);
  for (const double d : Returns(depth)) EXPECT_EQ(d, 2.0);
}

}  // namespace
}  // namespace bulletnav::sim
