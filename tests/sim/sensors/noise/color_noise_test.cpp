// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/sensors/noise/picture_noise.h"

namespace bulletnav::sim {
namespace {

std::vector<std::uint8_t> Grey(int value) {
  return std::vector<std::uint8_t>(3 * PanoramaSpec().pixels(), static_cast<std::uint8_t>(value));
}

std::vector<std::uint8_t> Noisy(const ColorNoise& noise, std::vector<std::uint8_t> color,
                                int seed) {
  PictureNoise({{}, noise}, PanoramaSpec())
      .Apply(Rng(static_cast<std::uint64_t>(seed), "c"), color, {});
  return color;
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

/// Of light, the square of display values.
Moments OfLight(const std::vector<std::uint8_t>& color, std::size_t channel) {
  double sum = 0.0;
  double squares = 0.0;
  double n = 0.0;
  for (std::size_t i = channel; i < color.size(); i += 3) {
    const double light = std::pow(color[i] / 255.0, 2.0);
    sum += light;
    squares += light * light;
    n += 1.0;
  }
  return {sum / n, std::sqrt(std::max(0.0, squares / n - std::pow(sum / n, 2.0)))};
}

TEST(ColorNoise, HasTheVarianceOfShotsAndReading) {
  ColorNoise noise;
  noise.electrons = 300.0;
  noise.read_electrons = 5.0;
  for (const int value : {90, 130, 180, 220}) {
    const std::vector<std::uint8_t> color = Noisy(noise, Grey(value), 1);
    const double light = std::pow(value / 255.0, 2.0);
    const double expected = std::sqrt(light / 300.0 + std::pow(5.0 / 300.0, 2.0));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const Moments found = OfLight(color, channel);
      EXPECT_NEAR(found.mean, light, 0.01 * light + 0.001) << value;
      EXPECT_NEAR(found.deviation, expected, 0.03 * expected) << value;
    }
  }
}

TEST(ColorNoise, IsNotCorrelated) {
  ColorNoise noise;
  noise.electrons = 300.0;
  const std::vector<std::uint8_t> color = Noisy(noise, Grey(150), 2);
  const double mean = 150.0;
  for (const std::size_t lag : {1u, 3u, 3u * 512u, 3u * 512u * 7u}) {
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i + lag < color.size(); ++i) {
      product += (color[i] - mean) * (color[i + lag] - mean);
      square += (color[i] - mean) * (color[i] - mean);
    }
    EXPECT_NEAR(product / square, 0.0, 0.01) << lag;
  }
}

TEST(ColorNoise, BlursAPointByItsDeviation) {
  ColorNoise noise;
  noise.blur_px = 0.7;
  std::vector<std::uint8_t> color = Grey(0);
  const auto at = [](std::size_t row, std::size_t col) {
    return 3 * (row * 512 + col);
  };
  color[at(60, 511)] = 255;
  const std::vector<std::uint8_t> blurred = Noisy(noise, color, 3);
  double total = 0.0;
  double across = 0.0;
  double upwards = 0.0;
  for (int row = -2; row <= 2; ++row) {
    for (int col = -2; col <= 2; ++col) {
      const double share = blurred[at(static_cast<std::size_t>(60 + row),
                                      static_cast<std::size_t>((511 + col) % 512))];
      total += share;
      across += share * col * col;
      upwards += share * row * row;
    }
  }
  EXPECT_NEAR(total, 255.0, 4.0);
  EXPECT_NEAR(across / total, 0.49, 0.02);
  EXPECT_NEAR(upwards / total, 0.49, 0.02);
  EXPECT_EQ(blurred[at(60, 511) + 1], 0);
}

TEST(ColorNoise, ExposureIsOneForAPictureAndWhiteBalanceAFactorOfRedAndBlue) {
  ColorNoise noise;
  noise.exposure_stops = 1.0;
  noise.white_balance = 0.2;
  double least = 1e9;
  double most = 0.0;
  for (int seed = 0; seed < 40; ++seed) {
    const std::vector<std::uint8_t> color = Noisy(noise, Grey(100), seed);
    EXPECT_NEAR(OfLight(color, 1).deviation, 0.0, 1e-5);
    const double green = OfLight(color, 1).mean / std::pow(100.0 / 255.0, 2.0);
    EXPECT_GE(green, 0.49);
    EXPECT_LE(green, 2.02);
    least = std::min(least, green);
    most = std::max(most, green);
    for (const std::size_t channel : {0u, 2u}) {
      const double ratio = OfLight(color, channel).mean / OfLight(color, 1).mean;
      EXPECT_GT(ratio, 0.77);
      EXPECT_LT(ratio, 1.23);
    }
  }
  EXPECT_LT(least, 0.65);
  EXPECT_GT(most, 1.6);
}

TEST(ColorNoise, WhiteStaysWhite) {
  ColorNoise noise;
  noise.exposure_stops = 0.5;
  std::vector<std::uint8_t> brightest = Grey(0);
  for (int seed = 0; seed < 20; ++seed) {
    const std::vector<std::uint8_t> color = Noisy(noise, Grey(255), seed);
    EXPECT_LE(*std::max_element(color.begin(), color.end()), 255);
    if (color[0] > brightest[0]) brightest = color;
  }
  EXPECT_EQ(brightest, Grey(255));
}

}  // namespace
}  // namespace bulletnav::sim
