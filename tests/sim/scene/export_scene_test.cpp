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

/// The same room with a second door that opens the other way and one that leads outside, all shut.
struct Hinged {
  SceneMesh mesh = Furnished();
  std::vector<DoorLeaf> doors;

  Hinged() {
    AddObject({"door", "door_2", ""}, {1, 0, -8}, {2, 2, -7.95f}, &mesh);
    AddObject({"door", "door_3", ""}, {3, 0, -8}, {4, 2, -7.95f}, &mesh);
    DoorLeaf door;
    door.object = "door_1";
    door.hinge = {5.1f, 0, -3};
    door.open_angle = 1.9f;  // more than a quarter turn
    doors.push_back(door);
    door.object = "door_2";
    door.hinge = {1, 0, -7.95f};
    door.axis = -Vec::UnitY();
    door.open_angle = 1.2f;
    doors.push_back(door);
    door.object = "door_3";
    door.hinge = {3, 0, -7.95f};
    door.leads_outside = true;
    doors.push_back(door);
  }
  Hinged& Set(DoorState state) {
    SetDoors({.state = state}, "", &doors, &mesh);
    return *this;
  }
};

bool IsNear(const SceneMesh& a, std::size_t t, const SceneMesh& b, std::size_t u) {
  if (a.objects[a.triangle_objects[t]] != b.objects[b.triangle_objects[u]]) return false;
  if (a.materials[a.triangle_materials[t]].base_color !=
      b.materials[b.triangle_materials[u]].base_color) {
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec& p = a.positions[a.triangles[t][k]];
    if ((p - b.positions[b.triangles[u][k]]).norm() > 1e-5f) return false;
  }
  return true;
}

/// As many triangles, and near each one of the same object and colour.
void ExpectSameTriangles(const SceneMesh& a, const SceneMesh& b) {
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t t = 0; t < a.triangles.size(); ++t) {
    bool is_there = false;
    for (std::size_t u = 0; u < b.triangles.size() && !is_there; ++u) is_there = IsNear(a, t, b, u);
    EXPECT_TRUE(is_there) << a.objects[a.triangle_objects[t]].name << ", triangle " << t;
  }
}

TEST_P(ExportFormat, DoorsOpenAndCloseAsBefore) {
  for (const auto& [before, after] : {std::pair{DoorState::kClosed, DoorState::kOpen},
                                      {DoorState::kOpen, DoorState::kClosed},
                                      {DoorState::kOpen, DoorState::kAsBuilt}}) {
    const tests::TemporaryFolder folder;
    Hinged wanted = Hinged().Set(before);
    const auto file = ExportScene(wanted.mesh, "house_1", GetParam(), folder.path(), wanted.doors);
    ImportOptions options;
    options.doors = DoorSpec{.state = after};
    const ImportedScene back = ImportScene(file, options);
    wanted.Set(after);
    ExpectSameTriangles(wanted.mesh, back.mesh);
    ASSERT_EQ(back.doors.size(), 2u);  // the one that leads outside has no hinge
    for (std::size_t i = 0; i < 2; ++i) {
      const DoorLeaf& door = back.doors[i];
      EXPECT_EQ(door.object, wanted.doors[i].object);
      EXPECT_EQ(door.hinge, wanted.doors[i].hinge);
      EXPECT_EQ(door.axis, wanted.doors[i].axis);
      EXPECT_EQ(door.angle, wanted.doors[i].angle);
      EXPECT_EQ(door.shut_angle, wanted.doors[i].shut_angle);
      EXPECT_EQ(door.open_angle, wanted.doors[i].open_angle);
      EXPECT_NEAR(door.width, wanted.doors[i].width, 1e-5f);
    }
    EXPECT_TRUE(back.report.skipped.empty());
  }
}

TEST_P(ExportFormat, ScenesWithAndWithoutHingesShareAFolder) {
  const tests::TemporaryFolder folder;
  const auto still = ExportScene(Furnished(), "still", GetParam(), folder.path());
  const Hinged hinged;
  const auto file = ExportScene(hinged.mesh, "hinged", GetParam(), folder.path(), hinged.doors);
  ImportOptions options;
  options.doors.emplace();
  EXPECT_EQ(ImportScene(file, options).doors.size(), 2u);
  EXPECT_EQ(ImportScene(still, options).doors.size(), 0u);
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
