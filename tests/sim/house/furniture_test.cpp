// SPDX-License-Identifier: MIT
#include "sim/house/furniture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::sim {

static void PrintTo(const FurnitureKind& kind, std::ostream* out) {
  *out << kind.name;
}

namespace {

using Vec = MeshBuilder::Vec;

constexpr std::uint64_t kSeeds = 20;

const std::array kPalettes = {Palette{.wood = {"oak"},
                                      .other_wood = {"beech"},
                                      .metal = {"black_metal"},
                                      .fabric = {"tweed", {175, 178, 182}},
                                      .accent = {"linen", {92, 128, 138}},
                                      .other_accent = {"linen", {214, 160, 80}},
                                      .bedding = {"linen"},
                                      .cabinet = {"painted_wood"},
                                      .counter = {"oak"},
                                      .backsplash = {"white_subway_tile"},
                                      .appliance = {"white_enamel"},
                                      .ceramic = {"ceramic"},
                                      .rug = {"shag_carpet"},
                                      .shade = {"lamp_shade"}},
                              Palette{.wood = {"walnut"},
                                      .other_wood = {"mahogany"},
                                      .metal = {"brass"},
                                      .fabric = {"velvet", {60, 90, 75}},
                                      .accent = {"velvet", {150, 48, 52}},
                                      .other_accent = {"linen", {200, 170, 110}},
                                      .bedding = {"quilt"},
                                      .cabinet = {"painted_wood", {92, 112, 104}},
                                      .counter = {"white_marble"},
                                      .backsplash = {"white_square_tile"},
                                      .appliance = {"brushed_steel"},
                                      .ceramic = {"ceramic"},
                                      .rug = {"persian_rug"},
                                      .shade = {"lamp_shade"},
                                      .handles = Handles::kKnob,
                                      .framed_fronts = true},
                              Palette{.wood = {"beech"},
                                      .other_wood = {"painted_wood", {70, 80, 95}},
                                      .metal = {"chrome"},
                                      .fabric = {"linen", {220, 190, 90}},
                                      .accent = {"linen", {210, 90, 70}},
                                      .other_accent = {"linen", {70, 120, 160}},
                                      .bedding = {"striped_cotton"},
                                      .cabinet = {"painted_wood", {120, 150, 175}},
                                      .counter = {"grey_granite"},
                                      .backsplash = {"green_subway_tile"},
                                      .appliance = {"white_enamel", {80, 80, 84}},
                                      .ceramic = {"ceramic"},
                                      .rug = {"geometric_rug"},
                                      .shade = {"lamp_shade"},
                                      .handles = Handles::kNone}};

SceneMesh MeshOf(const Piece& piece) {
  MeshBuilder copy;
  copy.Append(piece.mesh);
  TextureCache cache;
  return copy.Finish(&cache);
}

Piece Build(const FurnitureKind& kind, std::uint64_t seed, const PieceRequest& request = {}) {
  return BuildPiece(kind, Rng(seed, kind.name), kPalettes[seed % kPalettes.size()], request);
}

/// What may stand, hang or lie where a piece's placement puts it, metres.
struct SizeRule {
  float max_across = 3.0f;
  float max_deep = 2.3f;
  float min_high = 0.05f;
  float max_high = 2.4f;
};

SizeRule RuleOf(Placement placement) {
  switch (placement) {
    case Placement::kAgainstWall:
    case Placement::kCorner:
      return {3.0f, 2.3f, 0.3f, 2.4f};
    case Placement::kFree:
      return {2.6f, 2.3f, 0.05f, 2.1f};
    case Placement::kOnWall:
      return {2.6f, 0.45f, 0.05f, 2.5f};
    case Placement::kCeiling:
      return {1.3f, 1.3f, 0.05f, 1.6f};
    case Placement::kOnTop:
      return {0.7f, 0.5f, 0.01f, 0.7f};
    case Placement::kRug:
      return {3.2f, 2.3f, 0.005f, 0.03f};
  }
  return {};
}

bool IsBackedByWall(Placement placement) {
  return placement == Placement::kAgainstWall || placement == Placement::kCorner ||
         placement == Placement::kOnWall;
}

class FurnitureTest : public testing::TestWithParam<FurnitureKind> {};

TEST_P(FurnitureTest, LiesInItsFrameAndIsOfSaneSize) {
  const FurnitureKind& kind = GetParam();
  SizeRule rule = RuleOf(kind.placement);
  if (kind.name == "car") rule.max_across = 5.0f;
  constexpr float kEps = 1e-3f;
  for (std::uint64_t seed = 0; seed < 3 * kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const Eigen::AlignedBox3f box = Build(kind, seed).mesh.Bounds();
    const Vec size = box.sizes();
    EXPECT_NEAR(box.center().x(), 0.0f, kEps);
    EXPECT_NEAR(IsBackedByWall(kind.placement) ? box.min().z() : box.center().z(), 0.0f, kEps);
    if (kind.placement == Placement::kCeiling) {
      EXPECT_NEAR(box.max().y(), 0.0f, kEps);
    } else if (kind.placement == Placement::kOnWall) {
      EXPECT_GE(box.min().y(), -kEps);
      EXPECT_LE(box.min().y(), 0.15f);
    } else if (kind.placement == Placement::kAgainstWall && box.min().y() > kEps) {
      EXPECT_THAT(box.min().y(), testing::AllOf(testing::Ge(0.05f), testing::Le(0.3f)));  // hung
    } else {
      EXPECT_NEAR(box.min().y(), 0.0f, kEps);
    }
    EXPECT_LE(size.x(), rule.max_across);
    EXPECT_LE(size.z(), rule.max_deep);
    EXPECT_GE(size.y(), rule.min_high);
    EXPECT_LE(size.y(), rule.max_high);
    EXPECT_GE(std::max(size.x(), size.z()), 0.03f);
  }
}

TEST_P(FurnitureTest, MakesValidMeshesWithinTheTriangleBudget) {
  const FurnitureKind& kind = GetParam();
  const bool is_small = kind.placement == Placement::kOnTop;
  for (std::uint64_t seed = 0; seed < 3 * kSeeds; ++seed) {
    const Piece piece = Build(kind, seed);
    const SceneMesh mesh = MeshOf(piece);
    mesh.Validate();
    EXPECT_EQ(piece.mesh.glows().size(), mesh.triangles.size());
    EXPECT_LE(mesh.triangles.size(), is_small ? 350u : 1000u) << seed;
    for (const Vec& p : mesh.positions) ASSERT_TRUE(p.allFinite());
    for (const auto& uv : mesh.uvs) ASSERT_TRUE(uv.allFinite());
  }
}

/// True if the nearest thing on the ray from `eye` along `way` shows its back.
bool SeesABack(const SceneMesh& mesh, const std::vector<bool>& is_thin, const Vec& eye,
               const Vec& way) {
  float nearest = 1e9f;
  bool is_back = false;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Vec& a = mesh.positions[t[0]];
    const Vec u = mesh.positions[t[1]] - a;
    const Vec v = mesh.positions[t[2]] - a;
    const Vec normal = u.cross(v);
    const float facing = way.dot(normal);
    if (std::abs(facing) < 1e-12f) continue;
    const float distance = (a - eye).dot(normal) / facing;
    if (distance <= 0.0f || distance > nearest + 2e-3f) continue;
    const Vec p = eye + distance * way - a;
    const float b = p.cross(v).dot(normal) / normal.squaredNorm();
    const float c = u.cross(p).dot(normal) / normal.squaredNorm();
    if (b < 0.0f || c < 0.0f || b + c > 1.0f) continue;
    const bool faces_eye = facing < 0.0f || is_thin[mesh.triangle_materials[i]];
    // Of two faces in one place the one that faces the eye counts.
    is_back = std::abs(distance - nearest) < 2e-3f ? is_back && !faces_eye : !faces_eye;
    nearest = std::min(nearest, distance);
  }
  return is_back;
}

TEST_P(FurnitureTest, ShowsItsFrontsFromWherePeopleAre) {
  const FurnitureKind& kind = GetParam();
  if (kind.name == "curtain" || kind.name == "play_tent") return;  // cloth, seen from both sides
  int backs = 0;
  constexpr int kRays = 400;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const SceneMesh mesh = MeshOf(Build(kind, seed));
    std::vector<bool> is_thin;
    for (const Material& material : mesh.materials) is_thin.push_back(material.name == "leaves");
    const Eigen::AlignedBox3f box = mesh.Bounds();
    Rng rng(seed, "eyes");
    for (int i = 0; i < kRays; ++i) {
      const bool is_backed = IsBackedByWall(kind.placement);
      const double angle = is_backed ? rng.Uniform(0.3, 2.84) : rng.Uniform(0.0, 6.28);
      const auto x = static_cast<float>(2.5 * std::cos(angle));
      const auto z = static_cast<float>(2.5 * std::sin(angle));
      const bool is_above = kind.placement != Placement::kCeiling;
      const float up = is_above ? box.max().y() + 0.3f : box.min().y() - 0.7f;
      const Vec target =
          box.min() + Vec(static_cast<float>(rng.Uniform()), static_cast<float>(rng.Uniform()),
                          static_cast<float>(rng.Uniform()))
                          .cwiseProduct(box.sizes());
      const Vec eye(x, up, z + (is_backed ? box.max().z() : 0.0f));
      backs += SeesABack(mesh, is_thin, eye, (target - eye).normalized()) ? 1 : 0;
    }
  }
  EXPECT_LE(backs, 3 * kRays / 100) << "of " << 3 * kRays << " rays";
}

TEST_P(FurnitureTest, IsTheSameForTheSameSeedAndElseNot) {
  const FurnitureKind& kind = GetParam();
  std::set<std::string> looks;
  for (std::uint64_t seed = 0; seed < 2 * kPalettes.size(); ++seed) {
    const SceneMesh mesh = MeshOf(Build(kind, seed));
    const SceneMesh again = MeshOf(Build(kind, seed));
    ASSERT_EQ(mesh.positions, again.positions);
    ASSERT_EQ(mesh.triangle_materials, again.triangle_materials);
    std::string look;
    for (const Vec& p : mesh.positions) {
      look.append(reinterpret_cast<const char*>(p.data()), sizeof(float) * 3);
    }
    for (const Material& material : mesh.materials) {
      look += material.name;
      for (const std::uint8_t channel : material.base_color) look += static_cast<char>(channel);
    }
    looks.insert(look);
  }
  EXPECT_GE(looks.size(), 4u);
}

TEST_P(FurnitureTest, OffersTopsThatItHas) {
  const FurnitureKind& kind = GetParam();
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Piece piece = Build(kind, seed);
    const Eigen::AlignedBox3f box = piece.mesh.Bounds();
    float last = 1e9f;
    for (const TopSurface& top : piece.tops) {
      EXPECT_GT(top.height, 0.1f);
      EXPECT_LE(top.height, box.max().y() + 1e-3f);
      EXPECT_GE(top.area.min().x(), box.min().x() - 0.02f);
      EXPECT_LE(top.area.max().x(), box.max().x() + 0.02f);
      EXPECT_GE(top.area.min().y(), box.min().z() - 0.02f);
      EXPECT_LE(top.area.max().y(), box.max().z() + 0.02f);
      EXPECT_GT(top.area.sizes().minCoeff(), 0.05f);
      EXPECT_LE(top.area.volume(), last);
      last = top.area.volume();
    }
  }
}

TEST_P(FurnitureTest, TakesTheWidthAskedForIfItStretches) {
  const FurnitureKind& kind = GetParam();
  const bool stretches = kind.max_width > 0.0f;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const float part = static_cast<float>(seed) / static_cast<float>(kSeeds - 1);
    const float width =
        stretches ? kind.min_width + part * (kind.max_width - kind.min_width) : 1.0f;
    const Piece asked = Build(kind, seed, {.width = width});
    const float got = asked.mesh.Bounds().sizes().x();
    if (stretches) {
      EXPECT_LE(got, width + 1e-3f) << width;
      EXPECT_GE(got, width - 0.1f) << width;
    } else {
      EXPECT_FLOAT_EQ(got, Build(kind, seed).mesh.Bounds().sizes().x());
    }
  }
}

std::string NameOf(const testing::TestParamInfo<FurnitureKind>& info) {
  return std::string(info.param.name);
}

INSTANTIATE_TEST_SUITE_P(All, FurnitureTest,
                         testing::ValuesIn(AllFurniture().begin(), AllFurniture().end()), NameOf);

TEST(Furniture, IsListedByNameOnce) {
  const auto all = AllFurniture();
  EXPECT_GE(all.size(), 100u);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.name < b.name;
  }));
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_NE(all[i - 1].name, all[i].name);
  for (const FurnitureKind& kind : all) EXPECT_EQ(&FindFurniture(kind.name), &kind);
}

TEST(Furniture, HelpsWithAnUnknownName) {
  try {
    FindFurniture("duoble_bed");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'double_bed'"));
  }
}

TEST(Furniture, WindowDressingReachesAsFarDownAsAsked) {
  for (const char* name : {"curtain", "blind"}) {
    for (const float height : {0.8f, 1.3f, 2.3f}) {
      const Piece piece = Build(FindFurniture(name), 3, {.width = 1.5f, .height = height});
      EXPECT_NEAR(piece.mesh.Bounds().max().y(), height, 0.02f) << name;
      EXPECT_NEAR(piece.mesh.Bounds().min().y(), 0.0f, 0.02f) << name;
    }
  }
}

TEST(Furniture, LeavesRoomForAWindowAbove) {
  for (const char* name : {"kitchen_counter", "kitchen_sink_counter", "stove", "dishwasher",
                           "washbasin", "pedestal_basin", "bathtub", "radiator"}) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Piece piece = Build(FindFurniture(name), seed, {.height = 1.25f});
      EXPECT_LE(piece.mesh.Bounds().max().y(), 1.25f) << name << seed;
    }
  }
}

TEST(Furniture, KitchenRunsHaveTheirWorktopsInLine) {
  for (const char* name : {"kitchen_counter", "kitchen_sink_counter", "dishwasher"}) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      for (const TopSurface& top : Build(FindFurniture(name), seed).tops) {
        EXPECT_FLOAT_EQ(top.height, 0.9f) << name;
      }
    }
  }
}

TEST(Furniture, LampsGiveLight) {
  for (const char* name : {"floor_lamp", "table_lamp", "wall_lamp", "desk_lamp", "ceiling_lamp",
                           "pendant_lamp", "chandelier", "fan_lamp"}) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Piece piece = Build(FindFurniture(name), seed);
      EXPECT_THAT(piece.mesh.glows(), testing::Contains(Glow::kLamp)) << name << seed;
    }
  }
}

}  // namespace
}  // namespace bulletnav::sim
