// SPDX-License-Identifier: MIT
#include "benchmark/episodes/episode_file.h"

#include <cmath>
#include <functional>

#include <Eigen/Geometry>
#include <gmock/gmock.h>

#include "benchmark/base/gzip.h"
#include "benchmark/episodes/episode_json.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// As habitat-lab writes a set: whole numbers among the fractions, keys of its own, empty ones.
constexpr std::string_view kHabitatText =
    R"({"episodes":[{"episode_id":"0","scene_id":"gibson/Cantwell.glb",)"
    R"("scene_dataset_config":"default","additional_obj_config_paths":[],)"
    R"("start_position":[-1.2676633596420288,0.2047852873802185,12.595427513122559],)"
    R"("start_rotation":[0,0.4536385088584658,0,0.8911857849408661],)"
    R"("info":{"geodesic_distance":6.335,"difficulty":"hard","scan":{"floor":1}},)"
    R"("goals":[{"position":[-3,0.2047852873802185,7.25],"radius":null}],)"
    R"("start_room":null,"shortest_paths":[[{"position":[1,2,3],"rotation":[0,0,0,1],"action":1}]]}],)"
    R"("content_scenes_path":"{data_path}/content/{scene}.json.gz"})";

Episode MakeEpisode(int i, int goals) {
  sim::Rng rng(7, "episode");
  rng = rng.Fork("number", static_cast<std::uint64_t>(i));
  const auto point = [&] {
    return Eigen::Vector3d(rng.Normal(), 1e-17 * rng.Normal(), 1e5 * rng.Normal());
  };
  Episode episode;
  episode.id = "house_001-easy-" + std::to_string(i);
  episode.scene = "data/houses/house_001.glb";
  episode.start_position = point();
  episode.start_rotation = Rotation::FromYaw(rng.Uniform(-sim::kPi, sim::kPi));
  for (int k = 0; k < goals; ++k) {
    episode.goals.push_back(
        {point(), Rotation::FromYaw(rng.Uniform(-4.0, 4.0)), 1.0, rng.Uniform(0, 9)});
  }
  if (goals == 1) episode.difficulty = Difficulty::kMedium;
  return episode;
}

EpisodeSet MakeSet() {
  EpisodeSet set;
  for (int i = 0; i < 50; ++i) set.episodes.push_back(MakeEpisode(i, 1 + i % 4));
  return set;
}

class EpisodeFileTest : public testing::Test {
 protected:
  std::filesystem::path Path(const std::string& name) const { return folder_.path() / name; }
  std::string Complaint(std::string_view text) const {
    try {
      ReadEpisodes(folder_.Write("bad.json", text));
    } catch (const sim::FileError& e) {
      EXPECT_THAT(e.what(), HasSubstr("bad.json:"));
      return e.what();
    }
    return "nothing";
  }
  /// The complaint about a sound episode in which one thing was changed.
  std::string ComplaintAfter(const std::function<void(Json*)>& change) const {
    Json json = EpisodeToJson(MakeEpisode(3, 2));
    json["episode_id"] = "x7";
    change(&json);
    return Complaint(Json({{"episodes", Json::array({json})}}).dump());
  }

  tests::TemporaryFolder folder_;
};

TEST_F(EpisodeFileTest, ComesBackAsItWasWritten) {
  const EpisodeSet set = MakeSet();
  for (const EpisodeFormat format :
       {EpisodeFormat::kHabitat, EpisodeFormat::kList, EpisodeFormat::kNrns}) {
    for (const char* name : {"set.json", "set.json.gz"}) {
      WriteEpisodes(Path(name), set, format);
      EXPECT_EQ(ReadEpisodes(Path(name)), set);
    }
  }
}

TEST_F(EpisodeFileTest, SameEpisodesGiveTheSameBytes) {
  WriteEpisodes(Path("a.json.gz"), MakeSet());
  WriteEpisodes(Path("b.json.gz"), MakeSet());
  EXPECT_EQ(sim::ReadFile(Path("a.json.gz")), sim::ReadFile(Path("b.json.gz")));
  EXPECT_TRUE(IsGzip(sim::ReadFile(Path("a.json.gz"))));
}

TEST_F(EpisodeFileTest, HabitatFormIsReadAndWrittenToTheLetter) {
  const EpisodeSet set = ReadEpisodes(folder_.Write("habitat.json", kHabitatText));
  ASSERT_EQ(set.episodes.size(), 1u);
  const Episode& episode = set.episodes[0];
  EXPECT_EQ(episode.id, "0");
  EXPECT_EQ(episode.scene, "gibson/Cantwell.glb");
  EXPECT_EQ(episode.start_position.z(), 12.595427513122559);
  EXPECT_EQ(episode.start_rotation.y, 0.4536385088584658);
  EXPECT_EQ(episode.difficulty, Difficulty::kHard);
  ASSERT_EQ(episode.goals.size(), 1u);
  EXPECT_EQ(episode.goals[0].position.x(), -3.0);
  EXPECT_EQ(episode.goals[0].radius, std::nullopt);
  EXPECT_EQ(episode.goals[0].rotation, std::nullopt);
  EXPECT_EQ(episode.goals[0].geodesic_distance, 6.335);
  WriteEpisodes(Path("again.json"), set);
  EXPECT_EQ(sim::ReadTextFile(Path("again.json")), kHabitatText);
}

TEST_F(EpisodeFileTest, ChangedEpisodeKeepsWhatElseTheFileSaid) {
  EpisodeSet set = ReadEpisodes(folder_.Write("habitat.json", kHabitatText));
  set.episodes[0].id = "new";
  set.episodes[0].goals[0].radius = 0.2;
  WriteEpisodes(Path("new.json"), set);
  const EpisodeSet again = ReadEpisodes(Path("new.json"));
  EXPECT_EQ(again.episodes[0].id, "new");
  EXPECT_EQ(again.episodes[0].goals[0].radius, 0.2);
  EXPECT_THAT(sim::ReadTextFile(Path("new.json")),
              AllOf(HasSubstr(R"("scan":{"floor":1})"), HasSubstr("content_scenes_path"),
                    HasSubstr(R"("start_rotation":[0,0.4536)")));
}

TEST_F(EpisodeFileTest, OutsideInfoThereAreOnlyKeysThatHabitatKnows) {
  for (const int goals : {1, 3}) {
    const Json json = EpisodeToJson(MakeEpisode(1, goals));
    for (const auto& [key, value] : json.items()) {
      EXPECT_THAT(key, testing::AnyOf("episode_id", "scene_id", "start_position", "start_rotation",
                                      "info", "goals"));
    }
    ASSERT_EQ(json["goals"].size(), 1u);
    for (const auto& [key, value] : json["goals"][0].items()) {
      EXPECT_THAT(key, testing::AnyOf("position", "radius"));
    }
  }
}

TEST_F(EpisodeFileTest, ReadsTheBareListWithIntegerIds) {
  const EpisodeSet set = ReadEpisodes(folder_.Write(
      "list.json",
      R"([{"episode_id": 12, "scene_id": "gibson/Adrian.glb", "start_position": [1, 2, 3],
           "start_rotation": [0, 1, 0, 0], "goals": [{"position": [4, 2, 3], "radius": null}],
           "info": {"geodesic_distance": 11.5, "difficulty": "extra"},
           "start_room": null, "shortest_paths": null}])"));
  ASSERT_EQ(set.episodes.size(), 1u);
  EXPECT_EQ(set.episodes[0].id, "12");
  EXPECT_EQ(set.episodes[0].difficulty, std::nullopt);
  EXPECT_NEAR(set.episodes[0].start().yaw, sim::kPi, 1e-12);
  WriteEpisodes(Path("again.json"), set, EpisodeFormat::kList);
  const Json again = Json::parse(sim::ReadTextFile(Path("again.json")));
  EXPECT_EQ(again, Json::parse(sim::ReadTextFile(Path("list.json"))));
}

TEST_F(EpisodeFileTest, ReadsHeadingAndLengthOfNrns) {
  const EpisodeSet set = ReadEpisodes(
      folder_.Write("nrns.json",
                    R"({"episodes": [{"scene_id": "gibson/Ballou.glb", "episode_id": "Ballou_3",
           "start_position": [1, 2, 3], "start_rotation": [0, 0, 0, 1],
           "goals": [{"position": [1, 2, 0.5], "rotation": [0, 0.6, 0, 0.8]}],
           "length_shortest": 2.5}]})"));
  ASSERT_EQ(set.episodes.size(), 1u);
  const EpisodeGoal& goal = set.episodes[0].goals[0];
  EXPECT_EQ(goal.rotation, (Rotation{0, 0.6, 0, 0.8}));
  EXPECT_EQ(goal.geodesic_distance, 2.5);
  EXPECT_NEAR(set.episodes[0].goal(0).yaw, 2.0 * std::atan2(0.6, 0.8), 1e-12);
  WriteEpisodes(Path("habitat.json"), set);
  const Json json = Json::parse(sim::ReadTextFile(Path("habitat.json")))["episodes"][0];
  EXPECT_FALSE(json.contains("length_shortest"));
  EXPECT_FALSE(json["goals"][0].contains("rotation"));
  EXPECT_EQ(json["info"]["geodesic_distance"], 2.5);
}

TEST(Rotation, TurnsLikeABodyPose) {
  for (double yaw = -3.1; yaw < 3.2; yaw += 0.1) {
    const Rotation r = Rotation::FromYaw(yaw);
    EXPECT_NEAR(r.yaw(), yaw, 1e-12);
    // The quaternion turns -z, where an identity looks, to where the body looks.
    const Eigen::Vector3d turned =
        Eigen::Quaterniond(r.w, r.x, r.y, r.z) * -Eigen::Vector3d::UnitZ();
    EXPECT_LT((turned - sim::BodyPose{{}, yaw}.forward()).norm(), 1e-12);
  }
  EXPECT_NEAR((Rotation{0, -std::sin(0.5), 0, -std::cos(0.5)}).yaw(), 1.0, 1e-12);
}

TEST(Episode, GoalWithoutHeadingAlwaysLooksTheSameWay) {
  Episode episode = MakeEpisode(0, 2);
  episode.goals[0].rotation.reset();
  episode.goals[1].rotation.reset();
  const double yaw = episode.goal(0).yaw;
  EXPECT_NE(yaw, episode.goal(1).yaw);
  episode.scene = "/elsewhere/house_001.glb";
  EXPECT_EQ(yaw, episode.goal(0).yaw);
  episode.id = "another";
  EXPECT_NE(yaw, episode.goal(0).yaw);
}

TEST(Difficulty, BandsMeetWithoutOverlap) {
  EXPECT_EQ(DifficultyAt(1.49), std::nullopt);
  EXPECT_EQ(DifficultyAt(1.5), Difficulty::kEasy);
  EXPECT_EQ(DifficultyAt(3.0), Difficulty::kMedium);
  EXPECT_EQ(DifficultyAt(5.0), Difficulty::kHard);
  EXPECT_EQ(DifficultyAt(10.0), Difficulty::kHard);
  EXPECT_EQ(DifficultyAt(10.01), Difficulty::kVeryHard);
  EXPECT_EQ(DifficultyAt(20.0), Difficulty::kExtreme);
  EXPECT_EQ(DifficultyAt(40.01), std::nullopt);
  for (const Difficulty d : kDifficulties) EXPECT_EQ(DifficultyNamed(DifficultyName(d)), d);
}

TEST_F(EpisodeFileTest, NamesTheEpisodeAndThePlaceOfEveryFault) {
  using Change = std::function<void(Json*)>;
  const auto check = [&](const Change& change, const char* place, const char* what) {
    EXPECT_THAT(ComplaintAfter(change), AllOf(HasSubstr(place), HasSubstr(what)));
  };
  check(
      [](Json* e) {
        e->erase("start_position");
      },
      "episode 'x7':", "'start_position' is missing");
  check(
      [](Json* e) {
        (*e)["scene_id"] = "";
      },
      "episode 'x7': scene_id:", "is empty");
  check(
      [](Json* e) {
        e->erase("scene_id");
      },
      "episode 'x7':", "'scene_id' is missing");
  check(
      [](Json* e) {
        (*e)["episode_id"] = nullptr;
      },
      "episodes[0]: episode_id:", "text");
  check(
      [](Json* e) {
        (*e)["start_position"][1] = nullptr;
      },
      "start_position[1]:", "a number");
  check(
      [](Json* e) {
        (*e)["start_position"].push_back(1);
      },
      "start_position:", "list of 3, got 4");
  check(
      [](Json* e) {
        (*e)["start_rotation"] = {0, 0.5, 0, 0.5};
      },
      "start_rotation:", "unit");
  check(
      [](Json* e) {
        (*e)["start_rotation"] = {0.6, 0, 0, 0.8};
      },
      "start_rotation:", "tilts");
  check(
      [](Json* e) {
        (*e)["goals"] = Json::array();
      },
      "goals:", "has 0 goals");
  check(
      [](Json* e) {
        (*e)["goals"][0]["radius"] = -1;
      },
      "goals[0].radius:", "negative");
  check(
      [](Json* e) {
        (*e)["info"].erase("geodesic_distance");
      },
      "info:", "is missing");
  check(
      [](Json* e) {
        (*e)["info"] = "none";
      },
      "info:", "expected an object");
  check(
      [](Json* e) {
        (*e)["info"]["further_goals"][0]["position"][2] = "x";
      },
      "info.further_goals[0].position[2]:", "a number");
  check(
      [](Json* e) {
        *e = 5;
      },
      "episodes[0]:", "an object");
}

TEST_F(EpisodeFileTest, SaysWhereTheTextIsBad) {
  EXPECT_THAT(Complaint("{\"episodes\": [\n {\"start_position\": [NaN, 0, 0]}]}"),
              AllOf(HasSubstr("bad.json:2:"), HasSubstr("NaN and infinity")));
  EXPECT_THAT(Complaint("{\"episodes\": [1e999]}"), HasSubstr("too large"));
  EXPECT_THAT(Complaint("{\"episodes\" [1]}"), AllOf(HasSubstr(":1:13"), HasSubstr("not valid")));
  EXPECT_THAT(Complaint(std::string(5000, '[')), HasSubstr("64 levels"));
  EXPECT_THAT(Complaint(""), HasSubstr("is empty"));
  EXPECT_THAT(Complaint("{\"episodes\": []}"), HasSubstr("holds no episodes"));
  EXPECT_THAT(Complaint("{}"), HasSubstr("'episodes' is missing"));
  EXPECT_THAT(Complaint("17"), HasSubstr("expected an object"));
}

TEST_F(EpisodeFileTest, RefusesEveryTruncation) {
  EpisodeSet set;
  set.episodes = {MakeEpisode(0, 2)};
  WriteEpisodes(Path("whole.json"), set);
  const std::string text = sim::ReadTextFile(Path("whole.json"));
  for (std::size_t size = 1; size < text.size(); ++size) {
    EXPECT_THAT(Complaint(text.substr(0, size)), HasSubstr("cut off")) << text.substr(0, size);
  }
}

/// Whatever happens to a file, it is read or refused in one line.
TEST_F(EpisodeFileTest, SurvivesRandomDamage) {
  EpisodeSet set;
  set.episodes = {MakeEpisode(0, 1), MakeEpisode(1, 3)};
  for (const char* name : {"set.json", "set.json.gz"}) {
    for (const EpisodeFormat format : {EpisodeFormat::kHabitat, EpisodeFormat::kNrns}) {
      WriteEpisodes(Path(name), set, format);
      const std::string sound = sim::ReadTextFile(Path(name));
      sim::Rng rng(11, name);
      for (int i = 0; i < 150; ++i) {
        std::string bad = sound;
        constexpr std::string_view kBytes = "{}[]\",:0-9.eEnull\xff \n";
        for (int k = rng.Between(1, 3); k > 0; --k) {
          bad[static_cast<std::size_t>(rng.Below(static_cast<int>(bad.size())))] = rng.Pick(kBytes);
        }
        EXPECT_THAT(Complaint(bad), Not(HasSubstr("\n")));
      }
    }
  }
}

TEST_F(EpisodeFileTest, RefusesIdsGivenTwiceInAScene) {
  EpisodeSet set = MakeSet();
  set.episodes[20].id = set.episodes[4].id;
  WriteEpisodes(Path("twice.json"), set);
  try {
    ReadEpisodes(Path("twice.json"));
    ADD_FAILURE();
  } catch (const sim::FileError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("episodes[20]"), HasSubstr("episodes[4]"),
                                HasSubstr("house_001-easy-4")));
  }
  set.episodes[20].scene = "another.glb";
  WriteEpisodes(Path("twice.json"), set);
  EXPECT_EQ(ReadEpisodes(Path("twice.json")), set);
}

TEST_F(EpisodeFileTest, FindsScenesAsNamedAndBelowFolders) {
  std::filesystem::create_directories(Path("scenes/gibson"));
  const auto file = folder_.Write("scenes/gibson/a.glb", "x");
  EXPECT_EQ(FindScene(file.string(), {}), file);
  EXPECT_EQ(FindScene("gibson/a.glb", {Path("empty"), Path("scenes")}), file);
  try {
    FindScene("gibson/b.glb", {Path("scenes")});
    ADD_FAILURE();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("gibson/b.glb"), HasSubstr("make or fetch")));
  }
}

}  // namespace
}  // namespace bulletnav::bench
