// SPDX-License-Identifier: MIT
#include "sim/house/mesh_builder.h"

#include <array>
#include <functional>

#include <gtest/gtest.h>

#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

using Vec = MeshBuilder::Vec;
using Vec2 = MeshBuilder::Vec2;

const Surface kPlain{"plaster_smooth"};

/// Signed volume of what the builder holds: positive if closed and facing outwards.
double Volume(const MeshBuilder& builder) {
  TextureCache cache;
  MeshBuilder copy;
  copy.Append(builder);
  const SceneMesh mesh = copy.Finish(&cache);
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += mesh.positions[t[0]].cross(mesh.positions[t[1]]).dot(mesh.positions[t[2]]) / 6.0;
  }
  return volume;
}

struct Solid {
  const char* name;
  std::function<void(MeshBuilder*)> add;
  double volume;
  double tolerance;  // relative: round things are made of flat faces
};

class SolidTest : public testing::TestWithParam<Solid> {};

TEST_P(SolidTest, FacesOutwardsAndHasItsVolume) {
  MeshBuilder builder;
  GetParam().add(&builder);
  EXPECT_NEAR(Volume(builder), GetParam().volume, GetParam().tolerance * GetParam().volume);
}

TEST_P(SolidTest, KeepsItsVolumeWhenTurnedAndMoved) {
  MeshBuilder builder;
  const MeshBuilder::Frame frame(&builder, Vec(3.0f, 1.0f, -2.0f), 0.7f);
  GetParam().add(&builder);
  EXPECT_NEAR(Volume(builder), GetParam().volume, GetParam().tolerance * GetParam().volume);
}

const std::array kLShape = {Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(1, 1), Vec2(1, 2), Vec2(0, 2)};

INSTANTIATE_TEST_SUITE_P(
    All, SolidTest,
    testing::Values(Solid{"box",
                          [](MeshBuilder* b) {
                            b->Box(kPlain, {1, 2, 3}, {2, 4, 6});
                          },
                          6.0, 1e-4},
                    Solid{"block",
                          [](MeshBuilder* b) {
                            b->Block(kPlain, {5, 0, 1}, {1, 2, 3});
                          },
                          6.0, 1e-4},
                    Solid{"cylinder",
                          [](MeshBuilder* b) {
                            b->Cylinder(kPlain, {4, 0, 0}, 0.5f, 2.0f, 48);
                          },
                          kPi / 2, 0.01},
                    Solid{"cone",
                          [](MeshBuilder* b) {
                            b->Cone(kPlain, {0, 1, 0}, 1.0f, 0.0f, 3.0f, 48);
                          },
                          kPi, 0.01},
                    Solid{"bar",
                          [](MeshBuilder* b) {
                            b->Bar(kPlain, {0, 0, 0}, {1, 1, 0}, 0.1f, 48);
                          },
                          kPi * 0.01 * std::sqrt(2.0), 0.01},
                    Solid{"ball",
                          [](MeshBuilder* b) {
                            b->Ball(kPlain, {1, 1, 1}, {1, 0.5f, 2}, 64);
                          },
                          4.0 / 3.0 * kPi, 0.02},
                    Solid{"tapered_box",
                          [](MeshBuilder* b) {
                            b->TaperedBox(kPlain, {0, 0, 0}, {2, 2}, {1, 3, 2}, {1, 1});
                          },
                          7.0, 1e-4},
                    Solid{"loft",
                          [](MeshBuilder* b) {
                            b->Loft(kPlain,
                                    std::array{MeshBuilder::Oval{{0, 0, 0}, {0, 0}},
                                               MeshBuilder::Oval{{0, 0, 0}, {2, 1}},
                                               MeshBuilder::Oval{{1, 3, 0}, {0, 0}}},
                                    48);
                          },
                          2.0 * kPi, 0.01},
                    Solid{"prism",
                          [](MeshBuilder* b) {
                            b->Prism(kPlain, kLShape, 1.0f, 3.0f);
                          },
                          6.0, 1e-4}),
    [](const auto& solid) {
      return solid.param.name;
    });

TEST(MeshBuilder, RoundedBoxStaysInsideItsBox) {
  MeshBuilder builder;
  builder.RoundedBox(kPlain, {0, 0, 0}, {2, 0.3f, 1}, 0.08f);
  const Eigen::AlignedBox3f box = builder.Bounds();
  EXPECT_TRUE(box.min().isApprox(Vec(0, 0, 0)));
  EXPECT_TRUE(box.max().isApprox(Vec(2, 0.3f, 1)));
}

TEST(MeshBuilder, RoundedBoxFacesOutwardsHoweverRound) {
  for (const float radius : {0.02f, 0.1f, 0.5f, 2.0f}) {
    MeshBuilder builder;
    builder.RoundedBox(kPlain, {-1, 0, -0.2f}, {1, 0.6f, 0.2f}, radius);
    TextureCache cache;
    const SceneMesh mesh = builder.Finish(&cache);
    for (const auto& t : mesh.triangles) {
      const Vec& a = mesh.positions[t[0]];
      const Vec normal = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
      EXPECT_GT(normal.dot(a - Vec(0, 0.1f, 0)), 0.0f) << radius;
    }
  }
}

TEST(MeshBuilder, TopsOfRoundThingsAreTexturedInOnePlane) {
  MeshBuilder builder;
  builder.Cylinder(kPlain, {0, 0, 0}, 0.5f, 1.0f, 16);
  TextureCache cache;
  const SceneMesh mesh = builder.Finish(&cache);
  const float metres = FindMaterial(kPlain.material).metres;
  int found = 0;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      const Vec& p = mesh.positions[v];
      if ((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]).y() < 2.999f)
        continue;
      EXPECT_TRUE((mesh.uvs[v] * metres).isApprox(Vec2(p.x(), p.z()), 1e-4f));
      ++found;
    }
  }
  EXPECT_EQ(found, 3 * 16);
}

TEST(MeshBuilder, PolygonOfAnyOrderCoversItsAreaAndFacesAsAsked) {
  std::array<Vec2, 6> reversed = kLShape;
  std::reverse(reversed.begin(), reversed.end());
  for (const auto& outline : {kLShape, reversed}) {
    for (const bool up : {true, false}) {
      MeshBuilder builder;
      builder.Polygon(kPlain, outline, 1.0f, up);
      TextureCache cache;
      const SceneMesh mesh = builder.Finish(&cache);
      Vec sum = Vec::Zero();
      for (const auto& t : mesh.triangles) {
        sum += 0.5f * (mesh.positions[t[1]] - mesh.positions[t[0]])
                          .cross(mesh.positions[t[2]] - mesh.positions[t[0]]);
      }
      EXPECT_TRUE(sum.isApprox(Vec(0, up ? 3.0f : -3.0f, 0))) << sum.transpose();
    }
  }
}

TEST(MeshBuilder, TexturesKeepTheirScale) {
  MeshBuilder builder;
  builder.Quad(kPlain, {0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0});
  TextureCache cache;
  const SceneMesh mesh = builder.Finish(&cache);
  const float metres = FindMaterial(kPlain.material).metres;
  EXPECT_NEAR((mesh.uvs[1] - mesh.uvs[0]).norm() * metres, 3.0f, 1e-4f);
  EXPECT_NEAR((mesh.uvs[3] - mesh.uvs[0]).norm() * metres, 2.0f, 1e-4f);
  EXPECT_GT(mesh.uvs[1].x(), mesh.uvs[0].x());  // reads left to right from the front
  EXPECT_LT(mesh.uvs[3].y(), mesh.uvs[0].y());  // and upright
}

TEST(MeshBuilder, PictureShowsThePartAskedFor) {
  MeshBuilder builder;
  const std::array corners = {Vec(0, 0, 0), Vec(3, 0, 0), Vec(3, 1, 0), Vec(0, 1, 0)};
  builder.Picture({"book_spines"}, corners[0], corners[1], corners[2], corners[3]);
  builder.Picture({"book_spines"}, corners[0], corners[1], corners[2], corners[3],
                  {Vec2(0.5f, 0.25f), Vec2(2.5f, 0.75f)});
  TextureCache cache;
  const SceneMesh mesh = builder.Finish(&cache);
  EXPECT_TRUE(mesh.uvs[0].isApprox(Vec2(0, 1)));  // the lower left corner; v runs down
  EXPECT_TRUE(mesh.uvs[2].isApprox(Vec2(1, 0)));
  EXPECT_TRUE(mesh.uvs[4].isApprox(Vec2(0.5f, 0.75f)));
  EXPECT_TRUE(mesh.uvs[6].isApprox(Vec2(2.5f, 0.25f)));
}

TEST(MeshBuilder, AppendKeepsMaterialsAndGlow) {
  MeshBuilder part;
  part.SetGlow(Glow::kLamp);
  part.Box({"plaster_smooth", {10, 20, 30}}, {0, 0, 0}, {1, 1, 1});
  MeshBuilder whole;
  whole.Box(kPlain, {0, 0, 0}, {1, 1, 1});
  const MeshBuilder::Frame frame(&whole, Vec(5, 0, 0));
  whole.Append(part);
  EXPECT_EQ(whole.triangles(), 24u);
  EXPECT_EQ(whole.glows().front(), Glow::kNone);
  EXPECT_EQ(whole.glows().back(), Glow::kLamp);
  EXPECT_FLOAT_EQ(whole.Bounds().max().x(), 6.0f);
  TextureCache cache;
  const SceneMesh mesh = whole.Finish(&cache);
  mesh.Validate();
  EXPECT_EQ(mesh.materials.size(), 2u);
  EXPECT_EQ(mesh.textures.size(), 1u);
}

}  // namespace
}  // namespace bulletnav::sim
