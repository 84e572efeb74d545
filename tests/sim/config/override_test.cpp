// SPDX-License-Identifier: MIT
#include "sim/config/override.h"

#include <gmock/gmock.h>

namespace bulletnav::sim {
namespace {

struct Lane {
  int count = 1;
  std::string name;
  template <class V>
  void Visit(V& v) {
    v("count", count);
    v("name", name);
  }
};

struct Config {
  int steps = 10;
  Lane draw;
  std::vector<Lane> lanes;
  std::vector<std::string> settings;
  template <class V>
  void Visit(V& v) {
    v("steps", steps);
    v("draw", draw);
    v("lanes", lanes);
    v("settings", settings);
  }
};

constexpr const char* kText = "steps: 3\nlanes: [{count: 1}, {count: 2}]\n";

Config With(const std::vector<std::string>& overrides) {
  Config config;
  YamlReader::Read(WithOverrides(ParseYaml(kText, "a.yaml"), "a.yaml", overrides), config);
  return config;
}

std::string Complaint(const std::string& text) {
  try {
    With({text});
  } catch (const Error& e) {
    return e.what();
  }
  return "none";
}

TEST(OverrideTest, SetsValuesListsAndBlocks) {
  const Config config = With({"steps=7", "draw.count=5", "lanes.1.name=a=b", "settings=[rgb, rgbd]",
                              "lanes.0={count: 9}", "steps=8"});
  EXPECT_EQ(config.steps, 8) << "the last counts";
  EXPECT_EQ(config.draw.count, 5);
  EXPECT_EQ(config.lanes[1].name, "a=b");
  EXPECT_EQ(config.lanes[1].count, 2);
  EXPECT_EQ(config.lanes[0].count, 9);
  EXPECT_THAT(config.settings, testing::ElementsAre("rgb", "rgbd"));
  EXPECT_EQ(With({"draw.name="}).draw.name, "");
  EXPECT_EQ(With({}).steps, 3);
}

TEST(OverrideTest, UnknownKeysAndWrongValuesAreRefusedByName) {
  EXPECT_THAT(Complaint("stepz=7"), testing::AllOf(testing::StartsWith("a.yaml with stepz=7: "),
                                                   testing::HasSubstr("steps")));
  EXPECT_THAT(Complaint("draw.cuont=7"), testing::HasSubstr("count"));
  EXPECT_THAT(Complaint("steps=many"), testing::StartsWith("a.yaml with steps=many: "));
}

TEST(OverrideTest, RefusesWhatIsNoOverride) {
  EXPECT_THAT(Complaint("steps"), testing::HasSubstr("write KEY=VALUE"));
  EXPECT_THAT(Complaint("=3"), testing::HasSubstr("a key is empty"));
  EXPECT_THAT(Complaint("draw..count=3"), testing::HasSubstr("a key is empty"));
  EXPECT_THAT(Complaint("lanes.2.count=3"), testing::HasSubstr("no place in a list of 2"));
  EXPECT_THAT(Complaint("lanes.-1=3"), testing::HasSubstr("no place in a list"));
  EXPECT_THAT(Complaint("steps.more=3"), testing::HasSubstr("no 'more' below a single value"));
  EXPECT_THAT(Complaint("steps=[1"), testing::HasSubstr("no YAML"));
}

}  // namespace
}  // namespace bulletnav::sim
