// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/scene/import.h"
#include "tests/support/imports.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using tests::BoxOf;
using tests::ExpectBox;
using tests::ImportError;
using Vec = Eigen::Vector3f;

/// Worlds whose only model with a mesh is a table of 2 x 1 x 1 m, standing on its origin.
class GazeboWorld : public testing::Test {
 protected:
  void SetUp() override {
    folder_.Write("models/table/meshes/table.obj",
                  "mtllib table.mtl\nusemtl red\nv -1 -0.5 0\nv 1 -0.5 0\nv 1 0.5 0\nv -1 0.5 0\n"
                  "v -1 -0.5 1\nv 1 -0.5 1\nv 1 0.5 1\nv -1 0.5 1\nf 1 2 3 4\nf 5 6 7 8\n"
                  "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    folder_.Write("models/table/meshes/table.mtl", "newmtl red\nKd 1 0 0\n");
    folder_.Write("models/table/model.config",
                  "<model><name>table</name><sdf version='1.6'>model.sdf</sdf></model>");
    folder_.Write("models/table/model.sdf",
                  "<sdf version='1.6'><model name='table'><link name='top'><visual name='v'>"
                  "<geometry><mesh><uri>model://table/meshes/table.obj</uri></mesh></geometry>"
                  "</visual></link></model></sdf>");
  }
  std::filesystem::path World(const std::string& content) const {
    return folder_.Write("worlds/one.world",
                         "<sdf version='1.6'><world name='one'>" + content + "</world></sdf>");
  }
  static std::string Model(const std::string& name, const std::string& pose,
                           const std::string& shape) {
    return "<model name='" + name + "'><pose>" + pose +
           "</pose><link name='l'><visual name='v'><geometry>" + shape +
           "</geometry><material><diffuse>0 0 1 1</diffuse></material></visual></link></model>";
  }

  tests::TemporaryFolder folder_;
};

constexpr const char* kBox = "<box><size>1 2 3</size></box>";

TEST_F(GazeboWorld, ShapesTellOfWhatLightGoesThrough) {
  for (const auto& [transparency, name] :
       {std::pair{"0.6", "(see-through)"}, std::pair{"0", ""}, std::pair{"1", ""}}) {
    const std::string model =
        "<model name='m'><link name='l'><visual name='v'><transparency>" +
        std::string(transparency) +
        "</transparency><geometry><box><size>4 4 2</size></box></geometry></visual></link></model>";
    const SceneMesh mesh = ImportScene(World(model)).mesh;
    EXPECT_EQ(mesh.materials[mesh.triangle_materials[0]].name, name) << transparency;
  }
}

TEST_F(GazeboWorld, ShapesStandWhereTheirPosesSayZUp) {
  const ImportedScene scene = ImportScene(World(
      Model("crate", "1 2 1.5 0 0 0", kBox) +
      Model("post", "4 0 1 0 0 0", "<cylinder><radius>0.5</radius><length>2</length></cylinder>") +
      Model("ball", "0 0 5 0 0 0", "<sphere><radius>1</radius></sphere>")));
  // (x, y, z) becomes (x, z, -y).
  ExpectBox(BoxOf(scene.mesh, "crate"), Vec(0.5f, 0, -3), Vec(1.5f, 3, -1));
  ExpectBox(BoxOf(scene.mesh, "post"), Vec(3.5f, 0, -0.5f), Vec(4.5f, 2, 0.5f));
  ExpectBox(BoxOf(scene.mesh, "ball"), Vec(-1, 4, -1), Vec(1, 6, 1));
  EXPECT_EQ(scene.report.up_axis, UpAxis::kZ);
  EXPECT_EQ(scene.mesh.materials[0].base_color, (Rgb8{0, 0, 255}));
}

TEST_F(GazeboWorld, ModelsAreIncludedAndTurned) {
  const ImportedScene scene = ImportScene(
      World("<include><uri>model://table</uri><pose>5 0 0 0 0 1.57079632679</pose></include>"
            "<include><uri>model://table</uri><name>other</name></include>"
            "<include><uri>model://sun</uri></include>"));
  ExpectBox(BoxOf(scene.mesh, "table"), Vec(4.5f, 0, -1), Vec(5.5f, 1, 1));
  ExpectBox(BoxOf(scene.mesh, "other"), Vec(-1, 0, -0.5f), Vec(1, 1, 0.5f));
  EXPECT_EQ(scene.report.triangles, 24u);
  EXPECT_THAT(scene.report.skipped, ElementsAre(HasSubstr("Gazebo's own")));
  EXPECT_EQ(scene.mesh.materials[scene.mesh.triangle_materials[0]].base_color, (Rgb8{255, 0, 0}));
}

TEST_F(GazeboWorld, ModelsWithinModelsStandInThem) {
  folder_.Write("models/set/model.config",
                "<model><name>set</name><sdf version='1.8'>model.sdf</sdf></model>");
  folder_.Write("models/set/model.sdf",
                "<sdf version='1.8'><model name='set'><include><uri>model://table</uri>"
                "<pose>2 0 0 0 0 0</pose></include><link name='l'/></model></sdf>");
  const ImportedScene scene =
      ImportScene(World("<include><uri>model://set</uri><pose>0 0 1 0 0 0</pose></include>"));
  ExpectBox(BoxOf(scene.mesh, "set::table"), Vec(1, 1, -0.5f), Vec(3, 2, 0.5f));
}

TEST_F(GazeboWorld, ThePlaneEndsAMetreBeyondTheRest) {
  const ImportedScene scene = ImportScene(World(
      Model("ground", "0 0 0 0 0 0", "<plane><normal>0 0 1</normal><size>100 100</size></plane>") +
      Model("crate", "1 2 1.5 0 0 0", kBox)));
  ExpectBox(BoxOf(scene.mesh, "ground"), Vec(-0.5f, 0, -4), Vec(2.5f, 0, 0));
}

/// A frame at (2, 0) with a leaf of 1 x 0.1 x 2 m that hangs at its end with less x.
std::string Doorway(const std::string& joint, const std::string& limit) {
  const auto visual = [](const std::string& pose, const std::string& size) {
    return "<pose>" + pose + "</pose><visual name='v'><geometry><box><size>" + size +
           "</size></box></geometry></visual></link>";
  };
  return "<model name='m'><pose>2 0 0 0 0 0</pose><link name='frame'>" +
         visual("0 0 2.1 0 0 0", "1.4 0.1 0.2") + "<link name='leaf'>" +
         visual("0 0 1 0 0 0", "1 0.1 2") + "<link name='handle'>" +
         visual("0.4 0.1 1 0 0 0", "0.1 0.1 0.1") + "<joint name='" + joint +
         "' type='revolute'><parent>frame</parent><child>leaf</child><pose>-0.5 0 0 0 0 0</pose>" +
         "<axis><xyz>0 0 1</xyz><limit>" + limit + "</limit></axis></joint>" +
         "<joint name='fix' "
         "type='fixed'><parent>leaf</parent><child>handle</child></joint></model>";
}

TEST_F(GazeboWorld, DoorsTurnOnTheirJoints) {
  const auto world = World(Doorway("door_hinge", "<lower>0</lower><upper>1.5707963</upper>"));
  ImportOptions options;
  options.doors.emplace();
  const ImportedScene shut = ImportScene(world, options);
  ASSERT_EQ(shut.doors.size(), 1u);
  EXPECT_EQ(shut.doors[0].object, "m::leaf");
  EXPECT_TRUE(shut.doors[0].hinge.isApprox(Vec(1.5f, 1, 0)));
  EXPECT_FALSE(shut.doors[0].is_open());
  options.doors->state = DoorState::kOpen;
  const ImportedScene open = ImportScene(world, options);
  // Leaf and handle have turned to the left, to -z.
  ExpectBox(BoxOf(open.mesh, "m::leaf"), Vec(1.35f, 0, -1), Vec(1.55f, 2, 0));
  ExpectBox(BoxOf(open.mesh, "m"), BoxOf(shut.mesh, "m").min(), BoxOf(shut.mesh, "m").max());
  EXPECT_NEAR(open.doors[0].width, 1.0f, 0.02f);
}

TEST_F(GazeboWorld, DoorsOpenToTheirFartherLimitAndAQuarterTurnAtMost) {
  ImportOptions options;
  options.doors = DoorSpec{.state = DoorState::kOpen};
  const ImportedScene back =
      ImportScene(World(Doorway("door", "<lower>-1.2</lower><upper>0.3</upper>")), options);
  EXPECT_FLOAT_EQ(back.doors[0].angle, 1.2f);
  EXPECT_EQ(back.doors[0].axis, Vec(0, -1, 0));
  EXPECT_FLOAT_EQ(ImportScene(World(Doorway("Door", "")), options).doors[0].angle, 1.5707963f);
  try {
    ImportScene(World(Doorway("wheel", "")), options);
    ADD_FAILURE() << "no error";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("one.world: no doors are known"));
  }
}

TEST_F(GazeboWorld, WhatIsMissingIsNamed) {
  EXPECT_THAT(ImportError(World("<include><uri>model://sofa</uri></include>")),
              AllOf(HasSubstr("one.world:1: "), HasSubstr("model://sofa"),
                    HasSubstr("GZ_SIM_RESOURCE_PATH")));
  const std::string mesh = "<mesh><uri>model://table/meshes/gone.dae</uri></mesh>";
  EXPECT_THAT(ImportError(World(Model("m", "0 0 0 0 0 0", mesh))),
              AllOf(HasSubstr("visual 'm::l::v'"), HasSubstr("gone.dae' is not found")));
  EXPECT_THAT(ImportError(World("")), HasSubstr("shows nothing"));
  EXPECT_THAT(ImportError(folder_.path() / "none.sdf"), HasSubstr("none.sdf"));
}

TEST_F(GazeboWorld, BadContentIsRefusedInOneLine) {
  for (const std::string text : {"", "<sdf", "hello", "<html></html>", "<sdf version='99'/>"}) {
    const std::string error = ImportError(folder_.Write("bad.sdf", text));
    EXPECT_THAT(error, HasSubstr("bad.sdf")) << text;
    EXPECT_THAT(error, Not(HasSubstr("\n"))) << text;
  }
  EXPECT_THAT(ImportError(folder_.Write("cut.sdf", "<sdf version='1.6'>\n<world name='w'>\n<mod")),
              AllOf(HasSubstr("cut.sdf:3: is no sound XML"), HasSubstr("another copy")));
}

TEST_F(GazeboWorld, AModelThatIncludesItselfIsRefused) {
  folder_.Write("models/table/model.sdf",
                "<sdf version='1.6'><model name='table'><include><uri>model://table</uri>"
                "</include></model></sdf>");
  EXPECT_THAT(ImportError(World("<include><uri>model://table</uri></include>")),
              HasSubstr("includes itself by 'model://table'"));
}

TEST_F(GazeboWorld, OneModelIsASceneToo) {
  EXPECT_EQ(ImportScene(folder_.path() / "models/table/model.sdf").report.triangles, 12u);
}

}  // namespace
}  // namespace bulletnav::sim
