// SPDX-License-Identifier: MIT
// The commands that bring recordings in and out. They are in bulletnav-slam.so; see slam.h.
#include <cmath>
#include <memory>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/cli/number_range.h"
#include "benchmark/cli/scene_options.h"
#include "benchmark/cli/slam_commands.h"
#include "benchmark/slam/recordings/export_recording.h"
#include "benchmark/slam/recordings/import_recording.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

struct ImportOptions {
  ImportRecordingSpec spec;
  std::vector<double> intrinsics;
};

/// Tells every hundred frames.
void Advance(int frames) {
  constexpr int kOften = 100;
  if (frames % kOften == 0) fmt::print(stderr, "{} frames so far\n", frames);
}

Intrinsics IntrinsicsFrom(const std::vector<double>& numbers) {
  const bool is_good = std::isfinite(numbers[0] + numbers[1] + numbers[2] + numbers[3]) &&
                       numbers[0] > 0.0 && numbers[1] > 0.0;
  if (!is_good)
    throw sim::Error("--intrinsics: fx and fy must be positive, as 525,525,319.5,239.5");
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

void Import(ImportOptions options) {
  if (!options.intrinsics.empty()) {
    options.spec.intrinsics = IntrinsicsFrom(options.intrinsics);
  }
  const ImportOutcome outcome = ImportRecording(options.spec, Advance);
  fmt::print(stderr, "{} of a {} recording, {} with a true pose, written to {}\n",
             Counted(static_cast<std::size_t>(outcome.frames), "frame"), outcome.format,
             outcome.with_truth, options.spec.out.string());
  if (outcome.is_visual) {
    fmt::print(stderr,
               "odometry was made from pictures; in {} of {} steps they did not tell the motion, "
               "and that of the step before was taken; --odometry FILE takes a better one\n",
               outcome.guessed, outcome.frames - 1);
  }
  if (outcome.left_out > 0) {
    fmt::print(stderr,
               "{} of {} pictures were left out: none of depth is within {} s; --most-apart allows "
               "more\n",
               outcome.left_out, outcome.frames + outcome.left_out, options.spec.most_apart);
  }
}

}  // namespace

void AddSlamImportCommand(CLI::App* slam) {
  auto options = std::make_shared<ImportOptions>();
  ImportRecordingSpec& spec = options->spec;
  CLI::App* command = slam->add_subcommand(
      "import", "Check a TUM folder or a KITTI sequence and make a recording for slam run of it");
  command->add_option("source", spec.source, "Folder with rgb.txt or times.txt")->required();
  command->add_option("--out", spec.out, "Folder for the recording")->required();
  command->add_option("--odometry", spec.odometry,
                      "Odometry as lines 't x y z qx qy qz qw' of the camera (default: the "
                      "source's odometry.txt, else made from the pictures)");
  command->add_option("--truth", spec.truth, "True poses, likewise");
  command->add_option("--intrinsics", options->intrinsics, "fx,fy,cx,cy in pixels")
      ->delimiter(',')
      ->expected(4);
  command
      ->add_option("--most-apart", spec.most_apart,
                   "Seconds between a colour and a depth picture of one frame")
      ->check(NumberFrom(0.0, 10.0))
      ->capture_default_str();
  command->callback([options] {
    Import(*options);
  });
}

void AddSlamExportCommand(CLI::App* slam) {
  auto spec = std::make_shared<ExportSpec>();
  CLI::App* command = slam->add_subcommand(
      "export",
      "Write a recording or a drive of results as TUM folder, KITTI sequence or g2o file");
  command->add_option("source", spec->source, "Recording, or results of slam run")->required();
  command->add_option("--out", spec->out, "Folder; of g2o: file")->required();
  AddEnumOption(command, "--format", &spec->format, "Of what is written")->default_str("tum");
  command->add_option("--drive", spec->drive, "Which of the results' drives");
  command->add_option("--detector", spec->detector,
                      "Whose pose graph, of g2o (default: odometry alone)");
  command->callback([spec] {
    const int frames = ExportRecording(*spec, Advance);
    fmt::print(stderr, "{} written to {}\n", Counted(static_cast<std::size_t>(frames), "frame"),
               spec->out.string());
  });
}

}  // namespace bulletnav::bench
