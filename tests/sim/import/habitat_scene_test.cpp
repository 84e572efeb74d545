// SPDX-License-Identifier: MIT
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "sim/scene/import.h"
#include "tests/support/imports.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::BoxOf;
using tests::ExpectBox;
using tests::ImportError;
using tests::TemporaryFolder;
using Vec = Eigen::Vector3f;

constexpr const char* kDatasetConfig = R"({
  "stages": {"paths": {".json": ["configs/stages"]}},
  "objects": {"paths": {".json": ["objects/*"], ".glb": ["bare"]},
              "configs": [{"original_file": "objects/a/box.object_config.json",
                           "template_handle": "tall_box", "attributes": {"scale": [1, 2, 1]}}]},
  "scene_instances": {"paths": {".json": ["scenes"]}}
})";

/// A data set of a room, a box of 1 x 1 x 1 m whose origin is its lowest corner, and the same box
/// lying z up in millimetres.
class HabitatScene : public testing::Test {
 protected:
  void SetUp() override {
    folder_.Write("tiny.scene_dataset_config.json", kDatasetConfig);
    folder_.Write("zzz.scene_dataset_config.json", "{}");
    WriteMesh("stages/room.glb", tests::BoxRoom(8, 3, 8));
    folder_.Write("configs/stages/room.stage_config.json",
                  R"({"render_asset": "../../stages/room.glb", "up": [0, 1, 0]})");
    SceneMesh box;
    tests::AddBox(Vec::Zero(), Vec::Ones(), kWhite, &box);
    WriteMesh("objects/a/box.glb", box);
    WriteMesh("bare/stone.glb", box);
    folder_.Write("objects/a/box.object_config.json", R"({"render_asset": "box.glb"})");
    SceneMesh lying;
    tests::AddBox(Vec::Zero(), {1000, 2000, 3000}, kWhite, &lying);
    WriteMesh("objects/b/crate.glb", lying);
    folder_.Write("objects/b/crate.object_config.json",
                  R"({"render_asset": "crate.glb", "up": [0, 0, 1], "front": [0, 1, 0],
                      "units_to_meters": 0.001, "COM": [0, 0, 0]})");
  }

  void WriteMesh(const std::string& name, const SceneMesh& mesh) const {
    WriteFileAtomically(folder_.path() / name, EncodeGlb(mesh));
  }
  std::filesystem::path Scene(const std::string& json) const {
    return folder_.Write("scenes/one.scene_instance.json", json);
  }
  std::filesystem::path With(const std::string& objects, const std::string& more = "") const {
    return Scene(R"({"stage_instance": {"template_name": "stages/room"}, "object_instances": [)" +
                 objects + "]" + more + "}");
  }

  TemporaryFolder folder_;
};

TEST_F(HabitatScene, IsStageAndObjectsInOneMesh) {
  const ImportedScene scene = ImportScene(With(
      R"({"template_name": "box", "translation": [2, 0.5, -3]},
         {"template_name": "a/box", "translation": [4, 1, -4], "uniform_scale": 2})"));
  EXPECT_EQ(scene.report.triangles, 12u + 12 + 12);
  ExpectBox(BoxOf(scene.mesh, "stage_1"), Vec(0, 0, -8), Vec(8, 3, 0));
  // The middle of the box is placed where nothing else is said.
  ExpectBox(BoxOf(scene.mesh, "box_1"), Vec(1.5f, 0, -3.5f), Vec(2.5f, 1, -2.5f));
  ExpectBox(BoxOf(scene.mesh, "box_2"), Vec(3, 0, -5), Vec(5, 2, -3));
  EXPECT_EQ(scene.mesh.objects[2].category, "box");
  EXPECT_TRUE(scene.report.skipped.empty());
}

TEST_F(HabitatScene, OriginScaleAndRotationOfInstances) {
  // A quarter turn about y takes x to -z.
  const ImportedScene scene = ImportScene(With(
      R"({"template_name": "box", "translation": [2, 0.1, -3], "non_uniform_scale": [2, 1, 1],
          "rotation": [0.70710678, 0, 0.70710678, 0]},
         {"template_name": "box", "translation": [4, 0.5, -4], "translation_origin": "COM"},
         {"template_name": "tall_box", "translation": [6, 0.2, -6]})",
      R"(, "translation_origin": "asset_local")"));
  ExpectBox(BoxOf(scene.mesh, "box_1"), Vec(2, 0.1f, -5), Vec(3, 1.1f, -3));
  ExpectBox(BoxOf(scene.mesh, "box_2"), Vec(3.5f, 0, -4.5f), Vec(4.5f, 1, -3.5f));
  ExpectBox(BoxOf(scene.mesh, "tall_box_1"), Vec(6, 0.2f, -6), Vec(7, 2.2f, -5));
}

TEST_F(HabitatScene, TemplatesTurnScaleAndCentreTheirMeshes) {
  // Up z and front y, so that the scene's (x, y, z) are the file's (x, z, -y).
  const ImportedScene scene =
      ImportScene(With(R"({"template_name": "crate", "translation": [1, 0, -1]},
                          {"template_name": "stone", "translation": [5, 0.5, -5]})"));
  ExpectBox(BoxOf(scene.mesh, "crate_1"), Vec(1, 0, -3), Vec(2, 3, -1));
  ExpectBox(BoxOf(scene.mesh, "stone_1"), Vec(4.5f, 0, -5.5f), Vec(5.5f, 1, -4.5f));
}

TEST_F(HabitatScene, AFileThatNamesItsObjectsKeepsThem) {
  SceneMesh room = tests::BoxRoom(8, 3, 8);
  room.objects = {{}, {"wall", "wall_7", "hall_1"}};
  room.triangle_objects.assign(room.triangles.size(), 1);
  WriteMesh("stages/room.glb", room);
  const SceneMesh mesh = ImportScene(With(R"({"template_name": "box"})")).mesh;
  EXPECT_THAT(mesh.objects, ElementsAre(SceneObject{}, SceneObject{"wall", "wall_7", "hall_1"},
                                        SceneObject{"box", "box_1", ""}));
}

TEST_F(HabitatScene, PicturesThatMeshesHaveInCommonAreHeldOnce) {
  const auto with_texture = [](SceneMesh mesh, std::uint8_t grey) {
    Image image(8, 8, 4);
    std::fill(image.pixels.begin(), image.pixels.end(), grey);
    mesh.textures.push_back({"picture", image});
    mesh.materials[0].texture = 0;
    return mesh;
  };
  SceneMesh box;
  tests::AddBox(Vec::Zero(), Vec::Ones(), kWhite, &box);
  WriteMesh("stages/room.glb", with_texture(tests::BoxRoom(8, 3, 8), 60));
  WriteMesh("objects/a/box.glb", with_texture(box, 60));
  WriteMesh("bare/stone.glb", with_texture(box, 200));
  const SceneMesh mesh =
      ImportScene(
          With(
              R"({"template_name": "a/box"}, {"template_name": "stone", "translation": [3, 0, -3]})"))
          .mesh;
  ASSERT_EQ(mesh.textures.size(), 2u);
  const auto grey_of = [&](std::size_t triangle) {
    const int texture = mesh.materials[mesh.triangle_materials[triangle]].texture;
    return texture < 0 ? -1 : int{mesh.textures[static_cast<std::size_t>(texture)].image.pixels[0]};
  };
  EXPECT_NEAR(grey_of(12), 60, 5);
  EXPECT_NEAR(grey_of(24), 200, 5);
}

TEST_F(HabitatScene, WhatIsMissingIsNamedWithItsPlace) {
  EXPECT_THAT(ImportError(With(R"({"template_name": "box"}, {"template_name": "sofa"})")),
              AllOf(HasSubstr("one.scene_instance.json:object_instances[1].template_name: 'sofa'"),
                    HasSubstr("none of the 4 objects"), HasSubstr("tiny.scene_dataset_config")));
  EXPECT_THAT(ImportError(With(R"({"translation": [0, 0, 0]})")),
              HasSubstr("object_instances[0]: 'template_name' is missing"));
  EXPECT_THAT(ImportError(Scene(R"({"stage_instance": {"template_name": "barn"}})")),
              HasSubstr("none of the 1 stages"));
  EXPECT_THAT(ImportError(Scene("{}")), HasSubstr("names no stage and no objects"));
  folder_.Write("objects/a/box.object_config.json", R"({"render_asset": "gone.glb"})");
  EXPECT_THAT(ImportError(With(R"({"template_name": "a/box"})")),
              AllOf(HasSubstr("object_instances[0]: its mesh is not read"), HasSubstr("gone.glb")));
  folder_.Write("objects/a/box.object_config.json", R"({"mass": 3})");
  EXPECT_THAT(ImportError(With(R"({"template_name": "a/box"})")), HasSubstr("'render_asset'"));
}

TEST_F(HabitatScene, ASceneThatIsItsOwnPartIsRefused) {
  folder_.Write("objects/a/box.object_config.json",
                R"({"render_asset": "../../scenes/one.scene_instance.json"})");
  EXPECT_THAT(ImportError(With(R"({"template_name": "a/box"})")),
              HasSubstr("is not a .glb, .gltf, .obj, .ply or .dae mesh"));
}

TEST_F(HabitatScene, NamesThatSeveralHaveAreRefused) {
  folder_.Write("objects/b/box.object_config.json", R"({"render_asset": "crate.glb"})");
  EXPECT_THAT(ImportError(With(R"({"template_name": "box"})")),
              HasSubstr("write more of the path"));
  EXPECT_EQ(ImportError(With(R"({"template_name": "a/box"})")), "no error");
  EXPECT_EQ(ImportError(With(R"({"template_name": "crat"})")), "no error");  // a part that one has
}

TEST_F(HabitatScene, BadContentIsRefused) {
  EXPECT_THAT(ImportError(Scene("{\"stage_instance\": ")), HasSubstr("cut off"));
  EXPECT_THAT(ImportError(Scene("[]")), HasSubstr("is no scene instance"));
  EXPECT_THAT(ImportError(With(R"({"template_name": "a/box", "rotation": [0, 0, 0, 0]})")),
              HasSubstr("object_instances[0].rotation: is no rotation"));
  EXPECT_THAT(ImportError(With(R"({"template_name": "a/box", "translation": [0, 0]})")),
              HasSubstr("object_instances[0].translation: expected a list of 3"));
  EXPECT_THAT(ImportError(With(R"({"template_name": "a/box", "uniform_scale": 0})")),
              HasSubstr("is not above 0"));
  EXPECT_THAT(
      ImportError(With(R"({"template_name": "a/box", "translaton": [0, 0, 1]})")),
      HasSubstr("object_instances[0]: unknown key 'translaton'; did you mean 'translation'?"));
  EXPECT_THAT(ImportError(With("", R"(, "object_instance": [])")),
              HasSubstr("did you mean 'object_instances'?"));
  EXPECT_EQ(ImportError(With(R"({"template_name": "a/box", "owner": "me"})")), "no error");
  EXPECT_THAT(ImportError(With("", R"(, "translation_origin": "middle")")),
              HasSubstr("is not one of: asset_local, COM"));
  folder_.Write(
      "configs/stages/room.stage_config.json",
      R"({"render_asset": "../../stages/room.glb", "up": [0, 1, 0], "front": [0, 1, 1]})");
  EXPECT_THAT(ImportError(With("")), HasSubstr("right angles"));
}

TEST_F(HabitatScene, WithoutItsDataSetItIsRefused) {
  const auto elsewhere =
      folder_.Write("other/one.scene_instance.json", R"({"stage_instance": {}})");
  EXPECT_THAT(ImportError(elsewhere), HasSubstr("is of no data set"));
}

}  // namespace
}  // namespace bulletnav::sim
