// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/data_config.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/config/yaml_writer.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string Complaint(const std::string& text) {
  const tests::TemporaryFolder folder;
  try {
    LoadDataConfig(folder.Write("c.yaml", text));
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "nothing";
}

TEST(DataConfigTest, TheFileThatComesWithTheProgramIsThePapers) {
  const auto file = std::filesystem::path(BULLETNAV_CONFIGS) / "train/data.yaml";
  const DataConfig config = LoadDataConfig(file);
  EXPECT_EQ(config.points, 300);
  EXPECT_EQ(config.houses.value().split, "train");
  EXPECT_EQ(config.hidden, HiddenFloor::kFree);
  EXPECT_EQ(config.target_slack, 0.0);
}

TEST(DataConfigTest, TheGallerysFilesLoad) {
  for (const char* name : {"gallery.yaml", "gallery_bright.yaml", "gallery_real.yaml"}) {
    const auto config = LoadDataConfig(std::filesystem::path(BULLETNAV_CONFIGS) / "train" / name);
    EXPECT_EQ(config.scenes.empty(), config.looks.has_value()) << name;
  }
}

TEST(DataConfigTest, LooksAtTheBlockDataOnly) {
  EXPECT_EQ(Complaint("data: {scenes: [a.glb]}\ntraining: {batch: 64}\n"), "nothing");
  EXPECT_THAT(Complaint("training: {}\n"), HasSubstr("key 'data' is missing"));
  EXPECT_THAT(Complaint("[1, 2]\n"), HasSubstr("c.yaml:1"));
}

TEST(DataConfigTest, BadValuesAreErrorsAtTheirPlace) {
  EXPECT_THAT(Complaint("data:\n  scenes: [a.glb]\n  pionts: 3\n"),
              AllOf(HasSubstr("c.yaml:3:"), HasSubstr("points")));
  EXPECT_THAT(Complaint("data: {points: 3}\n"), HasSubstr("names no scenes"));
  EXPECT_EQ(Complaint("data: {more_houses: {folder: more}}\n"), "nothing");
  EXPECT_THAT(Complaint("data: {more_houses: {folder: more, count: 0}}\n"),
              HasSubstr("count must lie"));
  EXPECT_THAT(Complaint("data: {houses: {index: my.json, count: 3}}\n"),
              HasSubstr("index.json; name that"));
  EXPECT_THAT(Complaint("data: {scenes: [a], points: 0}\n"), HasSubstr("points must lie"));
  EXPECT_THAT(Complaint("data: {scenes: [a], cache: ''}\n"), HasSubstr("'cache' is empty"));
  EXPECT_THAT(Complaint("data: {scenes: [a], hidden: maybe}\n"), HasSubstr("free, blocked"));
  EXPECT_THAT(Complaint("data: {scenes: [a], target_slack: 0.6}\n"), HasSubstr("target_slack"));
  EXPECT_THAT(Complaint("data: {scenes: [a], panorama: {max_depth_m: 3.1}}\n"),
              HasSubstr("at least 3.2"));
}

TEST(DataConfigTest, ReadsBackAsWritten) {
  DataConfig config;
  config.scenes = {"a.glb"};
  config.houses = DataHouses{"index.json", "val"};
  config.more_houses = HousesSpec{"more", 136, 5000};
  config.seed = 5;
  const std::string text = sim::ToYaml(config);
  EXPECT_EQ(sim::ToYaml(sim::LoadYamlText<DataConfig>(text, "c.yaml")), text);
}

TEST(DataConfigTest, ScenesAndHousesAreListed) {
  const tests::TemporaryFolder folder;
  const auto index = folder.Write("index.json", R"({"houses": [
    {"file": "h0.glb", "split": "train"}, {"file": "h1.glb", "split": "test"}]})");
  DataConfig config;
  config.scenes = {"a.glb"};
  config.houses = DataHouses{index.string()};
  EXPECT_THAT(ScenesOf(config), ElementsAre("a.glb", folder.path() / "h0.glb"));
  config.houses->split = "val";
  EXPECT_THROW(ScenesOf(config), sim::FileError);
}

TEST(DataConfigTest, HousesAreMadeOnlyWhereThereIsNoIndex) {
  const tests::TemporaryFolder folder;
  DataConfig config;
  config.houses = DataHouses{(folder.path() / "index.json").string(), "train", 2};
  std::vector<std::string> begun;
  const StartProgress start = [&](const std::string& what, int total) {
    begun.push_back(what + " " + std::to_string(total));
    throw sim::Error("enough");
    return std::function<void()>();
  };
  EXPECT_THROW(MakeHousesOf(config, "", 1, start), sim::Error);
  EXPECT_THAT(begun, ElementsAre("generating houses 2"));
  folder.Write("index.json", "{}");
  MakeHousesOf(config, "", 1, start);
  config.houses = DataHouses{"nowhere/index.json"};
  MakeHousesOf(config, "", 1, start);
  EXPECT_EQ(begun.size(), 1u);
}

TEST(DataConfigTest, MoreHousesComeLastWhateverTheirSplit) {
  const tests::TemporaryFolder folder;
  DataConfig config;
  config.scenes = {"a.glb"};
  config.more_houses = HousesSpec{folder.path().string(), 2, 7};
  EXPECT_THROW(ScenesOf(config), sim::FileError) << "not made yet";
  folder.Write("index.json", R"({"first_seed": 7, "houses": [
    {"file": "h0.glb", "split": "train", "seed": 7, "rooms": 3, "area_m2": 50},
    {"file": "h1.glb", "split": "test", "seed": 8, "rooms": 3, "area_m2": 50}]})");
  EXPECT_THAT(ScenesOf(config),
              ElementsAre("a.glb", folder.path() / "h0.glb", folder.path() / "h1.glb"));
  config.more_houses->first_seed = 8;
  EXPECT_THROW(ScenesOf(config), sim::FileError) << "others";
}

TEST(DataConfigTest, TheKeyDependsOnWhatLabelsDependOn) {
  const DataConfig config;
  DataConfig other = config;
  other.scenes = {"a.glb"};
  other.cache = "elsewhere";
  other.more_houses = HousesSpec{"more", 136, 5000};
  EXPECT_EQ(LabelsKey(other), LabelsKey(config));
  const auto key_with = [&](const auto& change) {
    DataConfig changed = config;
    change(&changed);
    return LabelsKey(changed);
  };
  std::vector<std::uint64_t> keys = {LabelsKey(config),
                                     key_with([](DataConfig* c) {
                                       c->seed = 1;
                                     }),
                                     key_with([](DataConfig* c) {
                                       c->points = 299;
                                     }),
                                     key_with([](DataConfig* c) {
                                       c->hidden = HiddenFloor::kBlocked;
                                     }),
                                     key_with([](DataConfig* c) {
                                       c->target_slack = 0.1;
                                     }),
                                     key_with([](DataConfig* c) {
                                       c->body.camera_height = 1.0f;
                                     }),
                                     key_with([](DataConfig* c) {
                                       c->navmesh.agent_radius = 0.2f;
                                     }),
                                     key_with([](DataConfig* c) {
                                       c->panorama.cols = 256;
                                     }),
                                     key_with([](DataConfig* c) {
                                       c->import.scale = 2.0;
                                     })};
  std::sort(keys.begin(), keys.end());
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

}  // namespace
}  // namespace bulletnav::bench
