// SPDX-License-Identifier: MIT
#include "sim/sensors/sensor_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/config/yaml_writer.h"
#include "sim/sensors/cameras.h"

namespace bulletnav::sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

SensorSet Parse(const std::string& text) {
  return SensorSet::Read(ParseYaml(text, "set.yaml"));
}

std::string WhyNot(const std::string& text) {
  try {
    Parse(text);
  } catch (const FileError& e) {
    return e.what();
  }
  return "taken";
}

std::vector<std::string> Names(const SensorSet& set) {
  std::vector<std::string> names;
  for (const ArraySpec& array : set.arrays()) names.push_back(array.name);
  return names;
}

TEST(SensorSet, RgbAndRgbdAreNamedSets) {
  EXPECT_THAT(Names(Parse("rgb")),
              ElementsAre("panorama.color", "odometry.motion", "bumper.collided"));
  const SensorSet rgbd = Parse("rgbd");
  EXPECT_THAT(Names(rgbd), ElementsAre("panorama.color", "panorama.depth", "odometry.motion",
                                       "bumper.collided"));
  EXPECT_EQ(rgbd.arrays()[0],
            (ArraySpec{"panorama.color", {128, 512, 3}, Element::kUint8, "display value"}));
  EXPECT_EQ(rgbd.arrays()[1], (ArraySpec{"panorama.depth", {128, 512}, Element::kFloat32, "m"}));
  EXPECT_EQ(rgbd.panorama()->cols, 512);
}

constexpr const char* kTwoCameras = R"(
front: {type: pinhole, hfov_deg: 79, rows: 24, cols: 32, pitch_deg: -15, mount: {forward_m: 0.1}}
ring: {type: panorama, rows: 16, cols: 64, channels: [depth]}
bumper: bumper
)";

TEST(SensorSet, TakesAnySensorsFromYaml) {
  const SensorSet set = Parse(kTwoCameras);
  EXPECT_THAT(Names(set),
              ElementsAre("front.color", "front.depth", "ring.depth", "bumper.collided"));
  EXPECT_EQ(set.arrays()[1].shape, (std::vector{24, 32}));
  EXPECT_DOUBLE_EQ(std::get<PinholeSpec>(*set.Find("front")->camera).pitch_deg, -15.0);
  EXPECT_FALSE(set.panorama().has_value());
  EXPECT_EQ(set.Find("back"), nullptr);
}

TEST(SensorSet, WritesItselfWithEveryDefaultAndReadsThatBack) {
  const std::string written = ToYaml(Parse(kTwoCameras));
  EXPECT_THAT(written, HasSubstr("yaw_deg: 0"));
  EXPECT_EQ(ToYaml(Parse(written)), written);
  EXPECT_EQ(Names(Parse(written)), Names(Parse(kTwoCameras)));
}

TEST(SensorSet, SaysWhereAnEntryIsWrong) {
  EXPECT_THAT(WhyNot("rgbx"), HasSubstr("set.yaml:1:1: unknown set of sensors 'rgbx'; known are: "
                                        "rgb, rgbd"));
  EXPECT_THAT(WhyNot("front: {type: pinhole, hfov: 79}"),
              HasSubstr("set.yaml:1:24: unknown key 'hfov'"));
  EXPECT_THAT(WhyNot("front: {type: lidar}"),
              HasSubstr("set.yaml:1:15: unknown type of sensor 'lidar'; known are: bumper, "
                        "odometry, panorama, pinhole"));
  EXPECT_THAT(WhyNot("front: {hfov_deg: 79}"), HasSubstr("a sensor needs a type"));
  EXPECT_THAT(WhyNot("front: {type: pinhole, hfov_deg: 200}"), HasSubstr("set.yaml:1:"));
  EXPECT_THAT(WhyNot("front: {type: pinhole, channels: [color, color]}"),
              HasSubstr("the channel color is given twice"));
  EXPECT_THAT(WhyNot("front: {type: pinhole, channels: [normals]}"),
              HasSubstr("known are: color, depth, semantic"));
  EXPECT_THAT(WhyNot("front: {type: pinhole, mount: {yaw_deg: .nan}}"), HasSubstr("finite"));
  EXPECT_THAT(WhyNot("Front camera: bumper"), HasSubstr("is no name for a sensor"));
  EXPECT_THAT(WhyNot("[rgb]"), HasSubstr("set.yaml:1:1"));
}

TEST(SensorSet, TwoSensorsHaveTwoNames) {
  SensorSet set = SensorSet::Named("rgb");
  EXPECT_THROW(set.Add("panorama", PinholeSensor({})), Error);
  EXPECT_THROW(set.Add("", PinholeSensor({})), Error);
  set.Add("front", PinholeSensor({}));
  EXPECT_EQ(set.sensors().size(), 4u);
}

}  // namespace
}  // namespace bulletnav::sim
