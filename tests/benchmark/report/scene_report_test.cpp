// SPDX-License-Identifier: MIT
#include "benchmark/report/scene_report.h"

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

TEST(SceneReport, WarnsOfAFewMissingTextures) {
  sim::ImportReport import;
  EXPECT_EQ(TextureWarnings("a.obj", import), "");
  import.textures_missing = {"a.png: file not found", "b.png: is empty", "c.png: file not found"};
  const std::string three =
      "bulletnav: warning: a.obj: missing texture a.png: file not found\n"
      "bulletnav: warning: a.obj: missing texture b.png: is empty\n"
      "bulletnav: warning: a.obj: missing texture c.png: file not found\n";
  EXPECT_EQ(TextureWarnings("a.obj", import), three);
  import.textures_missing.resize(10, "d.png: file not found");
  EXPECT_EQ(TextureWarnings("a.obj", import),
            three + "bulletnav: warning: a.obj: and 7 more; see scenes inspect\n");
}

TEST(SceneReport, TheUpAxisIsThatOfWhatWasRead) {
  SceneReport report;
  report.import.up_axis = sim::UpAxis::kZ;
  EXPECT_NE(ToText(report).find("up axis as read   z\n"), std::string::npos);
}

}  // namespace
}  // namespace bulletnav::bench
