// SPDX-License-Identifier: MIT
#include "sim/scene/damage.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/scene/clutter.h"
#include "sim/scene/glb_writer.h"
#include "sim/scene/holes.h"
#include "sim/scene/low_poly.h"
#include "sim/scene/mesh_measures.h"
#include "sim/scene/refine.h"
#include "sim/world.h"
#include "tests/support/houses.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

const SceneMesh& House() {
  static const SceneMesh house = [] {
    SceneMesh mesh = tests::ShellHouse(3);
    std::uint8_t light = 0;
    for (Rgb8& color : mesh.colors) color = {++light, 100, 200};
    return mesh;
  }();
  return house;
}

SceneMesh Damaged(const Damage& damage, SceneMesh mesh = House()) {
  ApplyDamage(damage, &mesh);
  mesh.Validate();
  return mesh;
}

bool AreSame(const SceneMesh& a, const SceneMesh& b) {
  const auto same_texture = [](const Texture& x, const Texture& y) {
    return x.image.pixels == y.image.pixels;
  };
  return a.positions == b.positions && a.uvs == b.uvs && a.colors == b.colors &&
         a.triangles == b.triangles && a.triangle_materials == b.triangle_materials &&
         std::equal(a.textures.begin(), a.textures.end(), b.textures.begin(), b.textures.end(),
                    same_texture);
}

double AreaWhere(const SceneMesh& mesh, const std::function<bool(std::size_t)>& counts) {
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (counts(t)) area += AreaOf(mesh, t);
  }
  return area;
}

double FloorArea(const SceneMesh& mesh) {
  const float floor = FloorHeight(House());
  return AreaWhere(mesh, [&](std::size_t t) {
    return IsOnTheFloor(mesh, t, floor);
  });
}

/// A ball of many triangles, standing on nothing.
SceneMesh Ball(float radius, int rings) {
  SceneMesh mesh;
  mesh.materials = {{"wool", {200, 50, 50}, -1}};
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < 2 * rings; ++j) {
      const float polar = 3.14159265f * static_cast<float>(i) / static_cast<float>(rings);
      const float turn = 3.14159265f * static_cast<float>(j) / static_cast<float>(rings);
      mesh.positions.push_back(radius * Eigen::Vector3f(std::sin(polar) * std::cos(turn),
                                                        std::cos(polar),
                                                        std::sin(polar) * std::sin(turn)));
      mesh.uvs.emplace_back(0, 0);
      mesh.colors.push_back(kWhite);
    }
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>(i * 2 * rings + j % (2 * rings));
  };
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < 2 * rings; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  mesh.triangle_materials.assign(mesh.triangles.size(), 0);
  return mesh;
}

struct Kind {
  const char* name;
  Damage damage;
};

const std::vector<Kind> kKinds = {{"low_poly", {.low_poly = 0.2}},
                                  {"color_spacing", {.color_spacing = 0.5}},
                                  {"clutter", {.clutter = 5}},
                                  {"bumps", {.bumps = {.height = 0.02}}},
                                  {"doubled", {.doubled = {.share = 0.2}}},
                                  {"holes", {.holes = {.share = 0.1, .size = 1.5}}},
                                  {"smears", {.smears = {.share = 0.3}}},
                                  {"mirrored", {.mirrored = 0.2}}};

TEST(Damage, ByItselfChangesNothing) {
  EXPECT_TRUE(AreSame(Damaged({}), House()));
  EXPECT_TRUE(AreSame(Damaged({.seed = 5}), House()));
}

TEST(Damage, IsAFunctionOfMeshAndSeed) {
  for (Kind kind : kKinds) {
    const SceneMesh mesh = Damaged(kind.damage);
    EXPECT_FALSE(AreSame(mesh, House()) && kind.damage.low_poly == 0.0) << kind.name;
    EXPECT_TRUE(AreSame(mesh, Damaged(kind.damage))) << kind.name;
    kind.damage.seed = 1;
    const bool is_drawn = kind.damage.low_poly == 0.0 && kind.damage.color_spacing == 0.0;
    EXPECT_EQ(AreSame(mesh, Damaged(kind.damage)), !is_drawn) << kind.name;
  }
}

TEST(Damage, HolesTakeTheShareThatWasAskedForAndLeaveTheFloor) {
  const double floor = FloorArea(House());
  const double rest = AreaOf(House()) - floor;
  for (const double share : {0.02, 0.1, 0.4}) {
    const SceneMesh mesh = Damaged({.holes = {.share = share, .size = 1.5}});
    EXPECT_NEAR(FloorArea(mesh), floor, 1e-3 * floor);
    EXPECT_NEAR((AreaOf(mesh) - floor) / rest, 1.0 - share, 0.01);
  }
  const SceneMesh open = Damaged({.holes = {.share = 0.3, .size = 1.5, .floors = true}});
  EXPECT_NEAR(AreaOf(open) / AreaOf(House()), 0.7, 0.01);
  EXPECT_LT(FloorArea(open), 0.98 * floor);
}

TEST(Damage, DarkAndShinyThingsHaveMoreHoles) {
  SceneMesh mesh;
  mesh.materials = {{"paint", {250, 250, 250}, -1}, {"window", {250, 250, 250}, -1}};
  tests::AddQuad({0, 0, 0}, {40, 0, 0}, {40, 2, 0}, {0, 2, 0}, kWhite, &mesh);
  tests::AddQuad({0, 0, 9}, {40, 0, 9}, {40, 2, 9}, {0, 2, 9}, kWhite, &mesh);
  for (std::size_t t = 0; t < 4; ++t) mesh.triangle_materials[t] = t < 2 ? 0 : 1;
  mesh = Damaged({.holes = {.share = 0.2}}, mesh);
  const auto of = [&](std::uint32_t material) {
    return AreaWhere(mesh, [&](std::size_t t) {
      return mesh.triangle_materials[t] == material;
    });
  };
  EXPECT_LT(of(1), of(0) - 10.0);
}

TEST(Damage, BumpsAreNoHigherThanTheySay) {
  SceneMesh flat = House();
  RefineTo(0.2, &flat);
  const SceneMesh mesh = Damaged({.bumps = {.height = 0.03, .size = 0.4}});
  ASSERT_EQ(mesh.positions.size(), flat.positions.size());
  float most = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Eigen::Vector3f move = (mesh.positions[v] - flat.positions[v]).cwiseAbs();
    EXPECT_LE(move.maxCoeff(), 0.0301f);
    EXPECT_LE(move.y(), 0.0101f);
    most = std::max(most, move.maxCoeff());
  }
  EXPECT_GT(most, 0.02f);
}

TEST(Damage, DoubledSurfacesAreTheShareThatWasAskedFor) {
  const double floor = FloorArea(House());
  const SceneMesh mesh = Damaged({.doubled = {.share = 0.2, .offset = 0.06}});
  EXPECT_NEAR(AreaOf(mesh) / (AreaOf(House()) - floor) - floor / (AreaOf(House()) - floor), 1.2,
              0.03);
  EXPECT_NEAR(FloorArea(mesh), floor, 1e-3 * floor);
}

/// Nowhere that a body gets but along walls and on tops: the rest of the floor's air stays free.
TEST(Damage, ClutterStaysAtWallsAndOnTops) {
  SceneMesh room = tests::BoxRoom(6, 2.5f, 5);
  tests::AddBox({2, 0, -3}, {4, 0.7f, -2}, {90, 60, 40}, &room);
  const std::size_t own = room.positions.size();
  const SceneMesh mesh = Damaged({.clutter = 20}, room);
  EXPECT_GT(mesh.positions.size(), own + 30 * 20);
  int on_tops = 0;
  for (std::size_t v = own; v < mesh.positions.size(); ++v) {
    const Eigen::Vector3f& p = mesh.positions[v];
    const float beside = std::min({p.x(), 6 - p.x(), -p.z(), 5 + p.z(),
                                   std::max({2 - p.x(), p.x() - 4, -3 - p.z(), p.z() + 2})});
    EXPECT_LE(beside, 0.21f) << p.transpose();
    EXPECT_GE(p.y(), -0.01f);
    EXPECT_LE(p.y(), 1.01f);
    on_tops += p.y() > 0.69f ? 1 : 0;
  }
  EXPECT_GT(on_tops, 0);
}

TEST(Damage, LowPolyBallsAreCoarseAndNoSmaller) {
  const SceneMesh ball = Ball(0.3f, 30);
  const SceneMesh mesh = Damaged({.low_poly = 0.15}, ball);
  EXPECT_LT(mesh.triangles.size(), ball.triangles.size() / 5);
  EXPECT_GT(mesh.triangles.size(), 20u);
  EXPECT_NEAR(mesh.Bounds().sizes().x(), 0.6f, 0.1f);
  // A thin one stays a thing.
  EXPECT_GT(Damaged({.low_poly = 0.5}, ball).triangles.size(), 10u);
}

TEST(Damage, TexturesGoIntoVertices) {
  SceneMesh mesh;
  Image picture(2, 1, 4);
  picture.pixels = {200, 100, 50, 255, 20, 40, 60, 255};
  mesh.textures = {{"two", picture}};
  mesh.materials = {{"two", {255, 255, 255}, 0}};
  tests::AddQuad({0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, kWhite, &mesh);
  mesh.triangle_materials.assign(2, 0);
  for (std::size_t v = 0; v < 4; ++v) {
    mesh.uvs[v] = {mesh.positions[v].x() * 0.499f, mesh.positions[v].y() * 0.499f};
  }
  mesh = Damaged({.color_spacing = 0.2}, mesh);
  EXPECT_TRUE(mesh.textures.empty());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Rgb8 seen = mesh.positions[v].x() < 1.002f ? Rgb8{200, 100, 50} : Rgb8{20, 40, 60};
    EXPECT_EQ(mesh.colors[v], seen) << mesh.positions[v].transpose();
  }
}

TEST(Damage, SmearsKeepTexturesMeans) {
  SceneMesh mesh = tests::BoxRoom(4, 2.5f, 3);
  Image picture(64, 64, 4);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      std::fill_n(picture.at(x, y), 4, (x / 4 + y / 4) % 2 == 0 ? 250 : 10);
    }
  }
  mesh.textures = {{"checks", picture}};
  mesh.materials[0].texture = 0;
  const auto changed = [&](double share) {
    const SceneMesh smeared = Damaged({.smears = {.share = share, .length = 0.2}}, mesh);
    EXPECT_NEAR(MeanOf(smeared.textures[0].image)[0], 130, 15);
    int count = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
      count += smeared.textures[0].image.pixels[i] != picture.pixels[i] ? 1 : 0;
    }
    return count / (64.0 * 64.0);
  };
  EXPECT_NEAR(changed(0.3), 0.3, 0.05);
  EXPECT_NEAR(changed(0.8), 0.8, 0.12);
}

TEST(Damage, AMirroringFloorOpensOnTheRoomUpsideDown) {
  const double floor = FloorArea(House());
  const SceneMesh mesh = Damaged({.mirrored = 0.3});
  EXPECT_NEAR(FloorArea(mesh), 0.7 * floor, 0.02 * floor);
  EXPECT_NEAR(mesh.Bounds().min().y(), -House().Bounds().max().y(), 0.3);
}

/// Bodies and ways know nothing of damage; eyes do.
TEST(Damage, IsForTheEyeAlone) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "house.glb";
  WriteFileAtomically(file, EncodeGlb(House()));
  WorldOptions options;
  options.import.finish.damage = {.clutter = 4,
                                  .bumps = {.height = 0.02},
                                  .holes = {.share = 0.2, .size = 1.5, .floors = true},
                                  .mirrored = 0.3};
  const ImportedScene plain = ImportScene(file);
  const ImportedScene damaged = ImportScene(file, options.import);
  EXPECT_FALSE(plain.drawn);
  ASSERT_TRUE(damaged.drawn);
  EXPECT_TRUE(AreSame(plain.mesh, damaged.mesh));
  EXPECT_FALSE(AreSame(plain.drawn_mesh(), damaged.drawn_mesh()));
  const NavmeshSpec spec;
  // And where floors have no holes, ways are found in what is drawn, too.
  const float area = Navmesh(plain.mesh, spec).area();
  const SceneMesh kept =
      Damaged({.clutter = 4, .bumps = {.height = 0.02}, .holes = {.share = 0.05, .size = 1.5}});
  EXPECT_NEAR(Navmesh(kept, spec).area(), area, 0.1f * area);
}

TEST(Damage, RefusesWhatIsNone) {
  EXPECT_THROW(Damage{.low_poly = -1}.Validate(), Error);
  EXPECT_THROW(Damage{.color_spacing = 0.001}.Validate(), Error);
  EXPECT_THROW((Damage{.holes = {.share = 1.5}}.Validate()), Error);
  EXPECT_THROW((Damage{.bumps = {.height = 1.0}}.Validate()), Error);
  EXPECT_THROW((Damage{.doubled = {.share = 0.1, .offset = 1.0}}.Validate()), Error);
}

}  // namespace
}  // namespace bulletnav::sim
