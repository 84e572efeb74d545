// SPDX-License-Identifier: MIT
// The commands that bulletnav-learn has, as they look from here.
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/hand_over.h"

namespace bulletnav::bench {
namespace {

void AddForwarded(CLI::App* program, const std::string& name, const std::string& description) {
  CLI::App* command = program->add_subcommand(name, description);
  command->set_help_flag();  // it has one of its own over there
  command->prefix_command();
  command->callback(HandOverToLearn);
}

}  // namespace

void AddTrainCommand(CLI::App* program) {
  AddForwarded(program, "train", "Train the learned functions of Neural Topological SLAM");
}

void AddEvaluatePerceptionCommand(CLI::App* program) {
  AddForwarded(program, "evaluate-perception",
               "How right the learned functions are in scenes they have not seen");
}

}  // namespace bulletnav::bench
