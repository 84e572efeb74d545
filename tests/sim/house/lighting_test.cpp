// SPDX-License-Identifier: MIT
#include "sim/house/lighting.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr float kHalfWidth = 2.0f;
constexpr float kHeight = 2.6f;
constexpr float kDepth = 6.0f;
constexpr int kDarkest = 56;  // of 255: what stays where no light comes

/// A white box room, x in [-2, 2], z in [-6, 0], and things that glow.
class BakedRoom {
 public:
  BakedRoom() {
    mesh_ = tests::BoxRoom(2 * kHalfWidth, kHeight, kDepth);
    for (Vec& p : mesh_.positions) p.x() -= kHalfWidth;
    for (Material& material : mesh_.materials) material.base_color = {200, 200, 200};
    glows_.resize(mesh_.triangles.size(), Glow::kNone);
  }

  /// In the wall z = 0, centred, 1.2 m high, a centimetre in front of it.
  BakedRoom& WithWindow(float width = 1.6f) {
    const float x = 0.5f * width;
    tests::AddQuad({x, 0.9f, -0.01f}, {-x, 0.9f, -0.01f}, {-x, 2.1f, -0.01f}, {x, 2.1f, -0.01f},
                   kWhite, &mesh_);
    return Add(Glow::kSky);
  }
  BakedRoom& WithLamp(const Vec& centre) {
    tests::AddBox(centre - Vec::Constant(0.1f), centre + Vec::Constant(0.1f), kWhite, &mesh_);
    return Add(Glow::kLamp);
  }
  BakedRoom& WithBox(const Vec& low, const Vec& high) {
    tests::AddBox(low, high, {200, 200, 200}, &mesh_);
    return Add(Glow::kNone);
  }
  BakedRoom& WithFloorColor(const Rgb8& color) {
    mesh_.materials[mesh_.triangle_materials[0]].base_color = color;
    return *this;
  }
  BakedRoom& Bake(const LightSpec& spec = {}) {
    BakeLight(&mesh_, glows_, spec);
    return *this;
  }

  /// Mean colour over the surface where `is_there` holds at a triangle's middle.
  Vec Mean(const std::function<bool(const Vec& middle, const Vec& normal)>& is_there) const {
    Vec sum = Vec::Zero();
    float area_sum = 0.0f;
    for (const auto& t : mesh_.triangles) {
      const Vec& a = mesh_.positions[t[0]];
      const Vec& b = mesh_.positions[t[1]];
      const Vec& c = mesh_.positions[t[2]];
      const Vec normal = (b - a).cross(c - a);
      if (!is_there((a + b + c) / 3.0f, normal.normalized())) continue;
      for (const std::uint32_t v : t) {
        sum +=
            normal.norm() * Vec(mesh_.colors[v][0], mesh_.colors[v][1], mesh_.colors[v][2]) / 3.0f;
      }
      area_sum += normal.norm();
    }
    EXPECT_GT(area_sum, 0.0f);
    return sum / area_sum;
  }

  /// Mean brightness of the floor within 0.45 m of a point, seen from above.
  float FloorAt(float x, float z) const {
    return Mean([&](const Vec& p, const Vec& n) {
             return p.y() < 0.01f && n.y() > 0.9f && std::abs(p.x() - x) < 0.45f &&
                    std::abs(p.z() - z) < 0.45f;
           })
        .mean();
  }

  const SceneMesh& mesh() const { return mesh_; }

 private:
  BakedRoom& Add(Glow glow) {
    glows_.resize(mesh_.triangles.size(), glow);
    return *this;
  }

  SceneMesh mesh_;
  std::vector<Glow> glows_;
};

TEST(Lighting, IsBrighterNearTheWindow) {
  BakedRoom room;
  room.WithWindow().Bake();
  const float near = room.FloorAt(0.0f, -1.2f);
  const float middle = room.FloorAt(0.0f, -3.0f);
  const float far = room.FloorAt(0.0f, -5.0f);
  EXPECT_GT(near, middle + 10.0f);
  EXPECT_GT(middle, far + 5.0f);
}

TEST(Lighting, ASymmetricRoomIsLitSymmetrically) {
  BakedRoom room;
  room.WithWindow().Bake();
  for (float z = -0.5f; z > -6.0f; z -= 1.0f) {
    EXPECT_NEAR(room.FloorAt(1.2f, z), room.FloorAt(-1.2f, z), 6.0f) << z;
  }
  const auto wall = [&](float side) {
    return room.Mean([&](const Vec& p, const Vec& n) {
      return side * n.x() < -0.9f && side * p.x() > 1.0f;
    });
  };
  EXPECT_LT((wall(1.0f) - wall(-1.0f)).norm(), 6.0f);
}

TEST(Lighting, AWiderWindowGivesMoreLight) {
  BakedRoom narrow;
  BakedRoom wide;
  narrow.WithWindow(0.6f).Bake();
  wide.WithWindow(2.4f).Bake();
  EXPECT_GT(wide.FloorAt(0.0f, -3.0f), narrow.FloorAt(0.0f, -3.0f) + 8.0f);
}

TEST(Lighting, ALampLightsWhatIsNearIt) {
  BakedRoom room;
  room.WithLamp({0.0f, 2.2f, -1.5f}).Bake();
  EXPECT_GT(room.FloorAt(0.0f, -1.5f), room.FloorAt(0.0f, -5.0f) + 15.0f);
}

TEST(Lighting, ThingsCastShadows) {
  BakedRoom empty;
  BakedRoom room;
  empty.WithWindow().Bake();
  room.WithWindow().WithBox({-0.8f, 0.0f, -1.2f}, {0.8f, 1.4f, -1.0f}).Bake();
  EXPECT_GT(empty.FloorAt(0.0f, -1.7f), room.FloorAt(0.0f, -1.7f) + 10.0f);
}

TEST(Lighting, AColouredFloorTintsTheCeiling) {
  BakedRoom room;
  room.WithFloorColor({230, 40, 40}).WithWindow().Bake();
  const Vec ceiling = room.Mean([](const Vec&, const Vec& n) {
    return n.y() < -0.9f;
  });
  EXPECT_GT(ceiling[0], ceiling[1] + 3.0f);
  EXPECT_GT(ceiling[0], ceiling[2] + 3.0f);
}

TEST(Lighting, WhatGlowsStaysAtFullBrightness) {
  BakedRoom room;
  room.WithWindow().WithLamp({0.0f, 2.2f, -4.0f}).Bake();
  const auto window = room.Mean([](const Vec& p, const Vec&) {
    return std::abs(p.z() + 0.01f) < 1e-4f;
  });
  EXPECT_NEAR(window.minCoeff(), 255.0f, 0.01f);
  const auto lamp = room.Mean([](const Vec& p, const Vec&) {
    return (p - Vec(0.0f, 2.2f, -4.0f)).norm() < 0.18f;
  });
  EXPECT_NEAR(lamp.minCoeff(), 255.0f, 0.01f);
}

TEST(Lighting, LeavesNothingBlack) {
  BakedRoom dark;
  dark.Bake();
  BakedRoom room;  // with a box that stands in the floor, and one flat against a wall
  room.WithWindow()
      .WithBox({-1.0f, -0.2f, -4.0f}, {0.0f, 0.5f, -3.0f})
      .WithBox({1.9f, 0.0f, -3.0f}, {2.0f, 2.6f, -2.0f})
      .Bake();
  for (const SceneMesh& mesh : {dark.mesh(), room.mesh()}) {
    for (const Rgb8& color : mesh.colors) {
      for (const std::uint8_t channel : color) EXPECT_GE(channel, kDarkest);
    }
  }
}

TEST(Lighting, KeepsTheShape) {
  BakedRoom before;
  before.WithWindow();
  BakedRoom room;
  room.WithWindow().Bake();
  room.mesh().Validate();
  const auto area = [](const SceneMesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec& p = mesh.positions[a];
      sum += 0.5 * (mesh.positions[b] - p).cross(mesh.positions[c] - p).norm();
    }
    return sum;
  };
  EXPECT_NEAR(area(room.mesh()), area(before.mesh()), 1e-3);
  EXPECT_EQ(room.mesh().Bounds().min(), before.mesh().Bounds().min());
  EXPECT_EQ(room.mesh().Bounds().max(), before.mesh().Bounds().max());
}

TEST(Lighting, HalvesLongEdges) {
  BakedRoom room;
  LightSpec spec;
  spec.coarse_edge_m = 0.6f;
  room.WithWindow().Bake(spec);
  for (const auto& t : room.mesh().triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec& a = room.mesh().positions[t[k]];
      EXPECT_LE((a - room.mesh().positions[t[(k + 1) % 3]]).norm(), 0.6f + 1e-4f);
    }
  }
}

TEST(Lighting, StopsRefiningAboveItsLimit) {
  BakedRoom room;
  LightSpec spec;
  spec.max_triangles = 100;
  room.WithWindow().Bake(spec);
  EXPECT_LE(room.mesh().triangles.size(), 400u);  // the last round makes at most four of each
}

TEST(Lighting, IsTheSameEveryTime) {
  BakedRoom one;
  BakedRoom two;
  one.WithWindow().WithLamp({0.0f, 2.2f, -4.0f}).Bake();
  two.WithWindow().WithLamp({0.0f, 2.2f, -4.0f}).Bake();
  EXPECT_EQ(one.mesh().positions, two.mesh().positions);
  EXPECT_EQ(one.mesh().triangles, two.mesh().triangles);
  EXPECT_EQ(one.mesh().colors, two.mesh().colors);
}

}  // namespace
}  // namespace bulletnav::sim
