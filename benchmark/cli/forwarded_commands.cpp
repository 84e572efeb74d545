// SPDX-License-Identifier: MIT
// The commands that the library for learning has, as they look from here.
#include "benchmark/cli/forwarded_commands.h"

#include <cstdlib>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "benchmark/cli/learning.h"

namespace bulletnav::bench {
namespace {

void AddForwarded(CLI::App* program, CommandLine line, const std::string& name,
                  const std::string& description) {
  CLI::App* command = program->add_subcommand(name, description);
  command->set_help_flag();  // it has one of its own over there
  command->prefix_command();
  command->callback([line] {
    const int status = RunLearningCommand(line.argc, line.argv);
    if (status != 0) throw CLI::RuntimeError(status);
  });
}

}  // namespace

void AddForwardedCommands(CLI::App* program, CommandLine line) {
  AddForwarded(program, line, "train", "Train networks by a config; goes on after a kill");
  AddForwarded(program, line, "evaluate-perception",
               "How right the learned functions are in scenes they have not seen");
  AddForwarded(program, line, "quantise",
               "Put a network in integers beside the trained one in a file of weights");
}

}  // namespace bulletnav::bench
