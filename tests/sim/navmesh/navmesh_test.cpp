// SPDX-License-Identifier: MIT
#include "sim/navmesh/navmesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/grid_path.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::AddBox;
using tests::AddQuad;
using tests::BoxRoom;
using tests::LCorridor;
using Vec = Eigen::Vector3f;

constexpr Rgb8 kGrey = {128, 128, 128};

TEST(Navmesh, CoversTheFloorOfABoxRoomLessARadiusAtTheWalls) {
  const Navmesh navmesh(BoxRoom(4, 2.6f, 6), {});
  ASSERT_EQ(navmesh.islands().size(), 1u);
  EXPECT_LE(navmesh.area(), 3.8f * 5.8f);
  EXPECT_GE(navmesh.area(), 3.7f * 5.7f - 0.01f);  // a cell more for the wall's own voxels
  EXPECT_NEAR(navmesh.islands()[0].radius, std::hypot(1.9f, 2.9f), 0.2f);
}

TEST(Navmesh, DistancesInAnEmptyRoomAreStraight) {
  const Navmesh navmesh(BoxRoom(4, 2.6f, 6), {});
  const NavmeshQuery query(navmesh);
  EXPECT_NEAR(query.GeodesicDistance({0.5f, 0, -0.5f}, {3.5f, 0, -4.5f}), 5.0, 0.01);
  EXPECT_DOUBLE_EQ(query.GeodesicDistance({1, 0, -1}, {1, 0, -1}), 0.0);
}

TEST(Navmesh, PathsBendRoundTheCornerOfAnLShapedCorridor) {
  const Navmesh navmesh(LCorridor(6, 5, 1.5f, 2.5f), {});
  const NavmeshQuery query(navmesh);
  const Vec a(0.5f, 0, -0.75f);
  const Vec b(5.25f, 0, -4.5f);
  // Around the inner corner (4.5, -1.5), a radius away from it.
  const Vec corner(4.6f, 0, -1.4f);
  const double expected = (corner - a).norm() + (b - corner).norm();
  const auto path = query.FindPath(a, b);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length, expected, 0.1);
  EXPECT_GE(path->points.size(), 3u);
  EXPECT_DOUBLE_EQ(query.GeodesicDistance(b, a), path->length);
}

TEST(Navmesh, AgreesWithAFineGridAmongRandomBoxes) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    Rng rng(seed, "boxes");
    SceneMesh mesh = BoxRoom(6, 2.6f, 6);
    std::vector<Eigen::AlignedBox2d> boxes;
    for (int i = 0; i < 9; ++i) {
      const double x = rng.Uniform(0.3, 5.0);
      const double z = rng.Uniform(0.3, 5.0);
      const double w = rng.Uniform(0.1, 1.2);
      const double d = rng.Uniform(0.1, 1.2);
      boxes.emplace_back(Eigen::Vector2d(x, z), Eigen::Vector2d(x + w, z + d));
      AddBox({float(x), 0, float(-z - d)}, {float(x + w), 1.2f, float(-z)}, kGrey, &mesh);
    }
    const auto free_beyond = [&](double clearance) {
      return [&boxes, clearance](double x, double y) {
        const Eigen::Vector2d p(x, y);
        if (std::min({x, y, 6 - x, 6 - y}) < clearance) return false;
        return std::all_of(boxes.begin(), boxes.end(), [&](const auto& box) {
          return box.exteriorDistance(p) >= clearance;
        });
      };
    };
    const Navmesh navmesh(mesh, {});
    const NavmeshQuery query(navmesh);
    int compared = 0;
    for (int i = 0; i < 6; ++i) {
      const Vec a = query.RandomPoint(&rng, 0);
      const Vec b = query.RandomPoint(&rng, 0);
      const auto grid = [&](double clearance) {
        return tests::GridPathLength(6, 6, 0.05, free_beyond(clearance), a.x(), -a.z(), b.x(),
                                     -b.z());
      };
      if (std::max(a.y(), b.y()) > 0.3f) continue;  // on a box
      // Voxels make walls up to a cell thicker than they are.
      const double wide = grid(0.19);
      const double narrow = grid(0.1);
      if (wide < 0.0 || narrow < 0.0) continue;
      const double geodesic = query.GeodesicDistance(a, b);
      EXPECT_LE(geodesic, 1.05 * wide + 0.05) << seed << " " << i;
      EXPECT_GE(geodesic, 0.98 * narrow - 0.1) << seed << " " << i;
      ++compared;
    }
    EXPECT_GE(compared, 2);
  }
}

TEST(Navmesh, RoomsWithoutADoorAreIslandsAndInfinitelyFarApart) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  AddBox({0, 0, -2.1f}, {4, 2.6f, -2}, kGrey, &mesh);
  const Navmesh navmesh(mesh, {});
  ASSERT_EQ(navmesh.islands().size(), 2u);
  EXPECT_GT(navmesh.islands()[0].area, navmesh.islands()[1].area);
  const NavmeshQuery query(navmesh);
  EXPECT_EQ(query.GeodesicDistance({2, 0, -1}, {2, 0, -4}),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(query.IslandOf({2, 0, -4}), 0);
  EXPECT_EQ(query.IslandOf({2, 0, -1}), 1);
}

TEST(Navmesh, RandomPointsAreEvenOverTheIslandAsked) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  AddBox({0, 0, -2.1f}, {4, 2.6f, -2}, kGrey, &mesh);
  const Navmesh navmesh(mesh, {});
  const NavmeshQuery query(navmesh);
  Rng rng(1, "points");
  int left = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec p = query.RandomPoint(&rng, 0);
    ASSERT_LT(p.z(), -2.1f);
    left += p.x() < 2.0f ? 1 : 0;
  }
  EXPECT_NEAR(left, 2000, 200);
  int near = 0;
  for (int i = 0; i < 4000; ++i) near += query.RandomPoint(&rng).z() > -2.0f ? 1 : 0;
  const float share = navmesh.islands()[1].area / navmesh.area();
  EXPECT_NEAR(near / 4000.0, share, 0.03);
  EXPECT_THROW(query.RandomPoint(&rng, 2), Error);
  EXPECT_THROW(query.RandomPoint(&rng, -2), Error);
}

TEST(Navmesh, FloorsThatFaceDownStillCount) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(Navmesh(mesh, {}).islands()[0].area, 3.7f * 5.7f, 0.1f);
}

TEST(Navmesh, WithoutFloorThereIsNothing) {
  SceneMesh mesh;
  AddQuad({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, kGrey, &mesh);
  const Navmesh navmesh(mesh, {});
  EXPECT_TRUE(navmesh.islands().empty());
  EXPECT_EQ(navmesh.area(), 0.0f);
  const NavmeshQuery query(navmesh);
  EXPECT_FALSE(query.Snap({1, 0, 1}));
  EXPECT_EQ(query.GeodesicDistance({0, 0, 0}, {1, 0, 0}), std::numeric_limits<double>::infinity());
}

TEST(Navmesh, ScenesTooLargeForItsGridAreRefused) {
  SceneMesh mesh;
  AddQuad({0, 0, 0}, {1500, 0, 0}, {1500, 0, -1500}, {0, 0, -1500}, kGrey, &mesh);
  EXPECT_THROW(Navmesh(mesh, {}), Error);
}

TEST(Navmesh, SettingsThatRecastCannotHoldAreNamed) {
  const auto complaint = [](const std::function<void(NavmeshSpec*)>& change) -> std::string {
    NavmeshSpec spec;
    change(&spec);
    try {
      spec.Validate();
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(complaint([](NavmeshSpec* /*spec*/) {}), "");
  EXPECT_THAT(complaint([](NavmeshSpec* spec) {
                spec->detail_sample_distance = -1.0f;
              }),
              testing::StartsWith("detail_sample_distance is -1"));
  EXPECT_THAT(complaint([](NavmeshSpec* spec) {
                spec->agent_radius = 13.0f;
              }),
              testing::StartsWith("agent_radius is 13"));
  EXPECT_THAT(complaint([](NavmeshSpec* spec) {
                spec->max_slope_deg = NAN;
              }),
              testing::StartsWith("max_slope_deg"));
  EXPECT_THAT(complaint([](NavmeshSpec* spec) {
                spec->region_min_size = -1e6f;
              }),
              testing::StartsWith("region_min_size"));
}

TEST(Navmesh, PointsThatAreNotFiniteAreNowhere) {
  const Navmesh navmesh(BoxRoom(4, 2.6f, 6), {});
  const NavmeshQuery query(navmesh);
  EXPECT_FALSE(query.Snap({NAN, 0, 0}));
  EXPECT_FALSE(query.FindPath({1, 0, -1}, {INFINITY, 0, 0}));
}

}  // namespace
}  // namespace bulletnav::sim
