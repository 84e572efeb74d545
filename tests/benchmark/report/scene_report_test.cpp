// SPDX-License-Identifier: MIT
#include "benchmark/report/scene_report.h"

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

TEST(SceneReport, TheUpAxisIsThatOfWhatWasRead) {
  SceneReport report;
  report.import.up_axis = sim::UpAxis::kZ;
  EXPECT_NE(ToText(report).find("up axis as read   z\n"), std::string::npos);
}

TEST(SceneReport, TellsThatRoofsCountWhereNothingIsIndoors) {
  SceneReport report;
  EXPECT_EQ(ToText(report).find("roofs"), std::string::npos);
  report.is_open = true;
  EXPECT_NE(ToText(report).find("nothing is indoors, so that all that is level counts"),
            std::string::npos);
}

}  // namespace
}  // namespace bulletnav::bench
