// SPDX-License-Identifier: MIT
#include "sim/scene/export_scene.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/scene/import.h"
#include "sim/scene/submesh.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

void AddObject(const SceneObject& object, const Vec& low, const Vec& high, SceneMesh* mesh) {
  tests::AddBox(low, high, {static_cast<std::uint8_t>(40 * mesh->objects.size()), 90, 20}, mesh);
  mesh->objects.push_back(object);
  mesh->triangle_objects.resize(mesh->triangles.size(),
                                static_cast<std::uint32_t>(mesh->objects.size()) - 1);
}

/// A room with two chairs and a door, one of whose names is no file name.
SceneMesh Furnished() {
  SceneMesh mesh = tests::BoxRoom(6, 3, 8);
  mesh.textures.push_back({"wood", Image(8, 8, 4)});
  for (std::size_t i = 0; i < mesh.textures[0].image.pixels.size(); ++i) {
    mesh.textures[0].image.pixels[i] = i % 4 == 3 ? 255 : 120;
  }
  mesh.materials[0].texture = 0;
  mesh.objects = {{}, {"wall", "wall_1", "hall_1"}};
  mesh.triangle_objects.assign(mesh.triangles.size(), 1);
  mesh.triangle_objects[0] = 0;
  AddObject({"chair", "chair_1", "hall_1"}, {1, 0, -2}, {1.5f, 1, -1.5f}, &mesh);
  AddObject({"chair", "chair/2", "hall_1"}, {3, 0, -6}, {3.5f, 1, -5.25f}, &mesh);
  AddObject({"door", "door_1", ""}, {5, 0, -4}, {5.1f, 2, -3}, &mesh);
  return mesh;
}

/// What a triangle is: its object, its colour and its corners, to a tenth of a millimetre.
using Fact = std::tuple<std::string, std::string, std::string, Rgb8, std::vector<long>>;

std::vector<Fact> FactsOf(const SceneMesh& mesh) {
  std::vector<Fact> facts;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const SceneObject& object = mesh.objects[mesh.triangle_objects[t]];
    const Material& material = mesh.materials[mesh.triangle_materials[t]];
    std::vector<long> corners;
    for (const std::uint32_t v : mesh.triangles[t]) {
      for (int i = 0; i < 3; ++i) corners.push_back(std::lround(1e4 * mesh.positions[v][i]));
    }
    facts.emplace_back(object.category, object.name, object.room, material.base_color, corners);
  }
  std::sort(facts.begin(), facts.end());
  return facts;
}

class ExportFormat : public testing::TestWithParam<SceneFormat> {};

TEST_P(ExportFormat, IsReadBackAsTheSameScene) {
  const tests::TemporaryFolder folder;
  const SceneMesh mesh = Furnished();
  const auto file = ExportScene(mesh, "house_1", GetParam(), folder.path());
  ExportScene(tests::BoxRoom(3, 3, 3), "other", GetParam(), folder.path());
  const ImportedScene back = ImportScene(file);
  EXPECT_EQ(FactsOf(back.mesh), FactsOf(mesh));
  EXPECT_EQ(back.mesh.textures.size(), 1u);
  EXPECT_TRUE(back.report.textures_missing.empty());
  EXPECT_TRUE(back.report.skipped.empty());
}

TEST_P(ExportFormat, SameSceneGivesTheSameBytes) {
  const tests::TemporaryFolder a;
  const tests::TemporaryFolder b;
  EXPECT_EQ(ReadTextFile(ExportScene(Furnished(), "h", GetParam(), a.path())),
            ReadTextFile(ExportScene(Furnished(), "h", GetParam(), b.path())));
}

TEST_P(ExportFormat, NamesThatAreNoFileNamesAreRefused) {
  const tests::TemporaryFolder folder;
  for (const char* name : {"", "a/b", "..", "a b", "<x>"}) {
    EXPECT_THROW(ExportScene(Furnished(), name, GetParam(), folder.path()), Error) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ExportFormat,
                         testing::Values(
#ifdef BULLETNAV_READS_SDF
                             SceneFormat::kSdf,
#endif
                             SceneFormat::kSceneInstance));

TEST(Submesh, KeepsWhatItsTrianglesUse) {
  const SceneMesh mesh = Furnished();
  const SceneMesh part = Submesh(mesh, {3, 12});
  part.Validate();
  EXPECT_EQ(part.triangles.size(), 2u);
  EXPECT_EQ(part.positions.size(), 6u);
  EXPECT_EQ(part.materials.size(), 2u);
  EXPECT_EQ(part.objects[part.triangle_objects[1]].name, "chair_1");
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(part.positions[part.triangles[1][i]], mesh.positions[mesh.triangles[12][i]]);
  }
}

}  // namespace
}  // namespace bulletnav::sim
