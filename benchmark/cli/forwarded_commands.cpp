// SPDX-License-Identifier: MIT
// Loading torch takes half a second and 150 MB, which most commands have no use for. Those that
// need it are in the program bulletnav-learn beside this one, and are handed over to it.
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <unistd.h>

#include "benchmark/cli/commands.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

[[noreturn]] void HandOver(const std::string& command, std::vector<std::string> arguments) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  std::string program = self.parent_path() / "bulletnav-learn";
  arguments.insert(arguments.begin(), {program, command});
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  throw sim::FileError(program, "",
                       std::string("cannot be started: ").append(std::strerror(errno)));
}

void AddForwarded(CLI::App* program, const std::string& name, const std::string& description) {
  CLI::App* command = program->add_subcommand(name, description);
  command->set_help_flag();  // it has one of its own over there
  command->prefix_command();
  command->callback([command, name] {
    HandOver(name, command->remaining());
  });
}

}  // namespace

void AddTrainCommand(CLI::App* program) {
  AddForwarded(program, "train", "Train the learned functions of Neural Topological SLAM");
}

}  // namespace bulletnav::bench
