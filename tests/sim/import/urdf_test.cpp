// SPDX-License-Identifier: MIT
#include "sim/import/urdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using Vec = Eigen::Vector3f;

class UrdfFile : public testing::Test {
 protected:
  std::filesystem::path Robot(const std::string& content) const {
    return folder_.Write("thing.urdf",
                         "<?xml version=\"1.0\"?>\n<robot name='thing'>\n" + content + "</robot>");
  }
  std::string ErrorOf(const std::string& content) const { return ErrorIn(Robot(content)); }
  static std::string ErrorIn(const std::filesystem::path& file) {
    try {
      ReadUrdf(file);
    } catch (const FileError& e) {
      return e.what();
    }
    return "no error";
  }
  static std::string Link(const std::string& name, const std::string& geometry = "",
                          const std::string& more = "") {
    if (geometry.empty()) return "<link name='" + name + "'/>\n";
    return "<link name='" + name + "'><visual>" + more + "<geometry>" + geometry +
           "</geometry></visual></link>\n";
  }
  static std::string Joint(const std::string& name, const std::string& ends,
                           const std::string& more = "", const std::string& type = "fixed") {
    return "<joint name='" + name + "' type='" + type + "'><parent link='" + ends.substr(0, 1) +
           "'/><child link='" + ends.substr(1) + "'/>" + more + "</joint>\n";
  }

  tests::TemporaryFolder folder_;
};

TEST_F(UrdfFile, ShapesMeshesAndColours) {
  folder_.Write("leaf.obj", "v 0 0 0");
  const Urdf thing = ReadUrdf(
      Robot("<material name='blue'><color rgba='0 0 1 1'/></material>" +
            Link("a", "<box size='1 2 3'/>", "<origin xyz='1 0 0'/><material name='blue'/>") +
            Link("b", "<mesh filename='leaf.obj' scale='2, 1, 1'/>") +
            Link("c", "<mesh filename='leaf.obj' scale='0.5'/>") +
            Link("d", "<cylinder radius='1' length='2'/>") + Link("e", "<sphere radius='1'/>") +
            Link("f", "<capsule radius='1' length='2'/>")));
  ASSERT_EQ(thing.links.size(), 6u);
  const UrdfVisual& box = thing.links[0].visuals.at(0);
  EXPECT_EQ(box.shape.Bounds().sizes(), Vec(1, 2, 3));
  EXPECT_EQ(box.X_LA.translation(), Vec(1, 0, 0));
  EXPECT_EQ(box.shape.materials[0].base_color, (Rgb8{0, 0, 255}));
  const UrdfVisual& leaf = thing.links[1].visuals.at(0);
  EXPECT_EQ(leaf.asset, folder_.path() / "leaf.obj");
  EXPECT_EQ(leaf.X_LA * Vec(1, 1, 1), Vec(2, 1, 1));
  EXPECT_EQ(thing.links[2].visuals.at(0).X_LA * Vec(1, 1, 1), Vec(0.5f, 0.5f, 0.5f));
  EXPECT_TRUE(thing.links[3].visuals.at(0).shape.Bounds().sizes().isApprox(Vec(2, 2, 2), 1e-5f));
  EXPECT_TRUE(thing.links[5].visuals.empty());
  EXPECT_EQ(thing.left_out.size(), 1u);
}

TEST_F(UrdfFile, AnglesAreAboutFixedAxesXThenYThenZ) {
  const Urdf thing = ReadUrdf(
      Robot(Link("a", "<box size='1 1 1'/>", "<origin rpy='1.5707963268 0 1.5707963268'/>")));
  // y goes to z, which stays; x stays, then goes to y.
  const Eigen::Matrix3f turn = thing.links[0].visuals[0].X_LA.linear();
  EXPECT_TRUE((turn * Vec::UnitY()).isApprox(Vec::UnitZ(), 1e-6f));
  EXPECT_TRUE((turn * Vec::UnitX()).isApprox(Vec::UnitY(), 1e-6f));
}

TEST_F(UrdfFile, JointsComeDepthFirstAndByName) {
  const Urdf thing = ReadUrdf(Robot(
      Link("a") + Link("b") + Link("c") + Link("d") + Joint("z", "bd") + Joint("m", "ac") +
      Joint("k", "ab", "<origin xyz='0 1 0'/><axis xyz='0 0 2'/><limit lower='-1' upper='2'/>",
            "revolute")));
  std::vector<std::string> names;
  for (const UrdfJoint& joint : thing.joints) names.push_back(joint.name);
  EXPECT_THAT(names, ElementsAre("k", "z", "m"));
  const UrdfJoint& joint = thing.joints[0];
  EXPECT_EQ(joint.type, UrdfJointType::kRevolute);
  EXPECT_EQ(joint.axis, Vec::UnitZ());
  EXPECT_EQ(joint.X_PJ.translation(), Vec::UnitY());
  EXPECT_EQ(joint.lower, -1.0);
  EXPECT_EQ(joint.upper, 2.0);
  EXPECT_EQ(thing.links[joint.child].name, "b");
}

TEST_F(UrdfFile, JointsWithoutRealLimitsTurnFreely) {
  const auto type_of = [&](const std::string& limit) {
    return ReadUrdf(Robot(Link("a") + Link("b") + Joint("j", "ab", limit, "revolute")))
        .joints[0]
        .type;
  };
  EXPECT_EQ(type_of("<limit lower='0' upper='1'/>"), UrdfJointType::kRevolute);
  EXPECT_EQ(type_of("<limit upper='1'/>"), UrdfJointType::kRevolute);
  EXPECT_EQ(type_of("<limit lower='0' upper='-1'/>"), UrdfJointType::kContinuous);
  EXPECT_EQ(type_of("<limit effort='1'/>"), UrdfJointType::kContinuous);
}

TEST_F(UrdfFile, DamagedFilesAreReadOrRefusedInOneLine) {
  const std::string sound = ReadTextFile(
      Robot(Link("a", "<box size='1 2 3'/>", "<origin xyz='1 0 0' rpy='0 1 0'/>") + Link("b") +
            Joint("j", "ab", "<axis xyz='0 0 1'/><limit lower='0' upper='1'/>", "revolute")));
  Rng rng(1, "damage");
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string text = sound;
    for (int k = rng.Between(1, 3); k > 0; --k) {
      const auto at = static_cast<std::size_t>(rng.Below(static_cast<int>(text.size())));
      if (rng.Chance(0.5)) {
        text[at] = static_cast<char>(rng.Between(0, 255));
      } else {
        text.erase(at, 8);
      }
    }
    const std::string error = ErrorIn(folder_.Write("bad.urdf", text));
    EXPECT_THAT(error, Not(HasSubstr("\n")));
    refused += error == "no error" ? 0 : 1;
  }
  EXPECT_GT(refused, 80);
  EXPECT_LT(refused, 150);
}

TEST_F(UrdfFile, SaysWhatIsWrongAndOnWhichLine) {
  const std::string two = Link("a") + Link("b");
  EXPECT_THAT(ErrorOf("<link name='a'>"), AllOf(HasSubstr("thing.urdf:3: "), HasSubstr("XML")));
  EXPECT_THAT(ErrorOf(""), HasSubstr("thing.urdf:2: has no link"));
  EXPECT_THAT(ErrorOf("<link/>"), HasSubstr("thing.urdf:3: 'link' has no 'name'"));
  EXPECT_THAT(ErrorOf(Link("a") + Link("a")), HasSubstr("thing.urdf:4: there are two links 'a'"));
  EXPECT_THAT(ErrorOf(Link("a", "<mesh filename='gone.glb'/>")),
              AllOf(HasSubstr("thing.urdf:3: "), HasSubstr("'gone.glb' of link 'a'")));
  EXPECT_THAT(ErrorOf(Link("a", "<mesh filename='.' scale='1 0 1'/>")), HasSubstr("'.'"));
  EXPECT_THAT(ErrorOf("<link name='a'><visual/></link>"), HasSubstr("has no geometry"));
  EXPECT_THAT(ErrorOf(Link("a", "<box size='1 x 3'/>")), HasSubstr("'size' of 'box' is '1 x 3'"));
  EXPECT_THAT(ErrorOf(Link("a", "<box size='1 2'/>")), HasSubstr("has 2 numbers; give 3"));
  EXPECT_THAT(ErrorOf(Link("a", "<sphere radius='nan'/>")), HasSubstr("plain numbers"));
  EXPECT_THAT(ErrorOf(Link("a", "<sphere radius='-1'/>")), HasSubstr("not above 0"));
  EXPECT_THAT(ErrorOf(two + Joint("j", "ac")), HasSubstr("thing.urdf:5: there is no link 'c'"));
  EXPECT_THAT(ErrorOf(two + "<joint name='j' type='fixed'/>"), HasSubstr("'j' has no parent"));
  EXPECT_THAT(ErrorOf(two + Joint("j", "ab", "", "sliding")),
              AllOf(HasSubstr("'sliding' is no type of joint"), HasSubstr("prismatic")));
  EXPECT_THAT(ErrorOf(two + Joint("j", "ab", "", "revolute")), HasSubstr("has no limit"));
  EXPECT_THAT(ErrorOf(two + Joint("j", "ab", "<axis xyz='0 0 0'/>", "continuous")),
              HasSubstr("no length"));
  EXPECT_THAT(ErrorOf(two + Joint("j", "ab") + Joint("j", "ba")), HasSubstr("two joints 'j'"));
  EXPECT_THAT(ErrorOf(two + Joint("j", "ab") + Joint("k", "bb")), HasSubstr("hangs on two"));
  EXPECT_THAT(ErrorOf(two + Joint("j", "ab") + Joint("k", "ba")), HasSubstr("in a circle"));
  EXPECT_THAT(ErrorOf(two + Joint("j", "aa")), HasSubstr("in a circle"));
}

TEST_F(UrdfFile, OtherFilesAreRefusedInOneLine) {
  for (const std::string text : {"", "hello", "<robot", "<html></html>", "\0\1"}) {
    const std::string error = ErrorIn(folder_.Write("bad.urdf", text));
    EXPECT_THAT(error, HasSubstr("bad.urdf")) << text;
    EXPECT_THAT(error, Not(HasSubstr("\n"))) << text;
  }
  EXPECT_THAT(ErrorIn(folder_.path() / "none.urdf"), HasSubstr("none.urdf"));
}

}  // namespace
}  // namespace bulletnav::sim
