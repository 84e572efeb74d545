// SPDX-License-Identifier: MIT
// Articulated objects of scene instances: URDFs made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
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
using testing::IsEmpty;
using testing::Not;
using tests::BoxOf;
using tests::ExpectBox;
using tests::ImportError;
using Vec = Eigen::Vector3f;

constexpr auto kQuarter = 1.5707964f;

/// z up in its own axes, as those of ReplicaCAD: a body of 1 x 1 x 2 m with a door before it that
/// hangs at (0.5, 0.5), with a handle, and a drawer that slides out along x. The root has no mass.
constexpr const char* kFridge = R"(<?xml version="1.0"?>
<robot name="fridge">
  <link name="root"/>
  <joint name="up" type="fixed">
    <origin rpy="-1.5707963267948966 0 0"/><parent link="root"/><child link="body"/>
  </joint>
  <link name="body">
    <visual><origin xyz="0 0 1"/><geometry><box size="1 1 2"/></geometry></visual>
  </link>
  <joint name="hinge" type="revolute">
    <origin xyz="0.5 0.5 1"/><parent link="body"/><child link="door"/>
    <axis xyz="0 0 1"/><limit lower="0" upper="2.3" effort="1" velocity="1"/>
  </joint>
  <link name="door">
    <visual><origin xyz="0 -0.5 0"/><geometry><mesh filename="leaf.glb" scale="1, 1, 1"/></geometry></visual>
  </link>
  <joint name="fix" type="fixed">
    <origin xyz="0.1 -0.9 0"/><parent link="door"/><child link="handle"/>
  </joint>
  <link name="handle"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>
  <joint name="slide" type="prismatic">
    <origin xyz="0 0 0.2"/><parent link="body"/><child link="drawer"/>
    <axis xyz="1 0 0"/><limit lower="0" upper="0.5" effort="1" velocity="1"/>
  </joint>
  <link name="drawer"><visual><geometry><box size="1 0.8 0.2"/></geometry></visual></link>
</robot>)";

class ArticulatedObject : public testing::Test {
 protected:
  void SetUp() override {
    folder_.Write("tiny.scene_dataset_config.json", R"({
      "stages": {"paths": {".json": ["stages"]}},
      "articulated_objects": {"paths": {".urdf": ["urdf/*"], ".json": ["urdf/*"]}},
      "scene_instances": {"paths": {".json": ["scenes"]}}})");
    WriteMesh("stages/room.glb", tests::BoxRoom(8, 3, 8));
    folder_.Write("stages/room.stage_config.json", R"({"render_asset": "room.glb"})");
    SceneMesh leaf;
    tests::AddBox({-0.05f, -0.5f, -1}, {0.05f, 0.5f, 1}, kWhite, &leaf);
    WriteMesh("urdf/fridge/leaf.glb", leaf);
    folder_.Write("urdf/fridge/fridge.urdf", kFridge);
  }
  void WriteMesh(const std::string& name, const SceneMesh& mesh) const {
    WriteFileAtomically(folder_.path() / name, EncodeGlb(mesh));
  }
  std::filesystem::path With(const std::string& objects) const {
    return folder_.Write("scenes/one.scene_instance.json",
                         R"({"stage_instance": {"template_name": "stages/room"},
                             "articulated_object_instances": [)" +
                             objects + "]}");
  }
  static ImportedScene Read(const std::filesystem::path& file, DoorState state) {
    ImportOptions options;
    options.doors = DoorSpec{.state = state};
    return ImportScene(file, options);
  }

  tests::TemporaryFolder folder_;
};

TEST_F(ArticulatedObject, StandsInTheSceneWithItsDoorShut) {
  const ImportedScene scene =
      ImportScene(With(R"({"template_name": "fridge", "translation": [4, 0, -4]})"));
  // Body and drawer: x forward, and the body's z is up.
  ExpectBox(BoxOf(scene.mesh, "fridge_1"), Vec(3.5f, 0, -4.5f), Vec(4.5f, 2, -3.5f));
  ExpectBox(BoxOf(scene.mesh, "fridge_1::door"), Vec(4.45f, 0, -4.5f), Vec(4.65f, 2, -3.5f));
  EXPECT_EQ(scene.mesh.objects[2], (SceneObject{"fridge", "fridge_1", ""}));
  EXPECT_EQ(scene.mesh.objects[3].category, "door");
  EXPECT_THAT(scene.report.skipped, IsEmpty());
  EXPECT_THAT(scene.doors, IsEmpty());  // nobody asked
}

TEST_F(ArticulatedObject, ItsDoorIsTurnedWithAllThatHangsOnIt) {
  const auto file = With(R"({"template_name": "fridge", "translation": [4, 0, -4]})");
  const ImportedScene shut = Read(file, DoorState::kClosed);
  ASSERT_EQ(shut.doors.size(), 1u);
  EXPECT_EQ(shut.doors[0].object, "fridge_1::door");
  EXPECT_TRUE(shut.doors[0].hinge.isApprox(Vec(4.5f, 1, -4.5f), 1e-5f));
  EXPECT_TRUE(shut.doors[0].axis.isApprox(Vec::UnitY(), 1e-5f));
  EXPECT_FALSE(shut.doors[0].is_open());
  EXPECT_EQ(shut.mesh.positions, ImportScene(file).mesh.positions);
  const ImportedScene open = Read(file, DoorState::kOpen);
  EXPECT_FLOAT_EQ(open.doors[0].angle, kQuarter);
  // A quarter turn to the left about the hinge: what lay along +z now lies along +x.
  ExpectBox(BoxOf(open.mesh, "fridge_1::door"), Vec(4.5f, 0, -4.65f), Vec(5.5f, 2, -4.45f));
  ExpectBox(BoxOf(open.mesh, "fridge_1"), Vec(3.5f, 0, -4.5f), Vec(4.5f, 2, -3.5f));
}

TEST_F(ArticulatedObject, StandsAsItsJointPoseSays) {
  // Positions in the order of the tree and of the joints' names: the hinge, then the drawer.
  const std::string start = R"({"template_name": "fridge", "translation": [4, 0, -4],)";
  const auto list = With(start + R"("initial_joint_pose": [1.5707963267948966, 0.25]})");
  const ImportedScene as_built = Read(list, DoorState::kAsBuilt);
  ExpectBox(BoxOf(as_built.mesh, "fridge_1::door"), Vec(4.5f, 0, -4.65f), Vec(5.5f, 2, -4.45f));
  ExpectBox(BoxOf(as_built.mesh, "fridge_1"), Vec(3.5f, 0, -4.5f), Vec(4.75f, 2, -3.5f));
  EXPECT_TRUE(as_built.doors[0].is_open());
  ExpectBox(BoxOf(Read(list, DoorState::kClosed).mesh, "fridge_1::door"), Vec(4.45f, 0, -4.5f),
            Vec(4.65f, 2, -3.5f));
  // By name they count in the order of the names.
  const auto by_name =
      With(start + R"("initial_joint_pose": {"j2": 0.25, "j1": 1.5707963267948966, "j3": 9}})");
  EXPECT_EQ(ImportScene(by_name).mesh.positions, as_built.mesh.positions);
}

TEST_F(ArticulatedObject, IsTurnedAndScaled) {
  // A quarter turn about y takes x to -z.
  const auto file = With(R"({"template_name": "fridge", "translation": [4, 0, -4],
      "uniform_scale": 0.5, "rotation": [0.70710678, 0, 0.70710678, 0],
      "initial_joint_pose": [0, 0.25], "fixed_base": true, "translation_origin": "COM"})");
  const ImportedScene open = Read(file, DoorState::kOpen);
  // The drawer is 0.25 m out, whatever the scale.
  ExpectBox(BoxOf(open.mesh, "fridge_1"), Vec(3.75f, 0, -4.5f), Vec(4.25f, 1, -3.75f));
  EXPECT_TRUE(open.doors[0].hinge.isApprox(Vec(3.75f, 0.5f, -4.25f), 1e-5f));
  ExpectBox(BoxOf(open.mesh, "fridge_1::door"), Vec(3.675f, 0, -4.75f), Vec(3.775f, 1, -4.25f));
}

TEST_F(ArticulatedObject, EachInstanceHasItsOwnDoor) {
  const ImportedScene scene = Read(With(R"({"template_name": "fridge", "translation": [2, 0, -4]},
                   {"template_name": "fridge", "translation": [6, 0, -4]})"),
                                   DoorState::kOpen);
  ASSERT_EQ(scene.doors.size(), 2u);
  EXPECT_EQ(scene.doors[1].object, "fridge_2::door");
  ExpectBox(BoxOf(scene.mesh, "fridge_2::door"), Vec(6.5f, 0, -4.65f), Vec(7.5f, 2, -4.45f));
}

TEST_F(ArticulatedObject, JointsThatLieOrTurnFreelyOrNotAtAllAreNoDoors) {
  std::string flap = kFridge;
  flap.replace(flap.find("<axis xyz=\"0 0 1\"/>"), 19, "<axis xyz=\"0 1 0\"/>");
  folder_.Write("urdf/fridge/fridge.urdf", flap);
  EXPECT_THAT(Read(With(R"({"template_name": "fridge"})"), DoorState::kAsBuilt).doors, IsEmpty());
  std::string stuck = kFridge;
  stuck.replace(stuck.find("upper=\"2.3\""), 11, "upper=\"0\"");
  folder_.Write("urdf/fridge/fridge.urdf", stuck);
  EXPECT_THAT(Read(With(R"({"template_name": "fridge"})"), DoorState::kAsBuilt).doors, IsEmpty());
  std::string chair = kFridge;
  chair.replace(chair.find("\"revolute\""), 10, "\"continuous\"");
  folder_.Write("urdf/fridge/fridge.urdf", chair);
  const auto file = With(R"({"template_name": "fridge"})");
  EXPECT_THAT(Read(file, DoorState::kAsBuilt).doors, IsEmpty());
  EXPECT_THROW(Read(file, DoorState::kOpen), FileError);
}

TEST_F(ArticulatedObject, AttributesNameTheUrdfAndScaleIt) {
  folder_.Write("urdf/small/small_fridge.ao_config.json",
                R"({"urdf_filepath": "../fridge/fridge.urdf", "uniform_scale": 0.5})");
  const ImportedScene scene = ImportScene(With(R"({"template_name": "small_fridge"})"));
  ExpectBox(BoxOf(scene.mesh, "small_fridge_1"), Vec(-0.25f, 0, -0.25f), Vec(0.25f, 1, 0.25f));
  // Without a name, the URDF beside it; both are one template.
  folder_.Write("urdf/fridge/fridge.ao_config.json", R"({"uniform_scale": 2})");
  ExpectBox(BoxOf(ImportScene(With(R"({"template_name": "fridge"})")).mesh, "fridge_1"),
            Vec(-1, 0, -1), Vec(1, 4, 1));
}

TEST_F(ArticulatedObject, WhatIsNotDrawnIsCounted) {
  folder_.Write("urdf/x/pill.urdf", R"(<robot name="pill"><link name="a">
      <visual><geometry><capsule radius="1" length="1"/></geometry></visual></link></robot>)");
  EXPECT_THAT(
      ImportScene(With(R"({"template_name": "pill"}, {"template_name": "pill"})")).report.skipped,
      ElementsAre(AllOf(HasSubstr("2 visuals"), HasSubstr("capsules"))));
}

TEST_F(ArticulatedObject, WhatIsMissingOrBrokenIsNamedWithItsPlace) {
  const std::string place = "one.scene_instance.json:articulated_object_instances[0]";
  EXPECT_THAT(ImportError(With(R"({"template_name": "sofa"})")),
              AllOf(HasSubstr(place + ".template_name: 'sofa'"),
                    HasSubstr("none of the 1 articulated_objects")));
  EXPECT_THAT(ImportError(With("{}")),
              HasSubstr(place.substr(24) + ": 'template_name' is missing"));
  EXPECT_THAT(ImportError(With(R"({"template_name": "fridge", "uniform_scale": 0})")),
              HasSubstr("uniform_scale"));
  EXPECT_THAT(ImportError(With(R"({"template_name": "fridge", "initial_joint_pose": ["a"]})")),
              HasSubstr("initial_joint_pose[0]"));
  const auto file = With(R"({"template_name": "fridge"})");
  folder_.Write("urdf/fridge/leaf.glb", "nonsense");
  EXPECT_THAT(ImportError(file), AllOf(HasSubstr(place + ", link 'door': its mesh is not read"),
                                       HasSubstr("leaf.glb")));
  std::filesystem::remove(folder_.path() / "urdf/fridge/leaf.glb");
  EXPECT_THAT(ImportError(file), AllOf(HasSubstr(place + ": its URDF is not read: "),
                                       HasSubstr("fridge.urdf:15: the mesh 'leaf.glb'")));
  folder_.Write("urdf/fridge/fridge.urdf", "<robot name='fridge'>\n<link name='a'>\n</robot>");
  EXPECT_THAT(ImportError(file),
              AllOf(HasSubstr(place + ": its URDF is not read: "),
                    HasSubstr("fridge.urdf:2: is no sound XML"), Not(HasSubstr("\n"))));
  folder_.Write("urdf/y/gone.ao_config.json", "{}");
  EXPECT_THAT(ImportError(With(R"({"template_name": "gone"})")),
              AllOf(HasSubstr(place + ": its URDF is not read: "), HasSubstr("gone.urdf")));
}

}  // namespace
}  // namespace bulletnav::sim
