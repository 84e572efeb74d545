// SPDX-License-Identifier: MIT
// Recordings that come in and go out.
#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/slam/io/file_frames.h"
#include "benchmark/slam/io/g2o.h"
#include "benchmark/slam/io/kitti_folder.h"
#include "benchmark/slam/io/tum.h"
#include "benchmark/slam/io/tum_writer.h"
#include "benchmark/slam/recordings/export_recording.h"
#include "benchmark/slam/recordings/import_recording.h"
#include "benchmark/slam/runs/slam_runner.h"
#include "benchmark/slam/runs/slam_table.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

constexpr int kWidth = 160;
constexpr int kHeight = 120;
constexpr Intrinsics kCamera = {100.0, 100.0, 79.5, 59.5};

/// Random rectangles.
sim::Image Wall() {
  sim::Image wall(2 * kWidth, kHeight, 3);
  sim::Rng rng(1, "wall");
  for (int i = 0; i < 400; ++i) {
    const int x0 = rng.Below(wall.width - 12);
    const int y0 = rng.Below(kHeight - 12);
    const int x1 = x0 + rng.Between(4, 11);
    const int y1 = y0 + rng.Between(4, 11);
    const auto grey = static_cast<std::uint8_t>(rng.Below(256));
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) std::fill_n(wall.at(x, y), 3, grey);
    }
  }
  return wall;
}

/// What a camera sees of a wall 2 m before it once it has moved to the right by so many pixels.
RecordedFrame Frame(int number, int pixels) {
  static const sim::Image wall = Wall();
  RecordedFrame frame;
  frame.time = 0.1 * number;
  frame.color = sim::Image(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y) {
    std::copy_n(wall.at(pixels, y), 3 * kWidth, frame.color.at(0, y));
  }
  frame.depth = {kWidth, kHeight, std::vector<float>(kWidth * kHeight, 2.0F)};
  return frame;
}

/// Metres to the right.
double Moved(int pixels) {
  return pixels * 2.0 / kCamera.fx;
}

class Recordings : public ::testing::Test {
 protected:
  /// Four frames, a step of 5 pixels to the right each.
  template <class Writer>
  fs::path Record(const char* name, bool has_poses) {
    const fs::path folder = folder_.path() / name;
    Writer writer(folder, kCamera);
    for (int i = 0; i < 4; ++i) {
      RecordedFrame frame = Frame(i, 5 * i);
      if (has_poses) {
        frame.truth = CameraInFile(sim::PlanarPose{0.0, -Moved(5 * i), 0.0}, 1.0);
        frame.odometry = CameraInFile(sim::PlanarPose{0.0, -Moved(6 * i), 0.0}, 1.0);
      }
      writer.Add(frame);
    }
    writer.Finish();
    return folder;
  }

  ImportOutcome Import(const fs::path& source, const char* out) const {
    return ImportRecording({.source = source, .out = folder_.path() / out});
  }

  /// The results of a run on one recording.
  fs::path Run(const fs::path& recording) const {
    const SlamConfig config = LoadSlamConfig(folder_.Write(
        "r.yaml",
        "recordings: [" + recording.string() +
            "]\napart_m: 1\ndetectors: [{detector: seqslam, parameters: {length: 1}}]\n"));
    fs::path run = folder_.path() / "run" / recording.filename();
    RunSlam(config, run, {});
    return run;
  }

  tests::TemporaryFolder folder_;
};

TEST_F(Recordings, ImportTakesWhatExportWrote) {
  const fs::path tum = Record<TumWriter>("tum", true);
  EXPECT_EQ(ExportRecording({.source = tum, .out = folder_.path() / "again"}), 4);
  const ImportOutcome outcome = Import(folder_.path() / "again", "in");
  EXPECT_EQ(outcome.format, "TUM");
  EXPECT_EQ(outcome.frames, 4);
  EXPECT_EQ(outcome.with_truth, 4);
  EXPECT_FALSE(outcome.is_visual);
  for (const char* file : {"rgb.txt", "depth.txt", "groundtruth.txt", "odometry.txt",
                           "calibration.txt", "rgb/000003.png", "depth/000003.png"}) {
    EXPECT_EQ(sim::ReadFile(folder_.path() / "in" / file), sim::ReadFile(tum / file)) << file;
  }
}

TEST_F(Recordings, PicturesWithoutDepthAreCounted) {
  const fs::path tum = Record<TumWriter>("tum", true);
  sim::WriteFileAtomically(tum / "depth.txt",
                           "0 depth/000000.png\n0.1 depth/000001.png\n0.33 depth/000003.png\n");
  const ImportOutcome outcome = Import(tum, "in");
  EXPECT_EQ(outcome.frames, 2);
  EXPECT_EQ(outcome.left_out, 2);
}

TEST_F(Recordings, KittiGoesOutAndComesIn) {
  const fs::path tum = Record<TumWriter>("tum", true);
  const fs::path kitti = folder_.path() / "kitti";
  ExportRecording({.source = tum, .out = kitti, .format = RecordingFormat::kKitti});
  const ImportOutcome outcome = Import(kitti, "in");
  EXPECT_EQ(outcome.format, "KITTI");
  EXPECT_EQ(outcome.with_truth, 4);
  const auto odometry = ReadTumTrajectory(folder_.path() / "in/odometry.txt");
  ASSERT_EQ(odometry.size(), 4u);
  EXPECT_NEAR(PlanarFromFile(odometry[3].pose).y, -Moved(18), 1e-9);
  EXPECT_NEAR(odometry[3].time, 0.3, 1e-12);
  const DepthPicture depth = ReadTumDepth(folder_.path() / "in/depth/000000.png");
  EXPECT_NEAR(depth.metres[100], 2.0, 1e-6);
}

/// By hand: a sequence of stereo pictures without odometry. The right camera is .2 m to the right,
/// where the wall is seen 10 pixels further left.
TEST_F(Recordings, AHandMadeStereoSequenceGetsDepthAndOdometry) {
  folder_.Write("s/calib.txt",
                "P2: 100 0 79.5 0 0 100 59.5 0 0 0 1 0\nP3: 100 0 79.5 -20 0 100 59.5 0 0 0 1 0\n");
  std::string times;
  for (int i = 0; i < 3; ++i) {
    times += std::to_string(0.1 * i) + "\n";
    const std::string name = "00000" + std::to_string(i) + ".png";
    sim::WritePng(folder_.path() / "s/image_2" / name, Frame(i, 4 * i).color);
    sim::WritePng(folder_.path() / "s/image_3" / name, Frame(i, 4 * i + 10).color);
  }
  folder_.Write("s/times.txt", times);
  const ImportOutcome outcome = Import(folder_.path() / "s", "in");
  EXPECT_TRUE(outcome.is_visual);
  EXPECT_EQ(outcome.guessed, 0);
  EXPECT_EQ(outcome.with_truth, 0);
  const auto odometry = ReadTumTrajectory(folder_.path() / "in/odometry.txt");
  const sim::PlanarPose last = PlanarFromFile(odometry[2].pose);
  // A flat wall leaves some doubt whether the camera moved or turned.
  EXPECT_NEAR(last.y, -Moved(8), 0.06);
  EXPECT_NEAR(last.x, 0.0, 0.06);
  const DepthPicture depth = ReadTumDepth(folder_.path() / "in/depth/000001.png");
  EXPECT_NEAR(depth.metres[60 * kWidth + 100], 2.0, 0.15);
}

TEST_F(Recordings, GivenIntrinsicsReplaceKittisCalibration) {
  const fs::path kitti = Record<KittiWriter>("kitti", true);
  ImportRecordingSpec spec = {.source = kitti, .out = folder_.path() / "in", .intrinsics = kCamera};
  sim::WriteFileAtomically(kitti / "calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_THAT(
      [&] {
        Import(kitti, "none");
      },
      ThrowsMessage<sim::FileError>(HasSubstr("P2")));
  EXPECT_EQ(ImportRecording(spec).frames, 4);
  fs::remove(kitti / "calib.txt");
  spec.out = folder_.path() / "again";
  EXPECT_EQ(ImportRecording(spec).frames, 4);
  EXPECT_EQ(ReadTumFolder(spec.out, {}).intrinsics.fx, kCamera.fx);
}

TEST_F(Recordings, StereoOfNarrowPicturesIsRefused) {
  folder_.Write("s/times.txt", "0\n");
  for (const auto& [width, height] : {std::pair(15, 64), std::pair(16, 16), std::pair(16, 40)}) {
    folder_.Write("s/calib.txt", "P2: 9 0 4 0 0 9 4 0 0 0 1 0\nP3: 9 0 4 -20 0 9 4 0 0 0 1 0\n");
    for (const char* side : {"image_2", "image_3"}) {
      sim::WritePng(folder_.path() / "s" / side / "000000.png", sim::Image(width, height, 3));
    }
    EXPECT_THAT(
        [&] {
          Import(folder_.path() / "s", "in");
        },
        ThrowsMessage<sim::FileError>(
            AllOf(HasSubstr("image_2/000000.png"), HasSubstr("more than 16 columns"))));
  }
}

TEST_F(Recordings, BadRecordingsAreToldInALine) {
  const auto complaint = [this](const fs::path& source) -> std::string {
    try {
      fs::remove_all(folder_.path() / "in");
      Import(source, "in");
    } catch (const sim::FileError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(complaint(folder_.path()), HasSubstr("is no recording"));
  EXPECT_THAT(complaint(folder_.path() / "none"), HasSubstr("is not there"));

  fs::path bad = Record<TumWriter>("frame", true);
  fs::remove(bad / "rgb/000002.png");
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("rgb.txt:4"), HasSubstr("000002.png is not there")));
  bad = Record<TumWriter>("clock", true);
  sim::WriteFileAtomically(bad / "rgb.txt", "1 rgb/000000.png\n0.5 rgb/000001.png\n");
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("rgb.txt:2"), HasSubstr("is not after")));
  bad = Record<TumWriter>("short", true);
  sim::WriteFileAtomically(bad / "rgb.txt", "1 rgb/000000.png\n");
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("rgb.txt"), HasSubstr("more than one")));
  bad = Record<TumWriter>("late", true);
  sim::WriteFileAtomically(bad / "depth.txt", "9 depth/000000.png\n");
  EXPECT_THAT(complaint(bad), HasSubstr("not synchronised"));
  bad = Record<TumWriter>("broken", true);
  sim::WriteFileAtomically(bad / "depth/000001.png", "no PNG");
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("depth/000001.png"), HasSubstr("16-bit grey PNG")));
  bad = Record<TumWriter>("small", true);
  WriteTumDepth(bad / "depth/000001.png", {2, 2, {1.0F, 1.0F, 1.0F, 1.0F}});
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("depth/000001.png"), HasSubstr("2 x 2")));
  bad = Record<TumWriter>("lens", true);
  fs::remove(bad / "calibration.txt");
  EXPECT_THAT(complaint(bad), HasSubstr("intrinsics are unknown"));
  bad = Record<TumWriter>("point", true);
  sim::WriteFileAtomically(bad / "calibration.txt", "525 525 319.5 239.5\n");
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("principal point"), HasSubstr("--intrinsics")));
  bad = Record<TumWriter>("gap", true);
  sim::WriteFileAtomically(bad / "odometry.txt", "0 0 0 0 0 0 0 1\n0.1 0 0 0 0 0 0 1\n");
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("odometry.txt"), HasSubstr("the frame at 0.2")));

  bad = Record<KittiWriter>("kitti", true);
  fs::remove(bad / "depth/000001.png");
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("depth/000001.png"), HasSubstr("line 2")));
  fs::remove_all(bad / "depth");
  EXPECT_THAT(complaint(bad), HasSubstr("neither depth/ nor image_3/"));
}

TEST_F(Recordings, AFolderThatHoldsARecordingOfEitherKindIsLeftAlone) {
  const fs::path tum = Record<TumWriter>("tum", true);
  const fs::path kitti = Record<KittiWriter>("kitti", true);
  const auto pictures = [](const fs::path& folder) {
    return std::distance(fs::recursive_directory_iterator(folder), {});
  };
  const auto in_tum = pictures(tum);
  const auto in_kitti = pictures(kitti);
  for (const fs::path& source : {tum, kitti}) {
    for (const fs::path& out : {tum, kitti, tum / "../kitti"}) {
      EXPECT_THROW(ImportRecording({.source = source, .out = out}), sim::FileError);
    }
  }
  for (const RecordingFormat format : {RecordingFormat::kTum, RecordingFormat::kKitti}) {
    for (const fs::path& out : {tum, kitti}) {
      EXPECT_THAT(([&] {
                    ExportRecording({.source = tum, .out = out, .format = format});
                  }),
                  ThrowsMessage<sim::FileError>(HasSubstr("name another")));
    }
  }
  EXPECT_EQ(pictures(tum), in_tum);
  EXPECT_EQ(pictures(kitti), in_kitti);
}

/// Whatever way a recording comes in, its pictures are checked.
TEST_F(Recordings, RunRefusesWhatImportRefuses) {
  const auto expect_both = [this](const fs::path& bad, const std::string& complaint) {
    fs::remove_all(folder_.path() / "in");
    EXPECT_THAT(
        [&] {
          Import(bad, "in");
        },
        ThrowsMessage<sim::FileError>(HasSubstr(complaint)));
    EXPECT_THAT(
        [&] {
          Run(bad);
        },
        ThrowsMessage<sim::FileError>(HasSubstr(complaint)));
  };
  fs::path bad = Record<TumWriter>("small", true);
  WriteTumDepth(bad / "depth/000001.png", {2, 2, {1.0F, 1.0F, 1.0F, 1.0F}});
  expect_both(bad, "depth/000001.png: is of 2 x 2 pixels, but");
  bad = Record<TumWriter>("sizes", true);
  sim::WritePng(bad / "rgb/000002.png", sim::Image(kWidth, kHeight - 1, 3));
  expect_both(bad, "rgb/000002.png: is of 160 x 119 pixels, the first picture of 160 x 120");
  bad = Record<TumWriter>("point", true);
  sim::WriteFileAtomically(bad / "calibration.txt", "525 525 319.5 239.5\n");
  expect_both(bad, "principal point 319.5, 239.5 lies outside");
  bad = Record<TumWriter>("focal", true);
  sim::WriteFileAtomically(bad / "calibration.txt", "1e300 1e300 79.5 59.5\n");
  expect_both(bad, "are of no camera with pictures of 160 x 120");
  bad = Record<TumWriter>("empty", true);
  for (int i = 0; i < 4; ++i) {
    WriteTumDepth(bad / "depth" / ("00000" + std::to_string(i) + ".png"),
                  {kWidth, kHeight, std::vector<float>(kWidth * kHeight)});
  }
  expect_both(bad, "no picture has any depth");
  bad = Record<TumWriter>("pixel", true);
  sim::WriteFileAtomically(bad / "calibration.txt", "1 1 0.5 0.5\n");
  for (int i = 0; i < 4; ++i) {
    const std::string name = "00000" + std::to_string(i) + ".png";
    sim::WritePng(bad / "rgb" / name, sim::Image(1, 1, 3));
    WriteTumDepth(bad / "depth" / name, {1, 1, {1.0F}});
  }
  expect_both(bad, "rgb/000000.png: is of 1 x 1 pixels; corners need");
}

TEST_F(Recordings, RunTellsWhatMustBeImportedFirst) {
  for (const fs::path& other : {Record<KittiWriter>("kitti", true), folder_.path()}) {
    EXPECT_THAT(
        [&] {
          Run(other);
        },
        ThrowsMessage<sim::FileError>(HasSubstr("slam import")));
  }
}

TEST_F(Recordings, TruthOnAnotherClockIsAnError) {
  const fs::path bad = Record<TumWriter>("clocks", true);
  sim::WriteFileAtomically(bad / "groundtruth.txt", "100 0 0 0 0 0 0 1\n100.5 1 0 0 0 0 0 1\n");
  const auto complains = ThrowsMessage<sim::FileError>(
      AllOf(HasSubstr("groundtruth.txt"), HasSubstr("from 100 to 100.5, frames from 0 to 0.3"),
            HasSubstr("one clock")));
  EXPECT_THAT(
      [&] {
        Import(bad, "in");
      },
      complains);
  EXPECT_THAT(
      [&] {
        Run(bad);
      },
      complains);
}

TEST_F(Recordings, AFrameWithoutATruePoseIsTold) {
  const fs::path most = Record<TumWriter>("most", true);
  sim::WriteFileAtomically(most / "groundtruth.txt",
                           "0 0 0 0 -0.5 0.5 -0.5 0.5\n0.1 0 0 0 -0.5 0.5 -0.5 0.5\n");
  const fs::path run = Run(most);
  const SlamConfig config = ReadSlamRun(run);
  EXPECT_THAT(SlamTables(config, ReadSlamResults(config, run)),
              AllOf(HasSubstr("most: 2 of 4 frames have a true pose; figures need all"),
                    Not(HasSubstr("without ground truth"))));
}

TEST_F(Recordings, ARunDoesNotGoOnWithAChangedRecording) {
  const fs::path tum = Record<TumWriter>("tum", true);
  const fs::path run = Run(tum);
  Run(tum);
  const fs::path fingerprints = run / "fingerprints.yaml";
  const std::string before = sim::ReadTextFile(fingerprints);
  fs::rename(tum / "groundtruth.txt", tum / "away");
  const auto run_again = [&] {
    Run(tum);
  };
  EXPECT_THAT(run_again, ThrowsMessage<sim::FileError>(
                             AllOf(HasSubstr("tum/groundtruth.txt"), HasSubstr("another --out"))));
  fs::rename(tum / "away", tum / "groundtruth.txt");
  const std::string odometry = sim::ReadTextFile(tum / "odometry.txt");
  sim::WriteFileAtomically(tum / "odometry.txt", odometry + "9 0 0 0 0 0 0 1\n");
  EXPECT_THAT(run_again, ThrowsMessage<sim::FileError>(HasSubstr("tum/odometry.txt")));
  sim::WriteFileAtomically(tum / "odometry.txt", odometry);
  // A folder of before there were fingerprints.
  fs::remove(fingerprints);
  Run(tum);
  EXPECT_EQ(sim::ReadTextFile(fingerprints), before);
}

/// What was told of a mistake can be done: nothing is bound before a drive is done.
TEST_F(Recordings, AMistakeThatIsMendedDoesNotNeedAnotherFolder) {
  const fs::path tum = Record<TumWriter>("tum", true);
  const std::string odometry = sim::ReadTextFile(tum / "odometry.txt");
  sim::WriteFileAtomically(tum / "odometry.txt", odometry + "word\n");
  EXPECT_THROW(Run(tum), sim::FileError);
  sim::WriteFileAtomically(tum / "odometry.txt", odometry);
  const SlamConfig other = LoadSlamConfig(folder_.Write(
      "other.yaml",
      "recordings: [" + tum.string() + "]\napart_m: 2\ndetectors: [{detector: seqslam}]\n"));
  const fs::path run = folder_.path() / "run/tum";
  EXPECT_EQ(RunSlam(other, run, {}).size(), 1u);
  EXPECT_THROW(Run(tum), sim::FileError);  // now it is bound
}

TEST_F(Recordings, ResultsAndRecordingsHaveFoldersOfTheirOwn) {
  const fs::path tum = Record<TumWriter>("tum", true);
  const fs::path run = Run(tum);
  EXPECT_THAT(
      [&] {
        Import(tum, "run/tum");
      },
      ThrowsMessage<sim::FileError>(HasSubstr("holds results")));
  EXPECT_THAT(
      [&] {
        RunSlam(ReadSlamRun(run), tum, {});
      },
      ThrowsMessage<sim::FileError>(HasSubstr("holds a recording")));
}

/// Nothing is written first: a line of KITTI's poses is a frame's.
TEST_F(Recordings, KittiWantsTruthOfAllFramesOrNone) {
  const fs::path most = Record<TumWriter>("most", true);
  sim::WriteFileAtomically(most / "groundtruth.txt", "0 0 0 0 -0.5 0.5 -0.5 0.5\n");
  const fs::path out = folder_.path() / "out";
  EXPECT_THAT(
      [&] {
        ExportRecording({.source = most, .out = out, .format = RecordingFormat::kKitti}, {});
      },
      ThrowsMessage<sim::FileError>(HasSubstr("only 1 of 4 frames have one; export as tum")));
  EXPECT_FALSE(fs::exists(out / "image_2"));
}

TEST_F(Recordings, PicturesOfAnImportThatStoppedAreRemoved) {
  {
    TumWriter stopped(folder_.path() / "in", kCamera);
    for (int i = 0; i < 6; ++i) stopped.Add(Frame(i, 5 * i));
  }
  Import(Record<TumWriter>("tum", true), "in");
  EXPECT_TRUE(fs::exists(folder_.path() / "in/rgb/000003.png"));
  for (const char* file : {"rgb/000004.png", "depth/000004.png", "rgb/000005.png"}) {
    EXPECT_FALSE(fs::exists(folder_.path() / "in" / file)) << file;
  }
}

TEST_F(Recordings, WhatLosesItsWayIsNoOdometry) {
  const fs::path folder = folder_.path() / "blank";
  TumWriter writer(folder, kCamera);
  for (int i = 0; i < 4; ++i) {
    RecordedFrame frame = Frame(i, 0);
    std::fill(frame.color.pixels.begin(), frame.color.pixels.end(), std::uint8_t{128});
    writer.Add(frame);
  }
  writer.Finish();
  EXPECT_THAT(
      [&] {
        Import(folder, "in");
      },
      ThrowsMessage<sim::FileError>(AllOf(HasSubstr("3 of 3"), HasSubstr("--odometry"))));
  EXPECT_FALSE(fs::exists(folder_.path() / "in/rgb.txt"));
}

TEST_F(Recordings, ChoicesThatCannotBeMadeAreRefused) {
  const fs::path tum = Record<TumWriter>("tum", true);
  const fs::path out = folder_.path() / "out";
  EXPECT_THAT(([&] {
                ExportRecording({.source = tum, .out = out, .drive = "nosuch"});
              }),
              ThrowsMessage<sim::Error>(HasSubstr("leave --drive out")));
  EXPECT_THAT(([&] {
                ExportRecording({.source = tum, .out = out, .detector = "bow"});
              }),
              ThrowsMessage<sim::Error>(HasSubstr("--format g2o")));
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Recordings, ResultsAndGraphsGoOut) {
  const fs::path run = Run(Record<TumWriter>("tum", true));
  EXPECT_EQ(ExportRecording({.source = run, .out = folder_.path() / "out"}), 4);
  EXPECT_EQ(ReadTumTrajectory(folder_.path() / "out/seqslam.txt").size(), 4u);
  ExportSpec graph = {.source = run,
                      .out = folder_.path() / "graph.g2o",
                      .format = RecordingFormat::kG2o,
                      .detector = "seqslam"};
  EXPECT_EQ(ExportRecording(graph), 4);
  EXPECT_EQ(std::get<agent::PlanarPoseGraph>(ReadG2o(graph.out)).vertices.size(), 4u);
  graph.detector = "";
  EXPECT_EQ(ExportRecording(graph), 4);
  graph.detector = "bwo";
  EXPECT_THAT(
      [&] {
        ExportRecording(graph);
      },
      ThrowsMessage<sim::Error>(AllOf(HasSubstr("'bwo'"), HasSubstr("seqslam"))));
  graph.drive = "elsewhere";
  EXPECT_THAT(
      [&] {
        ExportRecording(graph);
      },
      ThrowsMessage<sim::Error>(HasSubstr("there are: tum")));
}

}  // namespace
}  // namespace bulletnav::bench
