// SPDX-License-Identifier: MIT
#include "sim/config/json_node.h"

#include <functional>

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

std::string ComplaintOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const FileError& e) {
    return e.what();
  }
  return "no complaint";
}

TEST(JsonNode, ReadsWhatIsThere) {
  const Json json = Json::parse(R"({"list": [1.5, 2, true, "text", null], "other": {}})");
  const Node root(json, "x.json");
  const Node list = root.At("list");
  EXPECT_EQ(list.Size(), 5u);
  EXPECT_EQ(list.Item(0).Number(), 1.5);
  EXPECT_EQ(list.Item(1).Whole(), 2u);
  EXPECT_EQ(list.Item(1).Positive(), 2.0);
  EXPECT_EQ(list.Item(1).Index(3, "things"), 2);
  EXPECT_TRUE(list.Item(2).Truth());
  EXPECT_EQ(list.Item(3).Text(), "text");
  EXPECT_TRUE(list.Item(4).IsNull());
  EXPECT_TRUE(root.Has("other"));
  EXPECT_FALSE(root.Has("more"));
}

TEST(JsonNode, FloatsKeepTheirShortestText) {
  const auto json = ParseJson<FloatJson>("[0.1, 16777217]", "x.json");
  EXPECT_EQ(JsonNode<FloatJson>(json, "x.json").Item(0).Number(), 0.1f);
  EXPECT_EQ(FloatJson(0.1f).dump(), "0.1");
}

TEST(JsonNode, ComplaintsSayFileOwnerPlaceAndRemedy) {
  const Json json = Json::parse(R"({"goals": [{"radius": "wide"}]})");
  const auto radius = [](const Node& root) {
    root.At("goals").Item(0).At("radius").Number();
  };
  EXPECT_EQ(ComplaintOf([&] {
              radius(Node(json, "x.json"));
            }),
            "x.json:goals[0].radius: expected a number here");
  EXPECT_EQ(ComplaintOf([&] {
              radius(Node(json, "x.json", "episode '12'", "draw it again"));
            }),
            "x.json: episode '12': goals[0].radius: expected a number here; draw it again");
  EXPECT_EQ(ComplaintOf([&] {
              Node(json, "x.json").At("start");
            }),
            "x.json: 'start' is missing");
}

TEST(JsonNode, RefusesWhatIsOfAnotherKind) {
  const Json json = Json::parse(R"([-1, 0.5, "a", [], 7])");
  const Node root(json, "x");
  const auto item = [&](std::size_t i) {
    return root.Item(i);
  };
  EXPECT_EQ(ComplaintOf([&] {
              item(0).Whole();
            }),
            "x:[0]: expected a whole number here");
  EXPECT_EQ(ComplaintOf([&] {
              item(1).Whole();
            }),
            "x:[1]: expected a whole number here");
  EXPECT_EQ(ComplaintOf([&] {
              item(4).Whole(6);
            }),
            "x:[4]: expected a whole number up to 6");
  EXPECT_EQ(ComplaintOf([&] {
              item(4).Index(7, "rooms");
            }),
            "x:[4]: 7 is none of the 7 rooms");
  EXPECT_EQ(ComplaintOf([&] {
              item(0).Positive();
            }),
            "x:[0]: is not above 0");
  EXPECT_EQ(ComplaintOf([&] {
              item(2).Truth();
            }),
            "x:[2]: expected true or false here");
  EXPECT_EQ(ComplaintOf([&] {
              item(1).Text();
            }),
            "x:[1]: expected a text here");
  EXPECT_EQ(ComplaintOf([&] {
              item(2).Size();
            }),
            "x:[2]: expected a list here");
  EXPECT_EQ(ComplaintOf([&] {
              item(3).Size(2);
            }),
            "x:[3]: expected a list of at least 2, got 0");
  EXPECT_EQ(ComplaintOf([&] {
              item(3).ExpectList(3);
            }),
            "x:[3]: expected a list of 3, got 0");
  EXPECT_EQ(ComplaintOf([&] {
              item(3).At("key");
            }),
            "x:[3]: expected an object here");
}

TEST(ParseJson, SaysWhereAndWhatToDo) {
  EXPECT_EQ(ComplaintOf([] {
              ParseJson<Json>("{\n \"a\" 1}", "x", 10);
            }),
            "x:11:6: not valid JSON; mend it or take a sound copy of the file");
  EXPECT_EQ(ComplaintOf([] {
              ParseJson<Json>("[1, 2", "x", 1, "make it again");
            }),
            "x:1:6: the JSON ends too early: the file is cut off; make it again");
  EXPECT_EQ(ComplaintOf([] {
              ParseJson<FloatJson>("[1e39]", "x", 7);
            }),
            "x:7: holds a number too large for this program; mend it");
  EXPECT_EQ(ComplaintOf([] {
              ParseJson<FloatJson>("[1,\n1e39]", "x");
            }),
            "x: holds a number too large for this program; mend it");
}

}  // namespace
}  // namespace bulletnav::sim
