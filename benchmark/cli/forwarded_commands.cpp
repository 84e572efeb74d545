// SPDX-License-Identifier: MIT
// The commands that the libraries beside the program have, as they look from here.
#include "benchmark/cli/forwarded_commands.h"

#include <cstdlib>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "benchmark/cli/learning.h"
#include "benchmark/cli/slam.h"

namespace bulletnav::bench {
namespace {

struct CommandText {
  std::string name;
  std::string description;
};

using RunCommand = int(int argc, char** argv);

void AddForwarded(CLI::App* program, CommandLine line, const CommandText& text, RunCommand* run) {
  CLI::App* command = program->add_subcommand(text.name, text.description);
  command->set_help_flag();  // it has one of its own over there
  command->prefix_command();
  command->callback([line, run] {
    const int status = run(line.argc, line.argv);
    if (status != 0) throw CLI::RuntimeError(status);
  });
}

}  // namespace

void AddForwardedCommands(CLI::App* program, CommandLine line) {
  AddForwarded(program, line, {"train", "Train networks by a config; goes on after a kill"},
               RunLearningCommand);
  AddForwarded(
      program, line,
      {"evaluate-perception", "How right the learned functions are in scenes they have not seen"},
      RunLearningCommand);
  AddForwarded(program, line,
               {"evaluate-policy", "How a learned policy fares, and whether it looks at its goal"},
               RunLearningCommand);
  AddForwarded(
      program, line,
      {"quantise", "Put a network in integers beside the trained one in a file of weights"},
      RunLearningCommand);
  AddForwarded(program, line,
               {"stitch", "Let a trained policy see with another encoder, to be trained on"},
               RunLearningCommand);
  AddForwarded(program, line, {"slam", "Topological SLAM: recordings, pose graphs"},
               RunSlamCommand);
}

}  // namespace bulletnav::bench
