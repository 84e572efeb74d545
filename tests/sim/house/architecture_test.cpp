// SPDX-License-Identifier: MIT
#include "sim/house/architecture.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/math/pose.h"
#include "sim/physics/capsule_body.h"
#include "sim/render/cpu/ray_tracer.h"
#include "tests/sim/house/plan_samples.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;
using Corners = std::vector<std::array<Vec, 3>>;

/// The shell of one seed's house.
struct Shell {
  explicit Shell(int seed) : plan(GenerateFloorPlan(Rng(Seed(seed), "plan_test"))) {
    style = DrawHouseStyle(plan, Rng(Seed(seed), "style_test"));
    MeshBuilder builder;
    BuildArchitecture(plan, style, &builder);
    glows = builder.glows();
    TextureCache cache;
    mesh = builder.Finish(&cache);
  }

  Corners corners() const {
    Corners corners;
    for (const auto& t : mesh.triangles) {
      corners.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    }
    return corners;
  }

  FloorPlan plan;
  HouseStyle style;
  std::vector<Glow> glows;
  SceneMesh mesh;

 private:
  static std::uint64_t Seed(int seed) { return static_cast<std::uint64_t>(seed); }
};

Vec NormalOf(const std::array<Vec, 3>& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

float ToSegment(const PlanPoint& p, const PlanPoint& a, const PlanPoint& b) {
  const float t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0f, 1.0f);
  return (p - a - t * (b - a)).norm();
}

float ToOutline(const PlanPoint& p, std::span<const PlanPoint> outline) {
  float nearest = 1e9f;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    nearest = std::min(nearest, ToSegment(p, outline[i], outline[(i + 1) % outline.size()]));
  }
  return nearest;
}

/// Free of boards on the walls, leaves with their handles, beams and mouldings.
bool IsInTheOpen(const FloorPlan& plan, const Room& room, const PlanPoint& p) {
  if (!IsInside(room.outline, p) || ToOutline(p, room.outline) < 0.06f) return false;
  return std::none_of(plan.openings.begin(), plan.openings.end(), [&](const Opening& o) {
    if (!o.has_leaf) return false;
    const auto leaf = LeafOutline(o);
    return IsInside(leaf, p) || ToOutline(p, leaf) < 0.12f;
  });
}

Vec PointIn(const FloorPlan& plan, const Room& room, Rng* rng) {
  Eigen::AlignedBox2f box;
  for (const PlanPoint& p : room.outline) box.extend(p);
  for (;;) {
    const PlanPoint p(rng->Uniform(box.min().x(), box.max().x()),
                      rng->Uniform(box.min().y(), box.max().y()));
    if (!IsInTheOpen(plan, room, p)) continue;
    return {p.x(), static_cast<float>(rng->Uniform(0.05, plan.ceiling - 0.2)), p.y()};
  }
}

std::string Text(const Vec& v) {
  std::ostringstream text;
  text << v.transpose();
  return text.str();
}

Vec AnyDirection(Rng* rng) {
  return Vec(static_cast<float>(rng->Normal()), static_cast<float>(rng->Normal()),
             static_cast<float>(rng->Normal()))
      .normalized();
}

PlanPoint Between(const PlanPoint& p, const PlanPoint& q, Rng* rng) {
  return p + static_cast<float>(rng->Uniform()) * (q - p);
}

Vec Raised(const PlanPoint& p, double height) {
  return {p.x(), static_cast<float>(height), p.y()};
}

/// A point where two walls, or a wall and the floor or ceiling, meet.
Vec PointOnARoomEdge(const FloorPlan& plan, const Room& room, Rng* rng) {
  const auto i = static_cast<std::size_t>(rng->Below(static_cast<int>(room.outline.size())));
  const PlanPoint& p = room.outline[i];
  if (rng->Chance(0.5)) return Raised(p, rng->Uniform(0.0, plan.ceiling));
  const PlanPoint& q = room.outline[(i + 1) % room.outline.size()];
  return Raised(Between(p, q, rng), rng->Chance(0.5) ? 0.0 : plan.ceiling);
}

/// A point on a side of a hole, anywhere in the wall's thickness.
Vec PointOnAHoleEdge(const FloorPlan& plan, Rng* rng) {
  const Opening& o = rng->Pick(plan.openings);
  const PlanPoint inwards = o.wall_thickness * LeftOf((o.b - o.a).normalized());
  const PlanPoint depth = static_cast<float>(rng->Uniform(-0.5, 0.5)) * inwards;
  if (rng->Chance(0.5)) {
    return Raised((rng->Chance(0.5) ? o.a : o.b) + depth, rng->Uniform(o.bottom, o.top));
  }
  return Raised(Between(o.a, o.b, rng) + depth, rng->Chance(0.5) ? o.bottom : o.top);
}

/// Half of them anywhere, half close by edges: cracks, if there are any, are there.
Vec DirectionFrom(const Vec& from, const FloorPlan& plan, const Room& room, Rng* rng) {
  if (rng->Chance(0.5)) return AnyDirection(rng);
  const Vec edge =
      rng->Chance(0.5) ? PointOnARoomEdge(plan, room, rng) : PointOnAHoleEdge(plan, rng);
  return (edge + 2e-3f * AnyDirection(rng) - from).normalized();
}

class ArchitectureTest : public testing::TestWithParam<int> {};

/// Rays into a shell.
class Probe {
 public:
  explicit Probe(const Shell& shell) : corners_(shell.corners()), raycaster_(corners_) {}

  RayHit Cast(const Vec& from, const Vec& direction) const {
    return raycaster_.Cast(from, direction);
  }

  bool ShowsBack(const Vec& from, const Vec& direction) const {
    const RayHit hit = Cast(from, direction);
    return hit.triangle >= 0 &&
           NormalOf(corners_[static_cast<std::size_t>(hit.triangle)]).dot(direction) > 0.0f;
  }

  /// Whether most rays within a millimetre of a point show a back too: not so where rounding lets a
  /// ray slip through a joint, or under a groove that stands a millimetre off its leaf.
  bool ShowsBackAround(const Vec& from, const Vec& at, Rng* rng) const {
    int backs = 0;
    for (int i = 0; i < 20; ++i) {
      if (ShowsBack(from, at + 1e-3f * AnyDirection(rng) - from)) ++backs;
    }
    return backs > 10;
  }

 private:
  Corners corners_;
  RayTracer raycaster_;
};

TEST_P(ArchitectureTest, LetsNoRayOutAndShowsNoBackFace) {
  const Shell shell(GetParam());
  const Probe probe(shell);
  Rng rng(static_cast<std::uint64_t>(GetParam()), "architecture_rays");
  for (const Room& room : shell.plan.rooms) {
    std::vector<std::string> escaped;
    std::vector<std::string> backs;
    for (int i = 0; i < 4000; ++i) {
      const Vec from = PointIn(shell.plan, room, &rng);
      const Vec direction = DirectionFrom(from, shell.plan, room, &rng);
      const RayHit hit = probe.Cast(from, direction);
      const Vec at = from + hit.t * direction;
      if (hit.triangle < 0 || hit.t > 40.0f) {
        escaped.push_back(Text(from) + " along " + Text(direction));
      } else if (probe.ShowsBack(from, direction) && probe.ShowsBackAround(from, at, &rng)) {
        backs.push_back(Text(at) + " from " + Text(from));
      }
    }
    EXPECT_THAT(escaped, testing::IsEmpty()) << room.name;
    EXPECT_THAT(backs, testing::IsEmpty()) << room.name;
  }
}

/// Where an upright body can stand around one passage, in the passage's own frame: u along the wall
/// from its middle, v across it into room_a.
class PassageGrid {
 public:
  static constexpr float kStep = 0.04f;
  static constexpr float kRadius = 0.18f + 0.02f;
  static constexpr float kFar = 0.4f;  // clear of the wall on either side

  PassageGrid(const FloorPlan& plan, const Opening& opening, const PhysicsWorld& world)
      : plan_(plan), opening_(opening) {
    along_ = (opening.b - opening.a).normalized();
    across_ = LeftOf(along_);
    half_u_ = static_cast<int>((0.5f * opening.width() + 0.5f) / kStep);
    for (int v = -kHalfV; v <= kHalfV; ++v) {
      for (int u = -half_u_; u <= half_u_; ++u) free_.push_back(IsFree(world, u, v));
    }
  }

  PlanPoint At(int cell) const {
    const int columns = 2 * half_u_ + 1;
    return Place(cell % columns - half_u_, cell / columns - kHalfV);
  }

  /// Cells from room_a to room_b, if there is a way.
  std::vector<int> Way() const {
    std::vector<int> before(free_.size(), -2);
    std::deque<int> queue;
    for (int cell = 0; cell < static_cast<int>(free_.size()); ++cell) {
      if (!IsEnd(cell, opening_.room_a)) continue;
      before[static_cast<std::size_t>(cell)] = -1;
      queue.push_back(cell);
    }
    while (!queue.empty()) {
      const int cell = queue.front();
      queue.pop_front();
      if (IsEnd(cell, opening_.room_b)) return Trace(cell, before);
      for (const int next : Neighbours(cell)) {
        if (!free_[static_cast<std::size_t>(next)]) continue;
        if (before[static_cast<std::size_t>(next)] != -2) continue;
        before[static_cast<std::size_t>(next)] = cell;
        queue.push_back(next);
      }
    }
    return {};
  }

 private:
  static constexpr int kHalfV = 30;

  PlanPoint Place(int u, int v) const {
    return 0.5f * (opening_.a + opening_.b) +
           kStep * (static_cast<float>(u) * along_ + static_cast<float>(v) * across_);
  }

  bool IsFree(const PhysicsWorld& world, int u, int v) const {
    const bool in_wall = std::abs(kStep * static_cast<float>(v)) < 0.5f * opening_.wall_thickness;
    // Through this passage, not through one beside it.
    if (in_wall && std::abs(kStep * static_cast<float>(u)) > 0.5f * opening_.width()) return false;
    const PlanPoint p = Place(u, v);
    const Capsule capsule{{p.x(), 0.06f + kRadius, p.y()}, 1.5f - 2.0f * kRadius, kRadius};
    return !world.Nearest(capsule, kRadius);
  }

  bool IsEnd(int cell, int room) const {
    const PlanPoint p = At(cell);
    const float v = (p - opening_.a).dot(across_);
    return free_[static_cast<std::size_t>(cell)] && std::abs(v) > kFar &&
           IsInside(plan_.rooms[static_cast<std::size_t>(room)].outline, p);
  }

  std::vector<int> Neighbours(int cell) const {
    const int columns = 2 * half_u_ + 1;
    std::vector<int> cells;
    if (cell % columns > 0) cells.push_back(cell - 1);
    if (cell % columns + 1 < columns) cells.push_back(cell + 1);
    if (cell >= columns) cells.push_back(cell - columns);
    if (cell + columns < static_cast<int>(free_.size())) cells.push_back(cell + columns);
    return cells;
  }

  static std::vector<int> Trace(int cell, const std::vector<int>& before) {
    std::vector<int> way;
    for (; cell >= 0; cell = before[static_cast<std::size_t>(cell)]) way.push_back(cell);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const FloorPlan& plan_;
  const Opening& opening_;
  PlanPoint along_;
  PlanPoint across_;
  int half_u_ = 0;
  std::vector<bool> free_;
};

/// Follows a way with the simulator's body; the distance from its end that is left.
float WalkAlong(const PassageGrid& grid, const std::vector<int>& way, CapsuleBody* body) {
  const auto world = [&](int cell) {
    const PlanPoint p = grid.At(cell);
    return Eigen::Vector3d(p.x(), 0.0, p.y());
  };
  body->Reset({world(way.front()), 0.0});
  for (const int cell : way) {
    // At yaw 0 the body looks along -z: forward is -z, left is -x.
    const Eigen::Vector3d to = world(cell) - body->pose().position;
    body->Move({-to.z(), -to.x(), 0.0});
  }
  Eigen::Vector3d left = world(way.back()) - body->pose().position;
  left.y() = 0.0;
  return static_cast<float>(left.norm());
}

TEST_P(ArchitectureTest, LetsABodyThroughEveryPassageThatIsNotShut) {
  const Shell shell(GetParam());
  const PhysicsWorld world(shell.mesh);
  CapsuleBody body(world, BodySpec::Locobot());
  for (const Opening& opening : shell.plan.openings) {
    const bool is_shut = opening.has_leaf && opening.door_angle == 0.0f;
    if (!opening.IsPassage() || is_shut) continue;
    const PassageGrid grid(shell.plan, opening, world);
    const std::vector<int> way = grid.Way();
    ASSERT_FALSE(way.empty()) << opening.a.transpose() << " - " << opening.b.transpose();
    EXPECT_LT(WalkAlong(grid, way, &body), 0.05f) << opening.a.transpose();
  }
}

TEST_P(ArchitectureTest, StopsABodyAtAShutDoor) {
  const Shell shell(GetParam());
  const PhysicsWorld world(shell.mesh);
  for (const Opening& opening : shell.plan.openings) {
    if (!opening.has_leaf || opening.door_angle != 0.0f) continue;
    const PlanPoint middle = 0.5f * (opening.a + opening.b);
    const PlanPoint in = LeftOf((opening.b - opening.a).normalized());
    const PlanPoint from = middle + 0.5f * in;
    const Capsule capsule{{from.x(), 0.3f, from.y()}, 1.0f, 0.18f};
    const auto hit = world.Sweep(capsule, {-in.x(), 0.0f, -in.y()});
    ASSERT_TRUE(hit.has_value());
    EXPECT_LT(hit->fraction, 0.5f);
  }
}

TEST_P(ArchitectureTest, GivesSkyLightThroughEveryWindowAndNowhereElse) {
  const Shell shell(GetParam());
  ASSERT_EQ(shell.glows.size(), shell.mesh.triangles.size());
  EXPECT_EQ(std::count(shell.glows.begin(), shell.glows.end(), Glow::kLamp), 0);
  std::vector<double> seen(shell.plan.openings.size(), 0.0);  // glowing area behind each opening
  const Corners corners = shell.corners();
  for (std::size_t t = 0; t < corners.size(); ++t) {
    if (shell.glows[t] != Glow::kSky) continue;
    const Vec middle = (corners[t][0] + corners[t][1] + corners[t][2]) / 3.0f;
    for (std::size_t i = 0; i < shell.plan.openings.size(); ++i) {
      const Opening& o = shell.plan.openings[i];
      if (o.kind != OpeningKind::kWindow) continue;
      const PlanPoint in = LeftOf((o.b - o.a).normalized());
      if (ToSegment({middle.x(), middle.z()}, o.a, o.b) > o.wall_thickness) continue;
      const Vec normal = NormalOf(corners[t]);
      EXPECT_GT(normal.dot(Vec(in.x(), 0.0f, in.y())), 0.99f * normal.norm());
      seen[i] += 0.5 * normal.norm();
    }
  }
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Opening& o = shell.plan.openings[i];
    const double hole = o.width() * (o.top - o.bottom);
    if (o.kind == OpeningKind::kWindow) {
      EXPECT_GE(seen[i], hole);
      EXPECT_LE(seen[i], 1.3 * hole);
    }
  }
  EXPECT_EQ(std::count(shell.glows.begin(), shell.glows.end(), Glow::kSky),
            2 * std::count_if(shell.plan.openings.begin(), shell.plan.openings.end(),
                              [](const Opening& o) {
                                return o.kind == OpeningKind::kWindow;
                              }));
}

TEST_P(ArchitectureTest, HasAFewThousandTrianglesAndNoneWithoutArea) {
  const Shell shell(GetParam());
  EXPECT_GT(shell.mesh.triangles.size(), 1000u);
  EXPECT_LT(shell.mesh.triangles.size(), 9000u);
  for (const auto& triangle : shell.corners()) EXPECT_GT(NormalOf(triangle).norm(), 1e-8f);
}

TEST_P(ArchitectureTest, StaysWithinTheHouse) {
  const Shell shell(GetParam());
  const Eigen::AlignedBox3f box = shell.mesh.Bounds();
  Eigen::AlignedBox2f footprint;
  for (const PlanPoint& p : shell.plan.footprint) footprint.extend(p);
  EXPECT_GE(box.min().x(), footprint.min().x() - 0.03f);
  EXPECT_GE(box.min().z(), footprint.min().y() - 0.03f);
  EXPECT_LE(box.max().x(), footprint.max().x() + 0.03f);
  EXPECT_LE(box.max().z(), footprint.max().y() + 0.03f);
  EXPECT_GE(box.min().y(), -0.03f);
  EXPECT_LE(box.max().y(), shell.plan.ceiling + 0.03f);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ArchitectureTest, testing::Range(0, 12));

TEST(Architecture, IsTheSameEveryTime) {
  const Shell one(3);
  const Shell two(3);
  EXPECT_EQ(one.mesh.positions, two.mesh.positions);
  EXPECT_EQ(one.mesh.uvs, two.mesh.uvs);
  EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
  EXPECT_EQ(one.mesh.triangle_materials, two.mesh.triangle_materials);
  EXPECT_EQ(one.glows, two.glows);
}

}  // namespace
}  // namespace bulletnav::sim
