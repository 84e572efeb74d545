// SPDX-License-Identifier: MIT
#include "benchmark/cli/camera_options.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

sim::CameraSpec Parsed(const std::string& line) {
  CLI::App app;
  CameraOptions options;
  options.AddTo(&app);
  app.parse(line);
  return options.spec();
}

std::string ErrorOf(const std::string& line) {
  try {
    Parsed(line);
  } catch (const sim::Error& e) {
    return e.what();
  }
  return "";
}

TEST(CameraOptions, APanoramaIsTheDefault) {
  const auto spec = std::get<sim::PanoramaSpec>(Parsed(""));
  EXPECT_EQ(spec.cols, 512);
  EXPECT_EQ(spec.rows, 128);
  EXPECT_EQ(spec.projection, sim::Projection::kCylindrical);
  const auto strip = std::get<sim::PanoramaSpec>(Parsed("--projection cube_strip --size 256x32"));
  EXPECT_EQ(strip.projection, sim::Projection::kCubeStrip);
  EXPECT_EQ(strip.cols, 256);
  EXPECT_EQ(strip.rows, 32);
}

TEST(CameraOptions, APinholeHasAFieldOfViewAndAPitch) {
  const auto plain = std::get<sim::PinholeSpec>(Parsed("--projection pinhole"));
  EXPECT_EQ(plain.hfov_deg, 90.0);
  EXPECT_EQ(plain.pitch_deg, 0.0);
  EXPECT_EQ(plain.cols, 640);
  EXPECT_EQ(plain.rows, 480);
  const auto spec = std::get<sim::PinholeSpec>(
      Parsed("--projection pinhole --hfov 79 --pitch -30 --size 320x200"));
  EXPECT_EQ(spec.hfov_deg, 79.0);
  EXPECT_EQ(spec.pitch_deg, -30.0);
  EXPECT_EQ(spec.cols, 320);
  EXPECT_EQ(spec.rows, 200);
}

TEST(CameraOptions, WhatCannotBeDrawnIsRefusedByName) {
  EXPECT_THROW(Parsed("--projection fisheye"), CLI::ValidationError);
  EXPECT_NE(ErrorOf("--size 512").find("--size 512: is not WIDTHxHEIGHT"), std::string::npos);
  EXPECT_NE(ErrorOf("--size 5x5").find("--size 5x5: a panorama of 5x5"), std::string::npos);
  EXPECT_NE(ErrorOf("--hfov 90").find("give --projection pinhole"), std::string::npos);
  EXPECT_NE(ErrorOf("--projection pinhole --hfov 170").find("hfov_deg is 170"), std::string::npos);
  EXPECT_NE(ErrorOf("--projection pinhole --pitch 100").find("pitch_deg is 100"),
            std::string::npos);
}

}  // namespace
}  // namespace bulletnav::bench
