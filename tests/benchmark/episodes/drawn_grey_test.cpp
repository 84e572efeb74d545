// SPDX-License-Identifier: MIT
#include "benchmark/episodes/drawn_grey.h"

#include <gtest/gtest.h>

#include "benchmark/episodes/scene_cache.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

TEST(DrawnGrey, IsOneLineThatCounts) {
  sim::ImportReport import;
  import.skipped = {"3 points or lines"};
  EXPECT_EQ(DrawnGrey("a.obj", import), "");
  import.textures_found = 9;
  import.textures_missing = {"a.png: file not found", "b.png: is empty", "c.png: file not found"};
  EXPECT_EQ(DrawnGrey("a.obj", import),
            "a.obj: drawn grey: 3 of 12 textures, as a.png: file not found; see 'scenes inspect'");
  import.textures_missing.clear();
  import.skipped.emplace_back("material library a.mtl, which is not beside the file");
  EXPECT_EQ(DrawnGrey("a.obj", import),
            "a.obj: drawn grey: material library a.mtl, which is not beside the file; see 'scenes "
            "inspect'");
}

TEST(DrawnGrey, IsSaidOnceAScene) {
  const tests::TemporaryFolder folder;
  folder.Write("room.mtl", "newmtl m\nmap_Kd gone.png\n");
  const auto grey = folder.Write("room.obj",
                                 "mtllib room.mtl\nusemtl m\nv 0 0 0\nv 9 0 0\nv 9 0 -9\n"
                                 "v 0 0 -9\nv 0 3 0\nv 9 3 0\nf 1 2 3 4\nf 1 2 6 5\n");
  const std::vector<std::uint8_t> glb = sim::EncodeGlb(tests::BoxRoom(6, 3, 6));
  const auto whole =
      folder.Write("whole.glb", {reinterpret_cast<const char*>(glb.data()), glb.size()});
  std::vector<std::string> lines;
  SceneCache cache({}, 0);  // imports again and again
  cache.WarnOfGrey([&](const std::string& line) {
    lines.push_back(line);
  });
  for (const auto& scene : {grey, whole, grey}) cache.LoadGround(scene);
  EXPECT_EQ(cache.imports(), 3);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], DrawnGrey(grey, sim::ImportScene(grey).report));
  // One wall keeps nobody indoors.
  EXPECT_EQ(lines[1].find(grey.string() + ": nothing is indoors"), 0u) << lines[1];
}

}  // namespace
}  // namespace bulletnav::bench
