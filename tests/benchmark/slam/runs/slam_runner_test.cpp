// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_runner.h"

#include <map>
#include <sstream>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/slam/io/tum.h"
#include "benchmark/slam/runs/drive_files.h"
#include "benchmark/slam/runs/slam_table.h"
#include "benchmark/slam/traversal/tum_recorder.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/killed.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A room of 6 x 5 m with a ceiling, as OBJ.
constexpr const char* kRoom =
    "v 0 0 0\nv 6 0 0\nv 6 0 -5\nv 0 0 -5\nv 0 2.5 0\nv 6 2.5 0\nv 6 2.5 -5\nv 0 2.5 -5\n"
    "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

class SlamRunner : public ::testing::Test {
 protected:
  SlamRunner() { folder_.Write("room.obj", kRoom); }

  fs::path path(const char* name) const { return folder_.path() / name; }

  SlamConfig Config(const std::string& more = "") const {
    const std::string scene = (folder_.path() / "room.obj").string();
    return LoadSlamConfig(folder_.Write(
        "drive.yaml", "scenes: [" + scene + "]\nactions: [60]\nseeds: [3, 4]\napart_m: 1\n" +
                          "camera: {rows: 24, cols: 32}\ndetectors: [{detector: seqslam}]\n" +
                          more));
  }

  tests::TemporaryFolder folder_;
};

TEST_F(SlamRunner, WritesTheSameForAnyNumberOfWorkersAndAfterAKill) {
  const SlamConfig config = Config();
  EXPECT_EQ(config.name, "drive");
  SlamRunOptions two;
  two.workers = 2;
  const auto results = RunSlam(config, path("two"), two);
  SlamRunOptions one;
  one.workers = 1;
  RunSlam(config, path("one"), one);
  // What a kill leaves: a drive without its result.
  fs::remove(path("one") / "drives/room_60_3/result.yaml");
  EXPECT_EQ(RunSlam(config, path("one"), one).size(), 2u);
  for (const char* drive : {"room_60_3", "room_60_4"}) {
    for (const char* file : {"result.yaml", "odometry.tum", "groundtruth.tum", "seqslam.csv",
                             "seqslam.tum", "seqslam.g2o"}) {
      EXPECT_EQ(sim::ReadTextFile(path("one") / "drives" / drive / file),
                sim::ReadTextFile(path("two") / "drives" / drive / file))
          << drive << " " << file;
    }
  }
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].frames, 61);
  EXPECT_GT(results[0].travelled_m, 3.0);
  ASSERT_TRUE(results[0].odometry.has_value());
  EXPECT_GT(results[0].odometry->start.max, 0.0);
  ASSERT_EQ(results[0].detectors.size(), 1u);
  EXPECT_EQ(results[0].detectors[0].rankings.size(), 3u);
  // Written and read again, and printed from that.
  EXPECT_EQ(ReadSlamResults(ReadSlamRun(path("one")), path("one")).size(), 2u);
  EXPECT_THAT(SlamTables(config, results),
              AllOf(HasSubstr("Drives of 60 actions (2)"), HasSubstr("| odometry alone | 0.000 |"),
                    HasSubstr("| seqslam | near |"), HasSubstr("| true loops |")));
}

/// All files of a run but its lock and the times that its parts took.
std::map<std::string, std::string> BytesOf(const fs::path& folder) {
  std::map<std::string, std::string> bytes;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (!entry.is_regular_file() || name == "lock" || name.find("times") != std::string::npos) {
      continue;
    }
    bytes[name] = sim::ReadTextFile(entry.path());
  }
  return bytes;
}

/// With words, a filter over places and learned descriptors, one worker where it is not killed.
TEST_F(SlamRunner, KilledAtAnyMomentItGoesOnToTheSameBytes) {
  folder_.Write("colors.obj",
                "v 0 0 0 1 0 0\nv 6 0 0 0 1 0\nv 6 0 -5 0 0 1\nv 0 0 -5 1 1 0\n"
                "v 0 2.5 0 0 1 1\nv 6 2.5 0 1 0 1\nv 6 2.5 -5 1 1 1\nv 0 2.5 -5 0 0 0\n"
                "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
  const SlamConfig config = LoadSlamConfig(folder_.Write(
      "drive.yaml", "scenes: [" + path("colors.obj").string() +
                        "]\nactions: [40]\nseeds: [3, 4, 5, 6]\napart_m: 1\n"
                        "camera: {rows: 96, cols: 128}\ndescriptors: " BULLETNAV_WEIGHTS
                        "/place_rgb.safetensors\ndetectors: [{detector: rtabmap_like}, "
                        "{detector: gem_flat}, {detector: hut}]\n"));
  SlamRunOptions one;
  one.workers = 1;
  RunSlam(config, path("whole"), one);
  SlamRunOptions two;
  two.workers = 2;
  const int kills = tests::KillUntilDone(
      [&] {
        RunSlam(config, path("killed"), two);
      },
      std::chrono::milliseconds(60),
      [](tests::Delay delay) {
        return delay + delay / 2;
      });
  EXPECT_GT(kills, 1);
  const auto whole = BytesOf(path("whole"));
  const auto killed = BytesOf(path("killed"));
  EXPECT_GT(whole.size(), 4u * 9u);
  for (const auto& [file, bytes] : whole) {
    EXPECT_TRUE(killed.contains(file) && killed.at(file) == bytes) << file;
  }
  for (const auto& [file, bytes] : killed) EXPECT_TRUE(whole.contains(file)) << file;
}

/// x, y, z of the lines `t x y z qx qy qz qw` of a file, and the turn of the first.
std::pair<Eigen::Matrix3Xd, Eigen::Quaterniond> ReadPlaces(const fs::path& file) {
  std::istringstream lines(sim::ReadTextFile(file));
  std::vector<Eigen::Vector3d> places;
  Eigen::Quaterniond first;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::istringstream numbers(line);
    double time = 0.0;
    Eigen::Vector3d at;
    Eigen::Quaterniond turn;
    numbers >> time >> at.x() >> at.y() >> at.z() >> turn.x() >> turn.y() >> turn.z() >> turn.w();
    EXPECT_FALSE(numbers.fail()) << line;
    if (places.empty()) first = turn;
    places.push_back(at);
  }
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    columns.col(static_cast<Eigen::Index>(i)) = places[i];
  }
  return {columns, first};
}

/// From the files that a run writes, read and laid over each other by other means than its own:
/// rotations of space, and Eigen's Umeyama.
TEST_F(SlamRunner, FilesHaveTheErrorsOfTheTable) {
  const DriveResult result = RunSlam(Config(), path("run"), {}).front();
  const fs::path drive = path("run") / "drives" / result.drive;
  const auto [truth, truth_turn] = ReadPlaces(drive / "groundtruth.tum");
  for (const std::string name : {"odometry", "seqslam"}) {
    const BothErrors& errors =
        name == "odometry" ? *result.odometry : *result.detectors[0].outcome.error;
    const auto [places, turn] = ReadPlaces(drive / (name + ".tum"));
    ASSERT_EQ(places.cols(), truth.cols());
    const Eigen::Matrix3d over = (truth_turn * turn.inverse()).toRotationMatrix();
    const Eigen::VectorXd from_start =
        ((over * (places.colwise() - places.col(0))) - (truth.colwise() - truth.col(0)))
            .colwise()
            .norm();
    EXPECT_NEAR(from_start.mean(), errors.start.mean, 1e-6) << name;
    EXPECT_NEAR(from_start.maxCoeff(), errors.start.max, 1e-6) << name;
    const Eigen::Matrix3d best = Eigen::umeyama(places.topRows(2), truth.topRows(2), false);
    const Eigen::Matrix2Xd moved =
        (best.topLeftCorner<2, 2>() * places.topRows(2)).colwise() + best.topRightCorner<2, 1>();
    const Eigen::VectorXd laid_over = (moved - truth.topRows(2)).colwise().norm();
    EXPECT_NEAR(laid_over.mean(), errors.planar.mean, 1e-6) << name;
    EXPECT_NEAR(laid_over.minCoeff(), errors.planar.min, 1e-6) << name;
  }
}

/// A row that is added later is the one that it would have been from the start, among the others.
TEST_F(SlamRunner, DetectorsThatAreAddedArePlayedAlone) {
  RunSlam(Config(), path("run"), {});
  const fs::path room = path("room.obj");
  const auto with = [&](const std::string& detectors) {
    return LoadSlamConfig(folder_.Write(
        "drive.yaml", "scenes: [" + room.string() + "]\nactions: [60]\nseeds: [3, 4]\n" +
                          "apart_m: 1\ncamera: {rows: 24, cols: 32}\ndetectors: " + detectors));
  };
  const SlamConfig more = with(
      "[{detector: seqslam, name: short, parameters: {length: 5}}, {detector: seqslam}, "
      "{detector: rtabmap_like}]\nagainst: short\n");
  const auto added = RunSlam(more, path("run"), {});
  ASSERT_EQ(added.size(), 2u);
  ASSERT_EQ(added[0].detectors.size(), 3u);
  RunSlam(more, path("fresh"), {});
  EXPECT_EQ(sim::ReadTextFile(path("run") / "config.yaml"),
            sim::ReadTextFile(path("fresh") / "config.yaml"));
  for (const char* file : {"result.yaml", "short.csv", "seqslam.g2o", "rtabmap_like.tum"}) {
    const fs::path drive = fs::path("drives/room_60_4") / file;
    EXPECT_EQ(sim::ReadTextFile(folder_.path() / "run" / drive),
              sim::ReadTextFile(folder_.path() / "fresh" / drive))
        << file;
  }
  EXPECT_EQ(ReadDriveTimes(path("run") / "drives/room_60_4").size(), 5u);
  for (const char* other : {"[{detector: seqslam}]",
                            "[{detector: seqslam, parameters: {length: 5}}, "
                            "{detector: seqslam, name: short, parameters: {length: 5}}, "
                            "{detector: rtabmap_like}]\nagainst: short\n"}) {
    EXPECT_THAT(
        [&] {
          RunSlam(with(other), path("run"), {});
        },
        ThrowsMessage<sim::FileError>(HasSubstr("may only add detectors")))
        << other;
  }
}

/// Results are kept, and moved, without what they were made from.
TEST_F(SlamRunner, ResultsAreReadWithoutTheirScenes) {
  const auto results = RunSlam(Config(), path("run"), {});
  fs::remove(path("room.obj"));
  fs::rename(path("run"), path("moved"));
  const SlamConfig config = ReadSlamRun(path("moved"));
  const auto read = ReadSlamResults(config, path("moved"));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].drive, "room_60_3");
  EXPECT_EQ(SlamTables(config, read), SlamTables(config, results));
  fs::remove_all(path("moved") / "drives");
  EXPECT_THAT(
      [&] {
        ReadSlamResults(config, path("moved"));
      },
      ThrowsMessage<sim::FileError>(HasSubstr("no drive that is done")));
}

TEST_F(SlamRunner, AResultThatWasCutOffIsTold) {
  const SlamConfig config = Config();
  RunSlam(config, path("run"), {});
  const fs::path file = path("run") / "drives/room_60_3/result.yaml";
  const std::string text = sim::ReadTextFile(file);
  sim::WriteFileAtomically(file, text.substr(0, text.find("detectors:")));
  EXPECT_THAT(
      [&] {
        ReadSlamResults(config, path("run"));
      },
      ThrowsMessage<sim::FileError>(AllOf(HasSubstr("room_60_3"), HasSubstr("remove the folder"))));
}

TEST_F(SlamRunner, ResultsOfAnotherCommandAreTold) {
  folder_.Write("played/config.yaml", "name: real_scenes\nepisodes: {file: all.json}\n");
  EXPECT_THAT(
      [&] {
        ReadSlamRun(path("played"));
      },
      ThrowsMessage<sim::FileError>(HasSubstr("of another command than 'slam run'")));
}

TEST_F(SlamRunner, AFolderOfAnotherConfigIsLeftAlone) {
  RunSlam(Config(), path("run"), {});
  const SlamConfig other = Config("name: other\n");
  EXPECT_THAT(
      [&] {
        RunSlam(other, path("run"), {});
      },
      ThrowsMessage<sim::FileError>(HasSubstr("another config")));
}

/// A drive that was written as files is played from them to the same poses and loops.
TEST_F(SlamRunner, PlaysARecording) {
  const SlamConfig drives = Config();
  TraversalSpec traversal;
  traversal.camera = drives.camera;
  traversal.actions = 60;
  traversal.seed = 3;
  TumRecorder recorder(path("recording"), traversal);
  sim::WorldOptions options;
  options.backend = sim::Backend::kEmbree;
  Traverse(sim::World::Load(path("room.obj"), options), traversal,
           [&](const TraversalFrame& frame) {
             recorder.Add(frame);
           });
  recorder.Finish();
  const SlamConfig config = LoadSlamConfig(
      folder_.Write("files.yaml", "recordings: [" + path("recording").string() +
                                      "]\napart_m: 1\ndetectors: [{detector: seqslam}]\n"));
  const DriveResult played = RunSlam(config, path("files"), {}).front();
  const DriveResult driven = RunSlam(drives, path("drives"), {}).front();
  EXPECT_EQ(played.frames, driven.frames);
  EXPECT_NEAR(played.travelled_m, driven.travelled_m, 1e-6);
  EXPECT_NEAR(played.odometry->start.mean, driven.odometry->start.mean, 1e-6);
  EXPECT_NEAR(played.detectors[0].rankings.at("near").figures.average_precision,
              driven.detectors[0].rankings.at("near").figures.average_precision, 1e-6);
  EXPECT_THAT(SlamTables(config, {&played, 1}), HasSubstr("Recordings (1)"));

  // Another clock: what is written goes by it.
  for (const char* list : {"rgb.txt", "depth.txt", "groundtruth.txt", "odometry.txt"}) {
    std::istringstream lines(sim::ReadTextFile(path("recording") / list));
    std::string later;
    for (std::string line; std::getline(lines, line);) {
      later += line.starts_with("#") ? "" : "13";
      later += line + "\n";
    }
    sim::WriteFileAtomically(path("recording") / list, later);
  }
  RunSlam(config, path("later"), {});
  for (const char* name : {"groundtruth", "odometry", "seqslam"}) {
    const fs::path file = path("later") / "drives/recording" / (std::string(name) + ".tum");
    EXPECT_NEAR(ReadTumTrajectory(file)[1].time, 130.1, 1e-9) << name;
  }

  fs::remove(path("recording") / "groundtruth.txt");
  const DriveResult unknown = RunSlam(config, path("unknown"), {}).front();
  EXPECT_FALSE(unknown.odometry.has_value());
  EXPECT_THAT(SlamTables(config, {&unknown, 1}), HasSubstr("1 drive without ground truth"));

  fs::remove(path("recording") / "odometry.txt");
  EXPECT_THAT(
      [&] {
        RunSlam(config, path("none"), {});
      },
      ThrowsMessage<sim::FileError>(AllOf(HasSubstr("odometry.txt"), HasSubstr("write"))));
}

/// Panoramas know a place whichever way the body looks.
TEST_F(SlamRunner, DrivesWithPanoramas) {
  const std::string scene = path("room.obj").string();
  const std::string head = "scenes: [" + scene + "]\nactions: [60]\napart_m: 1\n";
  const SlamConfig around = LoadSlamConfig(
      folder_.Write("around.yaml", head + "panorama: {}\ndetectors: [{detector: seqslam}]\n"));
  const DriveResult result = RunSlam(around, path("around"), {}).front();
  EXPECT_EQ(result.frames, 61);
  ASSERT_TRUE(result.true_loops.has_value());
  // Nearly all pairs of an empty room are covisible, in flat pictures few.
  const auto covisible = [](const DriveResult& of) {
    return of.detectors[0].rankings.at("covisible").figures.guessing;
  };
  EXPECT_GT(covisible(result), 0.9);
  const SlamConfig flat = LoadSlamConfig(folder_.Write(
      "flat.yaml", head + "camera: {rows: 24, cols: 32}\ndetectors: [{detector: seqslam}]\n"));
  EXPECT_LT(covisible(RunSlam(flat, path("flat"), {}).front()), 0.7);
}

TEST_F(SlamRunner, ABadConfigIsToldWithItsPlace) {
  const auto load = [this](const std::string& text) {
    return [this, text] {
      LoadSlamConfig(folder_.Write("bad.yaml", text));
    };
  };
  EXPECT_THAT(load("places: some.safetensors\ndetectors: [{detector: seqslam}]\n"),
              ThrowsMessage<sim::FileError>(HasSubstr("needs 'panorama'")));
  EXPECT_THAT(load("panorama: {projection: cube_strip}\ndetectors: [{detector: seqslam}]\n"),
              ThrowsMessage<sim::FileError>(HasSubstr("must be cylindrical")));
  EXPECT_THAT(load("detectors: []\n"), ThrowsMessage<sim::FileError>(HasSubstr("no entry")));
  EXPECT_THAT(load("detectors:\n  - {detector: bwo}\n"),
              ThrowsMessage<sim::FileError>(AllOf(HasSubstr("bad.yaml:2"), HasSubstr("bow"))));
  EXPECT_THAT(load("detectors: [{detector: seqslam}, {detector: seqslam}]\n"),
              ThrowsMessage<sim::FileError>(HasSubstr("give one a 'name'")));
  EXPECT_THAT(load("detectors: [{detector: seqslam, parameters: {patch: 0}}]\n"),
              ThrowsMessage<sim::FileError>(HasSubstr("multiples of patch")));
  EXPECT_THAT(load("detectors: [{detector: seqslam}]\nagainst: bow\n"),
              ThrowsMessage<sim::FileError>(AllOf(HasSubstr("bad.yaml:2"), HasSubstr("'bow'"))));
  EXPECT_THAT(load("apart_m: 0\ndetectors: [{detector: bow}]\n"),
              ThrowsMessage<sim::FileError>(HasSubstr("bad.yaml:1")));
}

TEST_F(SlamRunner, WeightsThatAreMissingAreTold) {
  EXPECT_THAT(
      [&] {
        Config("sequences: s.safetensors\n");
      },
      ThrowsMessage<sim::FileError>(HasSubstr("'sequences' needs 'descriptors'")));
  const SlamConfig config = Config("descriptors: nowhere.safetensors\n");
  EXPECT_THAT(
      [&] {
        RunSlam(config, path("run"), {});
      },
      ThrowsMessage<sim::FileError>(
          AllOf(HasSubstr("nowhere.safetensors"), HasSubstr("place.yaml"))));
}

/// A scene that was exchanged is another experiment.
TEST_F(SlamRunner, ARunDoesNotGoOnInAChangedScene) {
  RunSlam(Config(), path("run"), {});
  fs::remove_all(path("run") / "drives/room_60_3");
  folder_.Write("room.obj", std::string(kRoom) + "v 1 1 -1\nv 2 1 -1\nv 2 1 -2\nf 9 10 11\n");
  EXPECT_THAT(
      [&] {
        RunSlam(Config(), path("run"), {});
      },
      ThrowsMessage<sim::FileError>(AllOf(HasSubstr("room.obj"), HasSubstr("has changed"))));
}

/// Names of detectors are those of files and of cells.
TEST_F(SlamRunner, NamesThatAreNoFilesAreRefused) {
  for (const char* name : {"../x", "odometry", "a|b", "\"a b\"", "-x", "''"}) {
    const std::string text = "scenes: [" + path("room.obj").string() +
                             "]\ndetectors: [{detector: seqslam, name: " + name + "}]\n";
    if (std::string_view(name) == "''") {
      EXPECT_EQ(LoadSlamConfig(folder_.Write("n.yaml", text)).detectors[0].name, "seqslam");
      continue;
    }
    EXPECT_THAT(
        [&] {
          LoadSlamConfig(folder_.Write("n.yaml", text));
        },
        ThrowsMessage<sim::FileError>(HasSubstr("n.yaml:2")))
        << name;
  }
  EXPECT_THROW(
      LoadSlamConfig(folder_.Write("m.yaml", "name: ../m\ndetectors: [{detector: seqslam}]\n")),
      sim::FileError);
  EXPECT_THROW(LoadSlamConfig(folder_.Write("p.yaml",
                                            "recordings: [x]\npanorama: {}\n"
                                            "detectors: [{detector: seqslam}]\n")),
               sim::FileError);
}

TEST(SlamConfig, EveryShippedOneLoads) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(BULLETNAV_CONFIGS) / "slam")) {
    if (entry.path().filename() == "scale.yaml") continue;  // of another command
    const SlamConfig config = LoadSlamConfig(entry.path());
    EXPECT_FALSE(config.detectors.empty()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 2);
}

TEST_F(SlamRunner, OfHousesTheFirstMayBeEnough) {
  SlamConfig config = Config();
  config.scenes.clear();
  config.houses = HousesSpec{path("houses").string(), 2, 7};
  folder_.Write("houses/index.json", R"({"first_seed": 7, "houses": [
    {"file": "h0.glb", "split": "train", "seed": 7, "rooms": 3, "area_m2": 50},
    {"file": "h1.glb", "split": "test", "seed": 8, "rooms": 3, "area_m2": 50}]})");
  EXPECT_EQ(DrivesOf(config).size(), 2 * DrivesOf([&] {
                                           SlamConfig first = config;
                                           first.first_houses = 1;
                                           return first;
                                         }())
                                             .size());
  config.first_houses = 0;
  EXPECT_THROW(config.Validate(), sim::KeyError);
}

TEST_F(SlamRunner, SomethingMustBeThereToDriveThrough) {
  SlamConfig config = Config();
  config.scenes.clear();
  EXPECT_THROW(DrivesOf(config), sim::Error);
  config.scenes = {path("nowhere.obj").string()};
  EXPECT_THROW(DrivesOf(config), sim::FileError);
  folder_.Write("other/room.obj", kRoom);
  config.scenes = {path("room.obj").string(), path("other/room.obj").string()};
  EXPECT_EQ(DrivesOf(config)[2].name, "other_room_60_3");
  config.scenes = {path("other").string()};
  EXPECT_EQ(DrivesOf(config)[0].source, path("other") / "room.obj");
  folder_.Write("empty/readme.txt", "no mesh");
  config.scenes = {path("empty").string()};
  EXPECT_THROW(DrivesOf(config), sim::FileError);
  config.scenes = {path("room.obj").string(), path("room.obj").string()};
  EXPECT_THAT(
      [&] {
        DrivesOf(config);
      },
      ThrowsMessage<sim::Error>(HasSubstr("two drives are called")));
}

}  // namespace
}  // namespace bulletnav::bench
