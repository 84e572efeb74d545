// SPDX-License-Identifier: MIT
#include "sim/scene/finish.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/scene/mesh_measures.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

/// A level square of two triangles at a height, facing up or down.
void AddLevel(float height, float size, bool up, std::uint32_t material, SceneMesh* mesh) {
  const auto first = static_cast<std::uint32_t>(mesh->positions.size());
  for (const auto& [x, z] : {std::pair{0.0f, 0.0f}, {size, 0.0f}, {size, size}, {0.0f, size}}) {
    mesh->positions.emplace_back(x, height, z);
    mesh->uvs.emplace_back(x, z);
    mesh->colors.push_back({100, 110, 120});
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh->triangles.push_back(up ? std::array{first + a, first + c, first + b}
                                 : std::array{first + a, first + b, first + c});
    mesh->triangle_materials.push_back(material);
  };
  add(0, 1, 2);
  add(0, 2, 3);
}

/// Floor at .02 m, table top at .75 m, ceiling at 2.6 m; a texture on all.
SceneMesh Room() {
  SceneMesh mesh;
  Image picture(2, 2, 4);
  picture.pixels = {10, 20, 30, 255, 30, 40, 50, 255, 50, 60, 70, 255, 70, 80, 90, 255};
  mesh.textures = {{"wood", picture}};
  mesh.materials = {{"wood", {255, 255, 255}, 0}, {"paint", {200, 100, 50}, -1}};
  AddLevel(0.02f, 4, true, 0, &mesh);
  AddLevel(0.75f, 1, true, 0, &mesh);
  AddLevel(2.6f, 4, false, 1, &mesh);
  mesh.Validate();
  return mesh;
}

TEST(Finish, ByItselfChangesNothing) {
  SceneMesh mesh = Room();
  ApplyFinish({}, &mesh);
  EXPECT_EQ(mesh.triangles, Room().triangles);
  EXPECT_EQ(mesh.textures[0].image.pixels, Room().textures[0].image.pixels);
}

TEST(Finish, LeavesOutBackFaces) {
  SceneMesh mesh = Room();
  Finish finish;
  finish.back_faces = false;
  ApplyFinish(finish, &mesh);
  EXPECT_FALSE(mesh.back_faces);
  EXPECT_EQ(mesh.triangles, Room().triangles);
}

TEST(Finish, TheFloorIsWhereMostFacesUp) {
  EXPECT_NEAR(FloorHeight(Room()), 0.02f, 0.1f);
  SceneMesh low = Room();
  for (auto& p : low.positions) p.y() -= 1.3f;
  EXPECT_NEAR(FloorHeight(low), -1.28f, 0.1f);
}

TEST(Finish, ARoofLargerThanTheFloorIsNoFloor) {
  SceneMesh mesh = Room();
  AddLevel(2.8f, 5, true, 1, &mesh);
  EXPECT_NEAR(FloorHeight(mesh), 0.02f, 0.1f);
}

TEST(Finish, OfTwoStoreysTheLowerIsTheFloor) {
  SceneMesh mesh = Room();
  AddLevel(2.9f, 4.4f, true, 1, &mesh);
  EXPECT_NEAR(FloorHeight(mesh), 0.02f, 0.1f);
}

TEST(Finish, WithoutCeilingTheRestStays) {
  SceneMesh mesh = Room();
  ApplyFinish({.ceiling = false}, &mesh);
  mesh.Validate();
  ASSERT_EQ(mesh.triangles.size(), 4u);
  for (const auto& triangle : mesh.triangles) EXPECT_LT(mesh.positions[triangle[0]].y(), 1.0f);
}

TEST(Finish, AMeshThatIsAllOverheadStays) {
  SceneMesh mesh;
  mesh.materials = {{"paint"}};
  AddLevel(0, 1, true, 0, &mesh);
  mesh.triangles.resize(1);
  mesh.triangle_materials.resize(1);
  ApplyFinish({.ceiling = false}, &mesh);
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Finish, BlackOverheadIsTheCeilingAlone) {
  SceneMesh mesh = Room();
  ApplyFinish({.black_overhead = true}, &mesh);
  mesh.Validate();
  ASSERT_EQ(mesh.triangles.size(), Room().triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool is_overhead = LowestOf(mesh, t) > 2.0f;
    const Material& material = mesh.materials[mesh.triangle_materials[t]];
    EXPECT_EQ(material.base_color[0] < 20 && material.texture < 0, is_overhead);
  }
}

TEST(Finish, WhiteKeepsTheLightAndNoColour) {
  SceneMesh mesh = Room();
  ApplyFinish({.surfaces = Surfaces::kAllWhite}, &mesh);
  mesh.Validate();
  EXPECT_TRUE(mesh.textures.empty());
  EXPECT_EQ(mesh.materials[1].base_color, kWhite);
  EXPECT_EQ(mesh.colors[0], (Rgb8{109, 109, 109}));  // of (100, 110, 120)
}

TEST(Finish, BlankWallsAreWhiteAndLowThingsAreNot) {
  SceneMesh mesh = Room();
  mesh.materials.push_back({"brick", {150, 60, 50}, 0});
  mesh.materials.push_back({"counter", {90, 60, 40}, -1});
  const auto add = [&](float height, float z, std::uint32_t material) {
    tests::AddQuad({0, 0, z}, {4, 0, z}, {4, height, z}, {0, height, z}, kWhite, &mesh);
    mesh.triangle_materials.resize(mesh.triangles.size(), material);
    std::fill(mesh.triangle_materials.end() - 2, mesh.triangle_materials.end(), material);
  };
  add(2.6f, 0.0f, 2);
  add(1.4f, 2.0f, 3);
  ApplyFinish({.blank_walls = true}, &mesh);
  mesh.Validate();
  EXPECT_EQ(mesh.materials[2].base_color, kWhite);
  EXPECT_EQ(mesh.materials[2].texture, -1);
  EXPECT_EQ(mesh.materials[3].base_color, (Rgb8{90, 60, 40}));
  EXPECT_EQ(mesh.materials[0].texture, 0);
}

TEST(Finish, AllWhiteLeavesABlankFloorGrey) {
  SceneMesh mesh = Room();
  ApplyFinish({.surfaces = Surfaces::kAllWhite, .blank_floor = true, .baked_light = false}, &mesh);
  mesh.Validate();
  EXPECT_NEAR(mesh.materials[mesh.triangle_materials[0]].base_color[0], 49, 1);
  EXPECT_EQ(mesh.materials[mesh.triangle_materials[4]].base_color, kWhite);
}

TEST(Finish, ABlankFloorIsGreyAndTheTableIsNot) {
  SceneMesh mesh = Room();
  ApplyFinish({.blank_floor = true}, &mesh);
  mesh.Validate();
  const Material& floor = mesh.materials[mesh.triangle_materials[0]];
  EXPECT_EQ(floor.texture, -1);
  EXPECT_EQ(floor.base_color[0], floor.base_color[1]);
  EXPECT_EQ(floor.base_color[1], floor.base_color[2]);
  EXPECT_NEAR(floor.base_color[0], 49, 1);  // the picture's mean is (40, 50, 60)
  EXPECT_EQ(mesh.triangle_materials[2], 0u);
  EXPECT_EQ(mesh.triangle_materials[4], 1u);
}

TEST(Finish, FlatSurfacesHaveTheMeanOfTheirTexture) {
  SceneMesh mesh = Room();
  ApplyFinish({.surfaces = Surfaces::kFlat}, &mesh);
  mesh.Validate();
  EXPECT_TRUE(mesh.textures.empty());
  EXPECT_EQ(mesh.materials[0].base_color, (Rgb8{40, 50, 60}));
  EXPECT_EQ(mesh.materials[1].base_color, (Rgb8{200, 100, 50}));
}

TEST(Finish, ColoursOfVerticesAloneOrNotAtAll) {
  SceneMesh mesh = Room();
  ApplyFinish({.surfaces = Surfaces::kVertexColors}, &mesh);
  EXPECT_EQ(mesh.materials[1].base_color, kWhite);
  EXPECT_EQ(mesh.colors[0], (Rgb8{100, 110, 120}));
  mesh = Room();
  ApplyFinish({.baked_light = false}, &mesh);
  EXPECT_EQ(mesh.colors[0], kWhite);
  EXPECT_EQ(mesh.materials[1].base_color, (Rgb8{200, 100, 50}));
}

TEST(Finish, ShrunkTexturesKeepTheirMean) {
  SceneMesh mesh = Room();
  ApplyFinish({.texture_shrink = 2}, &mesh);
  EXPECT_EQ(mesh.textures[0].image.pixels, (std::vector<std::uint8_t>{40, 50, 60, 255}));
  ApplyFinish({.texture_shrink = 64}, &mesh);
  EXPECT_EQ(mesh.textures[0].image.width, 1);
}

TEST(Finish, DevelopsByExposureContrastSaturationAndTint) {
  SceneMesh mesh = Room();
  ApplyFinish({.exposure = 0.5}, &mesh);
  EXPECT_EQ(mesh.materials[1].base_color, (Rgb8{100, 50, 25}));
  EXPECT_EQ(mesh.materials[0].base_color, kWhite);  // its texture is halved instead
  EXPECT_EQ(mesh.textures[0].image.pixels[0], 5);
  mesh = Room();
  ApplyFinish({.saturation = 0.0}, &mesh);
  EXPECT_EQ(mesh.materials[1].base_color[0], mesh.materials[1].base_color[2]);
  mesh = Room();
  ApplyFinish({.contrast = 0.0, .tint = {0.9, 1.0, 1.0}}, &mesh);
  EXPECT_EQ(mesh.materials[1].base_color, (Rgb8{128, 128, 128}));
}

/// The room as a scan that has its colours at its vertices.
SceneMesh ScannedRoom() {
  SceneMesh mesh = Room();
  mesh.textures.clear();
  mesh.materials = {{"", {255, 255, 255}, -1}, {"", {255, 255, 255}, -1}};
  return mesh;
}

/// Colours as drawn at the corners of a triangle: material times vertex.
std::vector<Rgb8> ColorsOf(const SceneMesh& mesh, std::size_t triangle) {
  std::vector<Rgb8> colors;
  for (const std::uint32_t vertex : mesh.triangles[triangle]) {
    Rgb8 color = mesh.materials[mesh.triangle_materials[triangle]].base_color;
    for (std::size_t c = 0; c < 3; ++c) {
      color[c] = static_cast<std::uint8_t>((color[c] * mesh.colors[vertex][c] + 127) / 255);
    }
    colors.push_back(color);
  }
  return colors;
}

TEST(Finish, DevelopsVerticesWhereTheyGiveTheColours) {
  SceneMesh mesh = ScannedRoom();
  Finish finish;
  finish.exposure = 0.5;
  ApplyFinish(finish, &mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    EXPECT_THAT(ColorsOf(mesh, t), testing::Each(Rgb8{50, 55, 60}));
  }
  mesh = ScannedRoom();
  finish.exposure = 1.0;
  finish.saturation = 0.0;
  ApplyFinish(finish, &mesh);
  const Rgb8 grey = ColorsOf(mesh, 0)[0];
  EXPECT_EQ(grey[0], grey[2]);
  EXPECT_NEAR(grey[0], 0.2126 * 100 + 0.7152 * 110 + 0.0722 * 120, 0.51);
}

TEST(Finish, ABlankFloorReplacesTheColoursOfVertices) {
  SceneMesh mesh = ScannedRoom();
  Finish finish;
  finish.blank_floor = true;
  ApplyFinish(finish, &mesh);
  EXPECT_THAT(ColorsOf(mesh, 0), testing::Each(Rgb8{109, 109, 109}));  // the floor
  EXPECT_THAT(ColorsOf(mesh, 2), testing::Each(Rgb8{100, 110, 120}));  // the table
  mesh.Validate();
  // White and without light all but the floor is white, and factors meet each surface once.
  mesh = ScannedRoom();
  finish.surfaces = Surfaces::kAllWhite;
  finish.baked_light = false;
  finish.exposure = 0.5;
  ApplyFinish(finish, &mesh);
  EXPECT_THAT(ColorsOf(mesh, 0), testing::Each(Rgb8{55, 55, 55}));
  EXPECT_THAT(ColorsOf(mesh, 2), testing::Each(Rgb8{128, 128, 128}));
}

TEST(Finish, RefusesWhatNoPictureSurvives) {
  SceneMesh mesh = Room();
  EXPECT_THROW(ApplyFinish({.texture_shrink = 0}, &mesh), Error);
  EXPECT_THROW(ApplyFinish({.exposure = -1}, &mesh), Error);
  EXPECT_THROW(ApplyFinish({.tint = {1, 11, 1}}, &mesh), Error);
}

}  // namespace
}  // namespace bulletnav::sim
