// SPDX-License-Identifier: MIT
#include "agent/mapping/visual_compass.h"

#include <cmath>

#include <gtest/gtest.h>

#include "agent/mapping/map_navigator.h"
#include "sim/math/rng.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::agent {
namespace {

using sim::DegToRad;

/// A room of 6 x 5 m with a pillar; the plane's origin is its middle.
class Room {
 public:
  Room() {
    sim::SceneMesh mesh = tests::BoxRoom(6, 2.6f, 5);
    tests::AddBox({4.5f, 0, -4}, {4.8f, 2.6f, -3.7f}, {9, 9, 9}, &mesh);
    scene_ = sim::MakeRenderScene(mesh, sim::Backend::kEmbree);
  }

  std::vector<std::uint8_t> Color(const sim::PlanarPose& pose,
                                  const sim::PanoramaSpec& spec = {}) const {
    const sim::BodyPose body = sim::Apply({{3, 0, -2.5}, 0.0}, pose);
    const Eigen::Vector3d eye = body.position + Eigen::Vector3d(0, 1.25, 0);
    return tests::RenderPanorama(*scene_, spec, {eye.cast<float>(), static_cast<float>(body.yaw)})
        .color;
  }

 private:
  std::unique_ptr<const sim::RenderScene> scene_;
};

/// Knows nothing of what surrounds the body.
class NothingSeen final : public FreeSpaceModel {
 public:
  FreeSpace Predict(const Panorama& /*panorama*/) override { return {}; }
};

TEST(VisualCompass, LearnsWhatAllTurnsToOneSideLack) {
  const Room room;
  sim::Rng rng(3, "compass");
  for (const auto projection : {sim::Projection::kCylindrical, sim::Projection::kEquirectangular}) {
    Rig rig;
    rig.panorama.projection = projection;
    VisualCompass compass(rig);
    sim::PlanarPose at;
    compass.Match({room.Color(at, rig.panorama), {}}, {});
    for (int i = 0; i < 60; ++i) {
      const double turned = DegToRad(rng.Uniform(8.0, 12.0) * (rng.Chance(0.5) ? 1.0 : -1.0));
      at = sim::Compose(at, {0.0, 0.0, turned});
      const double off = DegToRad(turned > 0.0 ? 0.6 : 0.3);  // both to the left
      const sim::PlanarPose odometry{0.01, -0.02, turned + off};
      const sim::PlanarPose found = compass.Match({room.Color(at, rig.panorama), {}}, odometry);
      EXPECT_EQ(found.x, odometry.x);
      EXPECT_EQ(found.y, odometry.y);
      if (i < 20) continue;
      EXPECT_NEAR(found.yaw, turned, DegToRad(0.25)) << i;
    }
  }
}

TEST(VisualCompass, WhereOdometryIsWorseThanSightSightCounts) {
  const Room room;
  sim::Rng rng(6, "compass");
  VisualCompass compass(Rig{});
  sim::PlanarPose at;
  compass.Match({room.Color(at), {}}, {});
  double seen = 0.0;
  double measured = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double turned = DegToRad(rng.Uniform(8.0, 12.0));
    const double off = DegToRad(rng.Uniform(-2.0, 2.0));
    at = sim::Compose(at, {0.0, 0.0, turned});
    const double yaw = compass.Match({room.Color(at), {}}, {0.0, 0.0, turned + off}).yaw;
    if (i < 20) continue;
    seen += (yaw - turned) * (yaw - turned);
    measured += off * off;
  }
  EXPECT_LT(seen, 0.2 * measured);
}

TEST(VisualCompass, ErrorsToOneSideAddUpToLittleThoughTheBodySlips) {
  const Room room;
  sim::Rng rng(4, "compass");
  VisualCompass compass(Rig{});
  sim::PlanarPose at;
  double off = 0.0;
  compass.Match({room.Color(at), {}}, {});
  for (int i = 0; i < 108; ++i) {
    const sim::PlanarPose step{0.0, 0.02, DegToRad(rng.Uniform(8.0, 12.0))};  // on a small circle
    at = sim::Compose(at, step);
    const sim::PlanarPose odometry{0.002, 0.04, step.yaw + DegToRad(0.2)};
    off += compass.Match({room.Color(at), {}}, odometry).yaw - step.yaw;
  }
  EXPECT_NEAR(off, 0.0, DegToRad(8.0)) << "21.6 degrees by the odometry";
}

TEST(VisualCompass, ExposureDoesNotMatter) {
  const Room room;
  VisualCompass compass(Rig{});
  std::vector<std::uint8_t> dark = room.Color({0.0, 0.0, DegToRad(-10.0)});
  for (std::uint8_t& value : dark) value = static_cast<std::uint8_t>(value / 2);
  compass.Match({room.Color({}), {}}, {});
  const double bright = [&] {
    VisualCompass other(Rig{});
    other.Match({room.Color({}), {}}, {});
    return other.Match({room.Color({0.0, 0.0, DegToRad(-10.0)}), {}}, {0, 0, DegToRad(-10.4)}).yaw;
  }();
  const double found = compass.Match({dark, {}}, {0.0, 0.0, DegToRad(-10.4)}).yaw;
  EXPECT_GT(found, DegToRad(-10.4));
  EXPECT_NEAR(found, bright, DegToRad(0.02));
}

TEST(VisualCompass, ElsewhereTheOdometryStays) {
  const Room room;
  const std::vector<std::uint8_t> blank(3 * sim::PanoramaSpec{}.pixels(), 0);
  const std::vector<std::uint8_t> one(blank.size(), 77);
  VisualCompass compass(Rig{});
  const auto stays = [&](const std::vector<std::uint8_t>& color, const sim::PlanarPose& odometry) {
    const sim::PlanarPose found = compass.Match({color, {}}, odometry);
    return found.x == odometry.x && found.y == odometry.y && found.yaw == odometry.yaw;
  };
  EXPECT_TRUE(stays(room.Color({}), {0.0, 0.0, 0.2})) << "nothing to compare with";
  EXPECT_TRUE(stays(room.Color({0.25, 0.0, 0.01}), {0.25, 0.0, 0.0})) << "a step forward";
  EXPECT_TRUE(stays(room.Color({0.25, 0.0, 0.01}), {0.0, 0.0, 0.0})) << "no motion";
  for (const auto& color : {blank, blank, one, one}) EXPECT_TRUE(stays(color, {0.0, 0.0, 0.2}));
  compass.Reset();
  EXPECT_TRUE(stays(room.Color({}), {0.0, 0.0, 0.2})) << "after Reset";
}

TEST(VisualCompass, PushesAndDarknessTeachNothing) {
  const Room room;
  VisualCompass compass(Rig{});
  sim::PlanarPose at;
  compass.Match({room.Color(at), {}}, {});
  for (int i = 0; i < 60; ++i) {  // each left turn is read as larger than it is
    at = sim::Compose(at, {0.0, 0.0, DegToRad(10.0)});
    compass.Match({room.Color(at), {}}, {0.0, 0.0, DegToRad(10.6)});
  }
  const double pushed = compass.Match({room.Color(at), {}}, {0.01, 0.0, DegToRad(0.3)}).yaw;
  EXPECT_EQ(pushed, DegToRad(0.3));
  const std::vector<std::uint8_t> dark(3 * sim::PanoramaSpec{}.pixels(), 0);
  std::vector<std::uint8_t> orange = dark;
  for (std::size_t i = 0; i < orange.size(); i += 3) orange[i] = 250;
  for (const auto& blank : {dark, dark, orange, orange}) {
    EXPECT_EQ(compass.Match({blank, {}}, {0.0, 0.0, DegToRad(10.6)}).yaw, DegToRad(10.6));
  }
}

TEST(VisualCompass, OfTwoPicturesThatAreNotAlikeItTakesLittle) {
  const Room room;
  sim::Rng rng(5, "compass");
  std::vector<std::uint8_t> noise(3 * sim::PanoramaSpec{}.pixels());
  for (std::uint8_t& value : noise) value = static_cast<std::uint8_t>(rng.Uniform(0.0, 255.0));
  VisualCompass compass(Rig{});
  compass.Match({room.Color({}), {}}, {});
  const double yaw = compass.Match({noise, {}}, {0.0, 0.0, 0.2}).yaw;
  EXPECT_NEAR(yaw, 0.2, DegToRad(4.0));
}

TEST(VisualCompass, ServesColoursInColumnsOfEqualAngles) {
  EXPECT_TRUE(VisualCompass::Serves(Rig{}));
  Rig blind;
  blind.has_color = false;
  EXPECT_FALSE(VisualCompass::Serves(blind));
  Rig strip;
  strip.panorama.projection = sim::Projection::kCubeStrip;
  EXPECT_FALSE(VisualCompass::Serves(strip));
  strip.has_depth = false;
  NavigatorSpec spec;
  EXPECT_NO_THROW(MapNavigator(strip, spec, std::make_shared<NothingSeen>()));
  spec.match_views = true;
  EXPECT_THROW(MapNavigator(strip, spec, std::make_shared<NothingSeen>()), sim::Error);
}

TEST(VisualCompass, ANavigatorWithoutDepthTurnsByIt) {
  const Room room;
  Rig rig;
  rig.has_depth = false;
  const auto yaw_after_turns = [&](bool match_views) {
    NavigatorSpec spec;
    spec.match_views = match_views;
    MapNavigator navigator(rig, spec, std::make_shared<NothingSeen>());
    navigator.Reset();
    sim::PlanarPose at;
    for (int i = 0; i <= 18; ++i) {
      const double turned = i > 0 ? DegToRad(10.0) : 0.0;
      const double off = i > 0 ? DegToRad(0.5) : 0.0;
      at = sim::Compose(at, {0.0, 0.0, turned});
      const std::vector<std::uint8_t> color = room.Color(at);
      navigator.Observe({{color, {}}, {0.0, 0.0, turned + off}, false, i});
    }
    return sim::WrapAngle(navigator.pose().yaw - DegToRad(180.0));
  };
  EXPECT_NEAR(yaw_after_turns(true), 0.0, DegToRad(4.0));
  EXPECT_NEAR(yaw_after_turns(false), DegToRad(9.0), 1e-9);
}

}  // namespace
}  // namespace bulletnav::agent
