// SPDX-License-Identifier: MIT
#include "agent/mapping/learned_ring.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "agent/mapping/map_navigator.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

struct Told {
  float explored = 0.0f;
  float obstacle = 0.0f;
};

/// Says of each place what it was told.
class HandMade final : public FreeSpaceModel {
 public:
  explicit HandMade(std::function<Told(const FreeSpace::Place&)> tell) : tell_(std::move(tell)) {}
  FreeSpace Predict(const Panorama& /*panorama*/) override {
    FreeSpace space;
    for (std::size_t i = 0; i < space.explored.values().size(); ++i) {
      const Told told = tell_(FreeSpace::CentreOf(space.explored.cell(i)));
      space.explored[i] = told.explored;
      space.obstacle[i] = told.obstacle;
    }
    return space;
  }

 private:
  std::function<Told(const FreeSpace::Place&)> tell_;
};

std::shared_ptr<HandMade> Make(std::function<Told(const FreeSpace::Place&)> tell) {
  return std::make_shared<HandMade>(std::move(tell));
}

/// Open floor with a post of 20 cm at a place of the body's plane.
std::shared_ptr<HandMade> PostAt(double x, double y) {
  return Make([=](const FreeSpace::Place& p) {
    return Told{1.0f, std::hypot(p.x - x, p.y - y) < 0.1 ? 1.0f : 0.0f};
  });
}

Rig ColorRig() {
  Rig rig;
  rig.has_depth = false;
  return rig;
}

TEST(LearnedRing, TurnsWhatTheMapperSaysByTheYaw) {
  for (const double bearing : {0.3, 1.4, -2.9, -1.2}) {
    for (const double yaw : {0.0, 0.8, 2.5, -1.7}) {
      LearnedRing ring(PostAt(2.0 * std::cos(bearing), 2.0 * std::sin(bearing)), {});
      ring.Project({}, 0.3, 0.9, yaw);
      double count = 0;
      double x = 0;
      double y = 0;
      for (int i = 0; i < ring.seen().size() * ring.seen().size(); ++i) {
        const sim::Cell cell = ring.seen().cell(static_cast<std::size_t>(i));
        if (ring.obstacle_points()[cell] < 2) continue;
        EXPECT_EQ(ring.floor_points()[cell], 0);
        EXPECT_EQ(ring.seen()[cell], 1);
        count += 1;
        x += (cell.x + 0.5 - ring.reach() - 0.3) * 0.05;
        y += (cell.y + 0.5 - ring.reach() - 0.9) * 0.05;
      }
      EXPECT_NEAR(count * 0.0025, sim::kPi * 0.01, 0.012);
      EXPECT_NEAR(x / count, 2.0 * std::cos(bearing + yaw), 0.03);
      EXPECT_NEAR(y / count, 2.0 * std::sin(bearing + yaw), 0.03);
    }
  }
}

TEST(LearnedRing, OnlyClearOpinionsCount) {
  const auto middle = [](const Told& told) {
    LearnedRing ring(Make([=](const FreeSpace::Place&) {
                       return told;
                     }),
                     {});
    ring.Project({}, 0.5, 0.5, 0.0);
    const sim::Cell cell{ring.reach() + 20, ring.reach() + 3};
    return std::array{int{ring.seen()[cell]}, int{ring.obstacle_points()[cell]},
                      int{ring.floor_points()[cell]}};
  };
  EXPECT_EQ(middle({0.9f, 0.8f}), (std::array{1, 2, 0}));
  EXPECT_EQ(middle({0.9f, 0.1f}), (std::array{1, 0, 1}));
  EXPECT_EQ(middle({0.9f, 0.4f}), (std::array{1, 0, 0}));
  EXPECT_EQ(middle({0.4f, 0.9f}), (std::array{0, 0, 0}));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(middle({nan, nan}), (std::array{0, 0, 0}));
}

TEST(LearnedRing, KeepsToTheVisionOfTheMap) {
  MapSpec spec;
  spec.vision = 1.5;
  spec.cell = 0.1;
  const auto open = Make([](const FreeSpace::Place&) {
    return Told{1.0f, 0.0f};
  });
  LearnedRing ring(open, spec);
  ring.Project({}, 0.5, 0.5, 0.4);
  EXPECT_EQ(ring.seen()[sim::Cell(ring.reach() + 14, ring.reach())], 1);
  EXPECT_EQ(ring.seen()[sim::Cell(ring.reach() + 16, ring.reach())], 0);
}

TEST(LearnedRing, AThinWallHasNoGapsAtAnyYaw) {
  const auto wall = Make([](const FreeSpace::Place& p) {
    return Told{1.0f, p.x > 1.0 && p.x < 1.05 ? 1.0f : 0.0f};
  });
  for (double yaw = 0.0; yaw < 1.6; yaw += 0.1) {
    MetricMap map(ColorRig(), {}, wall);
    const sim::PlanarPose pose{0.01, 0.02, yaw};
    map.Update({}, pose);
    for (double left = -0.9; left < 0.9; left += 0.025) {
      bool is_blocked = false;
      for (double ahead = 0.9; ahead < 1.15; ahead += 0.0125) {
        const sim::Cell cell = map.CellAt({pose.x + ahead * std::cos(yaw) - left * std::sin(yaw),
                                           pose.y + ahead * std::sin(yaw) + left * std::cos(yaw)});
        is_blocked = is_blocked || map.states()[cell] == sim::CellState::kBlocked;
      }
      EXPECT_TRUE(is_blocked) << yaw << " " << left;
    }
  }
}

TEST(LearnedRing, ANavigatorSteersByIt) {
  EXPECT_THROW(MapNavigator(ColorRig(), {}), sim::Error);
  MapNavigator navigator(ColorRig(), {}, PostAt(1.0, 0.0));
  navigator.Reset();
  navigator.Observe({{}, {}, false, 0});
  EXPECT_TRUE(navigator.map().IsObstacle(navigator.map().CellAt({1.0, 0.0})));
  const auto plan = navigator.Plan({2.0, 0.0}, false);
  ASSERT_TRUE(plan);
  EXPECT_GT(plan->distance, 2.02) << "around the post";
}

}  // namespace
}  // namespace bulletnav::agent
