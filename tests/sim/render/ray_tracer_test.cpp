// SPDX-License-Identifier: MIT
#include "sim/render/cpu/ray_tracer.h"

#include <cstdlib>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "sim/math/rng.h"
#include "sim/render/cpu/raycaster.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;
using Triangle = std::array<Vec, 3>;

Vec RandomPlace(Rng* rng, double reach) {
  const double x = rng->Uniform(-reach, reach);
  const double y = rng->Uniform(-reach, reach);
  const double z = rng->Uniform(-reach, reach);
  return Eigen::Vector3d(x, y, z).cast<float>();
}

/// Triangles of all sizes in a room of 10 m, some of them along the axes, as walls are.
std::vector<Triangle> RandomTriangles(int count, std::uint64_t seed) {
  Rng rng(seed, "triangles");
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Vec middle = RandomPlace(&rng, 5.0);
    const double size = i % 10 == 0 ? 3.0 : 0.4;
    Triangle t = {middle + RandomPlace(&rng, size), middle + RandomPlace(&rng, size),
                  middle + RandomPlace(&rng, size)};
    if (i % 3 == 0) {
      for (Vec& corner : t) corner[i % 2] = middle[i % 2];
    }
    triangles.push_back(t);
  }
  return triangles;
}

void ExpectSameHit(const RayHit& ours, const RayHit& embree) {
  EXPECT_EQ(ours.triangle, embree.triangle);
  if (ours.triangle < 0) return;
  EXPECT_NEAR(ours.t, embree.t, 1e-4f * (1.0f + embree.t));
}

TEST(RayTracerTest, MeetsWhatEmbreeMeets) {
  const std::vector<Triangle> triangles = RandomTriangles(3000, 1);
  const RayTracer ours(triangles);
  const Raycaster embree(triangles);
  Rng rng(2, "rays");
  int met = 0;
  int blocked = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec from = RandomPlace(&rng, 6.0);
    const Vec to = RandomPlace(&rng, 6.0);
    const RayHit hit = ours.Cast(from, to - from);
    ExpectSameHit(hit, embree.Cast(from, to - from));
    met += hit.triangle >= 0 ? 1 : 0;
    const bool is_blocked = ours.IsBlocked(from, to);
    EXPECT_EQ(is_blocked, embree.IsBlocked(from, to));
    blocked += is_blocked ? 1 : 0;
  }
  EXPECT_GT(met, 1000);
  EXPECT_LT(met, 4999);
  EXPECT_GT(blocked, 1000);
  EXPECT_LT(blocked, 4900);
}

TEST(RayTracerTest, AxisParallelRaysAndSharedEdges) {
  // A floor of two triangles, and rays down onto their diagonal.
  const Vec a(-1, 0, -1);
  const Vec b(1, 0, -1);
  const Vec c(1, 0, 1);
  const Vec d(-1, 0, 1);
  const RayTracer floor(std::vector<Triangle>{{a, b, c}, {a, c, d}});
  for (int i = -99; i <= 99; ++i) {
    const float x = 0.01f * static_cast<float>(i);
    const RayHit hit = floor.Cast({x, 2, x}, {0, -1, 0});
    EXPECT_GE(hit.triangle, 0) << x;
    EXPECT_FLOAT_EQ(hit.t, 2.0f);
  }
  EXPECT_EQ(floor.Cast({0, 2, 0}, {0, 1, 0}).triangle, -1);
  EXPECT_EQ(floor.Cast({0, 2, 0}, {1, 0, 0}).triangle, -1);
  EXPECT_TRUE(floor.IsBlocked({0, 1, 0}, {0, -1, 0}));
  EXPECT_FALSE(floor.IsBlocked({0, 1, 0}, {0, 0.1f, 0}));
  EXPECT_FALSE(floor.IsBlocked({0, 1, 0}, {5, -0.1f, 0}));
}

std::vector<RayHit> HitsOf(const RayTracer& tracer) {
  Rng rng(3, "packets");
  std::vector<RayHit> all;
  for (int i = 0; i < 200; ++i) {
    const Vec from = RandomPlace(&rng, 6.0);
    std::array<std::array<float, 16>, 3> directions{};
    for (std::size_t k = 0; k < 16; ++k) {
      const Vec d = RandomPlace(&rng, 1.0);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        directions[axis][k] = d[static_cast<int>(axis)];
      }
    }
    std::array<RayHit, 16> hits;
    tracer.CastPacket(from, directions, &hits);
    all.insert(all.end(), hits.begin(), hits.end());
  }
  return all;
}

/// Of the tree that Embree builds, and of what is met in it.
TEST(RayTracerTest, BitsAreTheSameOnEveryInstructionSet) {
  const std::vector<Triangle> triangles = RandomTriangles(3000, 4);
  std::vector<RayHit> first;
  Bvh tree(triangles);
  for (const char* set : {"sse41", "avx2", "avx512"}) {
    setenv("BULLETNAV_ISA", set, 1);
    const Bvh again(triangles);
    ASSERT_EQ(again.nodes.size(), tree.nodes.size()) << set;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      EXPECT_EQ(std::memcmp(&again.nodes[i], &tree.nodes[i], sizeof(BvhNode)), 0) << set;
    }
    const std::vector<RayHit> hits = HitsOf(RayTracer(triangles));
    if (first.empty()) first = hits;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_EQ(hits[i].triangle, first[i].triangle) << set;
      EXPECT_EQ(hits[i].t, first[i].t) << set;
    }
  }
  unsetenv("BULLETNAV_ISA");
}

}  // namespace
}  // namespace bulletnav::sim
