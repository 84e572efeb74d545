// SPDX-License-Identifier: MIT
#include "sim/sensors/noise/sensor_noise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"
#include "sim/sensors/noise/picture_noise.h"

namespace bulletnav::sim {
namespace {

struct Picture {
  std::vector<std::uint8_t> color;
  std::vector<float> depth;
  bool operator==(const Picture&) const = default;
};

/// Boxes of many colours at many ranges, and places without return.
Picture SomePicture(const CameraSpec& camera) {
  const PictureSize size = SizeOf(camera);
  Picture picture;
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const int box = (row / 5) * 7 + col / 9;
      const float range = box % 11 == 0 ? 0.0f : 0.3f + static_cast<float>(box * 37 % 100) * 0.1f;
      picture.depth.push_back(range + 0.01f * static_cast<float>(col % 9));
      for (int c = 0; c < 3; ++c) {
        picture.color.push_back(static_cast<std::uint8_t>((box * 53 + c * 31 + row) % 256));
      }
    }
  }
  return picture;
}

Picture Noisy(const std::string& name, const CameraSpec& camera, const Rng& rng,
              const NoiseKernels* kernels = nullptr) {
  Picture picture = SomePicture(camera);
  PictureNoise(NamedSensorNoise(name), camera, kernels).Apply(rng, picture.color, picture.depth);
  return picture;
}

std::vector<CameraSpec> SomeCameras() {
  PanoramaSpec odd;
  odd.rows = 9;
  odd.cols = 101;
  PanoramaSpec strip;
  strip.rows = 32;
  strip.cols = 64;
  strip.projection = Projection::kCubeStrip;
  PinholeSpec flat;
  flat.rows = 60;
  flat.cols = 83;
  flat.pitch_deg = -20.0;
  return {PanoramaSpec(), odd, strip, flat};
}

TEST(SensorNoise, IsFoundByName) {
  EXPECT_THAT(SensorNoiseNames(),
              testing::ElementsAre("none", "depth_camera", "phone_camera", "stereo_camera"));
  for (const std::string& name : SensorNoiseNames()) {
    EXPECT_EQ(NamedSensorNoise(name).is_none(), name == "none") << name;
    EXPECT_NO_THROW(NamedSensorNoise(name).Validate());
  }
  EXPECT_THROW(NamedSensorNoise("lidar"), Error);
  EXPECT_THROW(RequireSensorNoise("lidar"), KeyError);
  EXPECT_NO_THROW(RequireSensorNoise("none"));
}

TEST(SensorNoise, RefusesWhatNoSensorIs) {
  SensorNoise noise;
  noise.depth.axial_m = -1.0;
  EXPECT_THROW(noise.Validate(), Error);
  noise = {};
  noise.color.blur_px = 2.0;
  EXPECT_THROW(noise.Validate(), Error);
  noise = {};
  noise.depth.max_angle_deg = 0.0;
  EXPECT_THROW(PictureNoise(noise, PanoramaSpec()), Error);
}

TEST(SensorNoise, IsScaled) {
  const SensorNoise noise = NamedSensorNoise("depth_camera");
  EXPECT_EQ(Scaled(noise, 1.0), noise);
  EXPECT_TRUE(Scaled(noise, 0.0).is_none());
  const SensorNoise half = Scaled(noise, 0.5);
  EXPECT_DOUBLE_EQ(half.depth.axial_per_m2, 0.5 * noise.depth.axial_per_m2);
  EXPECT_DOUBLE_EQ(half.depth.disparity_m, 2.0 * noise.depth.disparity_m);
  EXPECT_DOUBLE_EQ(half.depth.max_range_m, noise.depth.max_range_m);
  EXPECT_DOUBLE_EQ(half.color.electrons, 4.0 * noise.color.electrons);
  for (const std::string& name : SensorNoiseNames()) {
    for (const double strength : {1e-9, 1e-3, 4.0}) {
      EXPECT_NO_THROW(Scaled(NamedSensorNoise(name), strength).Validate()) << name << strength;
    }
  }
}

TEST(PictureNoise, NoneLeavesTheBytes) {
  for (const CameraSpec& camera : SomeCameras()) {
    EXPECT_EQ(Noisy("none", camera, Rng(1, "a")), SomePicture(camera));
  }
}

TEST(PictureNoise, FollowsFromItsGenerator) {
  for (const CameraSpec& camera : SomeCameras()) {
    for (const char* name : {"depth_camera", "stereo_camera"}) {
      const Picture a = Noisy(name, camera, Rng(1, "a"));
      EXPECT_EQ(a, Noisy(name, camera, Rng(1, "a")));
      const Picture b = Noisy(name, camera, Rng(2, "a"));
      EXPECT_NE(a.color, b.color);
      EXPECT_NE(a.depth, b.depth);
    }
  }
}

TEST(PictureNoise, IsTheSameOnEveryProcessor) {
  for (const CameraSpec& camera : SomeCameras()) {
    for (const std::string& name : SensorNoiseNames()) {
      const Picture plain = Noisy(name, camera, Rng(3, "a"), &kNoiseKernelsGeneric);
      for (const NoiseKernels* kernels : SupportedNoiseKernels()) {
        EXPECT_EQ(Noisy(name, camera, Rng(3, "a"), kernels), plain) << kernels->name << name;
      }
    }
  }
}

TEST(PictureNoise, DoesNotDependOnWhatElseIsThere) {
  const PanoramaSpec camera;
  PictureNoise noise(NamedSensorNoise("depth_camera"), camera);
  Picture both = SomePicture(camera);
  Picture alone = both;
  noise.Apply(Rng(4, "a"), both.color, both.depth);
  noise.Apply(Rng(4, "a"), alone.color, {});
  EXPECT_EQ(both.color, alone.color);
  // Without colour, all is of the same albedo; what both read, they read alike.
  noise.Apply(Rng(4, "a"), {}, alone.depth);
  for (std::size_t i = 0; i < both.depth.size(); ++i) {
    if (both.depth[i] == 0.0f || alone.depth[i] == 0.0f) continue;
    EXPECT_EQ(both.depth[i], alone.depth[i]);
  }
}

}  // namespace
}  // namespace bulletnav::sim
