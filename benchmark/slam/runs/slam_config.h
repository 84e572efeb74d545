// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "agent/slam/features/orb.h"
#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/pose_graph/optimize.h"
#include "agent/slam/retrieval/vocabulary.h"
#include "agent/slam/verify/verify_loop.h"
#include "benchmark/episodes/import_spec.h"
#include "benchmark/episodes/made_houses.h"
#include "benchmark/slam/traversal/traversal.h"

namespace bulletnav::bench {

/// Where the vocabulary of binary words comes from: drives through houses for training.
struct VocabularySource {
  HousesSpec houses;
  int actions = 300;       // a house
  int every = 5;           // frames of which one is taken
  std::uint64_t seed = 1;  // of the drives
  agent::VocabularySpec tree;

  template <class V>
  void Visit(V& v) {
    v.Required("houses", houses);
    v("actions", actions);
    v("every", every);
    v("seed", seed);
    v("tree", tree);
  }
  void Validate() const;
};

/// How sure the back end is of what it puts together; standard deviations, set by hand after drives
/// through houses for validation.
struct BackEndSpec {
  double step_m = 0.01;  // odometry, a step, along and across
  double step_deg = 0.3;
  double drift_deg = 0.1;  // odometry, a step, the same in all steps: in loops' checks alone
  double loop_m = 0.05;    // a verified loop
  double loop_deg = 1.0;
  /// Of right loops that odometry allows; others are left out first. 0: all stay.
  double odometry_confidence = 0.999;
  bool consistent = true;    // keep the largest set of loops that agree two by two
  double confidence = 0.99;  // of right ones that agree
  int runs = 2;      // loops that must support each other, or none is taken, see SeparateLoops
  int run_gap = 20;  // frames that such loops are apart at both ends, at least
  /// Or at most this share of wrong loops, times how many they are but at most 5, would agree with
  /// odometry as well as most of them do, as on a short way. 0: none is taken without support.
  double lone_chance = 0.01;
  /// Standard deviations that a loop may be off in the optimised graph, along, across or in yaw;
  /// those that are further off go, and it is optimised again. 0: all stay.
  double most_error = 3.0;
  agent::RobustKernel robust = agent::RobustKernel::kHuber;
  double width = 3.0;  // of the kernel, standard deviations

  template <class V>
  void Visit(V& v) {
    v("step_m", step_m);
    v("step_deg", step_deg);
    v("drift_deg", drift_deg);
    v("loop_m", loop_m);
    v("loop_deg", loop_deg);
    v("odometry_confidence", odometry_confidence);
    v("consistent", consistent);
    v("confidence", confidence);
    v("runs", runs);
    v("run_gap", run_gap);
    v("lone_chance", lone_chance);
    v("most_error", most_error);
    v("robust", robust);
    v("width", width);
  }
  void Validate() const;
};

/// The scene is another from some point of a drive on: it looks otherwise, or some of its rooms
/// have other furniture, or both.
struct ChangeSpec {
  double from = 0.5;                  // of the drive's actions
  std::optional<sim::Finish> finish;  // instead of the import's
  /// Whose files are called as those that are driven through, as a set with `refurnished` has them.
  std::optional<HousesSpec> houses;

  template <class V>
  void Visit(V& v) {
    v("from", from);
    v("finish", finish);
    v("houses", houses);
  }
  void Validate() const;
};

struct DetectorEntry {
  std::string detector;  // as it is registered
  std::string name;      // of its rows; the detector's if empty
  std::optional<sim::YamlNode> parameters;

  template <class V>
  void Visit(V& v) {
    v.Required("detector", detector);
    v("name", name);
    v("parameters", parameters);
  }
};

/// Figures that a paper gives of a trajectory, for a row of its own.
struct PublishedRow {
  std::string name;
  int actions = 0;  // of the table that it belongs to
  double min = 0.0;
  double mean = 0.0;
  double max = 0.0;

  template <class V>
  void Visit(V& v) {
    v.Required("name", name);
    v.Required("actions", actions);
    v.Required("min", min);
    v.Required("mean", mean);
    v.Required("max", max);
  }
};

/// An experiment: drives through scenes, or recordings, and detectors of loops on all of them.
struct SlamConfig {
  std::string name;  // of the folder of results; the config file's if empty
  std::optional<HousesSpec> houses;
  std::optional<sim::Split> split;      // of the houses; all if not given
  std::optional<int> first_houses;      // the first so many of those; all if not given
  std::vector<std::string> scenes;      // mesh files, or folders of them, in addition
  std::vector<std::string> recordings;  // TUM folders with odometry.txt, in addition
  ImportSpec import;
  sim::BodySpec body;
  sim::PinholeSpec camera = {.rows = 240, .cols = 320};
  std::optional<sim::PanoramaSpec> panorama;  // seen instead, in scenes; cylindrical
  sim::NoiseMode noise = sim::NoiseMode::kAnsReleased;
  std::optional<std::string> sensor_noise;  // of pictures of scenes, see sim::NamedSensorNoise
  std::optional<ChangeSpec> changed;        // of scenes, not of recordings
  std::vector<int> actions = {700};
  std::vector<std::uint64_t> seeds = {0};
  std::optional<VocabularySource> vocabulary;
  /// File of weights of a PictureDescriber, or, for panoramas, of a PanoramaDescriber; absent:
  /// frames have no descriptors.
  std::optional<std::string> descriptors;
  /// Of a semantic model, which tells whether two panoramas are of one node.
  std::optional<std::string> places;
  std::optional<std::string> sequences;  // likewise of SeqVLAD, trained on what that sees
  std::optional<std::string> filter;     // and of SeqNet's filter, trained on what that describes
  agent::OrbSpec orb;
  double apart_m = 10.0;  // of travel, as odometry has it, between frames that may be a loop
  agent::VerifySpec verify;
  BackEndSpec back_end;
  std::vector<DetectorEntry> detectors;
  std::string against;  // a detector's name: tables tell how the others differ from it
  std::vector<PublishedRow> published;

  template <class V>
  void Visit(V& v) {
    v("name", name);
    v("houses", houses);
    v("split", split);
    v("first_houses", first_houses);
    v("scenes", scenes);
    v("recordings", recordings);
    v("import", import);
    v("body", body);
    v("camera", camera);
    v("panorama", panorama);
    v("noise", noise);
    v("sensor_noise", sensor_noise);
    v("changed", changed);
    v("actions", actions);
    v("seeds", seeds);
    v("vocabulary", vocabulary);
    v("descriptors", descriptors);
    v("places", places);
    v("sequences", sequences);
    v("filter", filter);
    v("orb", orb);
    v("apart_m", apart_m);
    v("verify", verify);
    v("back_end", back_end);
    v.Required("detectors", detectors);
    v("against", against);
    v("published", published);
  }
  void Validate() const;
};

/// Reads a config, fills in names and every default of the detectors' parameters. Throws
/// sim::FileError at file:line:column. `overrides`: see sim::WithOverrides.
SlamConfig LoadSlamConfig(const std::filesystem::path& file,
                          std::span<const std::string> overrides = {});

/// One traversal of an experiment.
struct Drive {
  std::string name;              // of its folder
  std::filesystem::path source;  // a scene, or a recording
  bool is_recording = false;
  int actions = 0;  // 0: of a recording
  std::uint64_t seed = 0;
  std::string scene;  // that drives share; a recording's is its own
};

/// All drives of a config, whose houses are made. Throws sim::FileError for scenes or recordings
/// that are not there and folders without rgb.txt, sim::Error if there is no drive at all or two of
/// one name.
std::vector<Drive> DrivesOf(const SlamConfig& config);

}  // namespace bulletnav::bench
