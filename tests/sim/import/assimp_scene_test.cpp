// SPDX-License-Identifier: MIT
#include "sim/import/assimp_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "sim/base/files.h"
#include "sim/image/image.h"
#include "sim/import/cpu_time.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using tests::TemporaryFolder;

/// Seconds of processor time that reading has added to those allowed.
int SecondsAdded(const std::filesystem::path& mesh) {
  constexpr int kSeconds = 1000;
  rlimit before{};
  ::getrlimit(RLIMIT_CPU, &before);
  LimitCpuSeconds(kSeconds);
  const CheckedMeshFile checked;
  const AssimpScene scene(mesh, checked);
  ImportReport report;
  for (const Texture& texture : scene.Convert(&report).textures) scene.LoadTexture(texture.name);
  rlimit after{};
  ::getrlimit(RLIMIT_CPU, &after);
  ::setrlimit(RLIMIT_CPU, &before);
  return static_cast<int>(after.rlim_cur) - kSeconds;
}

TEST(AssimpScene, FilesBesideTheMeshAddToItsTime) {
  const TemporaryFolder folder;
  const std::string floor = "v 0 0 0\nv 4 0 0\nv 4 0 -6\nv 0 0 -6\nf 1 2 3 4\n";
  const auto plain = folder.Write("plain.obj", floor);
  EXPECT_EQ(SecondsAdded(plain), 0);
  folder.Write("room.mtl", "newmtl m\nmap_Kd wood.png\n" + std::string(3 << 20, '#') + "\n");
  WritePng(folder.path() / "wood.png", Image(8, 8, 3));
  const auto room = folder.Write("room.obj", "mtllib room.mtl\nusemtl m\n" + floor);
  EXPECT_EQ(SecondsAdded(room), (3 + 2 * 3) + 3 + 9);
}

TEST(AssimpScene, APipeIsNotWaitedFor) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder.path() / "room.mtl").c_str(), 0600), 0);
  ImportReport report;
  const auto room = folder.Write("room.obj",
                                 "mtllib room.mtl\nusemtl m\nv 0 0 0\nv 4 0 0\n"
                                 "v 4 0 -6\nv 0 0 -6\nf 1 2 3 4\n");
  const CheckedMeshFile checked;
  EXPECT_EQ(AssimpScene(room, checked).Convert(&report).triangles.size(), 2u);
}

}  // namespace
}  // namespace bulletnav::sim
