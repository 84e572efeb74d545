// SPDX-License-Identifier: MIT
#include "sim/import/gazebo_files.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using testing::ElementsAre;
using tests::TemporaryFolder;

TEST(GazeboFiles, ModelsLieBesideTheWorldOrWhereTheEnvironmentSays) {
  ::setenv("GAZEBO_MODEL_PATH", "/one::/two", 1);
  EXPECT_THAT(
      ModelFolders("/set/worlds/a.world"),
      ElementsAre("/set/worlds", "/set/worlds/models", "/set", "/set/models", "/one", "/two"));
  ::unsetenv("GAZEBO_MODEL_PATH");
}

TEST(GazeboFiles, UrisAreFound) {
  const TemporaryFolder folder;
  const auto mesh = folder.Write("chair/meshes/chair.obj", "x");
  const auto asker = folder.Write("chair/model.sdf", "x");
  const std::vector<std::filesystem::path> folders = {"/nowhere", folder.path()};
  EXPECT_EQ(FindModelFile(folders, asker, "model://chair"), folder.path() / "chair");
  for (const std::string uri : {"model://chair/meshes/chair.obj", "meshes/chair.obj",
                                "file://meshes/chair.obj", "file://chair/meshes/chair.obj"}) {
    EXPECT_EQ(FindModelFile(folders, asker, uri), mesh) << uri;
  }
  for (const std::string uri :
       {"model://sofa", "model://", "https://models.org/chair", "meshes/sofa.obj"}) {
    EXPECT_EQ(FindModelFile(folders, asker, uri), std::nullopt) << uri;
  }
}

TEST(GazeboFiles, CyclesAreFound) {
  const TemporaryFolder folder;
  const auto include = [](const std::string& name) {
    return "<sdf><model><include><uri>model://" + name + "</uri></include></model></sdf>";
  };
  folder.Write("a/model.sdf", include("b") + include("c"));
  folder.Write("b/model.sdf", include("c"));
  folder.Write("c/model.sdf", "<sdf/>");
  EXPECT_NO_THROW(RequireNoCycle({folder.path()}, folder.path() / "a"));
  folder.Write("c/model.sdf", include("b"));
  EXPECT_THROW(RequireNoCycle({folder.path()}, folder.path() / "a"), FileError);
}

}  // namespace
}  // namespace bulletnav::sim
