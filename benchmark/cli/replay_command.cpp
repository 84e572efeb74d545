// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/stop_note.h"
#include "benchmark/replay/make_replay.h"

namespace bulletnav::bench {
namespace {

void Replay(const ReplayOptions& options) {
  const StopNote when_stopped([] {
    return std::string("no page is written, nor an older one changed");
  });
  std::optional<Progress> progress;
  const ReplayCount count = MakeReplay(options, [&](std::size_t /*done*/, std::size_t all) {
    if (!progress) progress.emplace("replay", static_cast<int>(all));
    progress->Advance();
  });
  for (const std::string& note : count.notes) fmt::print(stderr, "note: {}\n", note);
  fmt::print("{}: {}, {} to play back, {} with beliefs; {:.1f} MB, of it {:.1f} MB pictures\n",
             count.file.string(), Counted(count.results, "result"), count.paths, count.beliefs,
             static_cast<double>(count.bytes) / 1e6,
             static_cast<double>(count.picture_bytes) / 1e6);
}

}  // namespace

void AddReplayCommand(CLI::App* program) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = program->add_subcommand(
      "replay", "Make one HTML file of a run, to play its episodes back in a browser");
  command->add_option("run", options->run, "Folder of results")->required();
  command->add_option("--out", options->out, "The file (default: RUN/replay.html)");
  command->add_option("--episodes", options->episodes, "Only these (default: all)");
  command
      ->add_option("--panoramas", options->panoramas,
                   "So many small panoramas of an episode (default: 12); 0: no pictures")
      ->check(CLI::Range(0, 100));
  command
      ->add_option("--pictured", options->pictured,
                   "At most so many results have panoramas, the worst first (default: 400)")
      ->check(CLI::Range(1, 1'000'000));
  command->callback([options] {
    Replay(*options);
  });
}

}  // namespace bulletnav::bench
