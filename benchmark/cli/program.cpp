// SPDX-License-Identifier: MIT
#include "benchmark/cli/program.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "benchmark/base/program_version.h"
#include "benchmark/cli/stop_note.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr int kBadUse = 2;
constexpr int kFailed = 1;

int Complain(const std::string& what, int status) {
  std::fprintf(stderr, "bulletnav: error: %s\n", what.c_str());
  return status;
}

bool HasCommand(const CLI::App& program, const std::string& name) {
  const auto found = program.get_subcommands([&](const CLI::App* command) {
    return command->get_name() == name;
  });
  return !found.empty();
}

/// What is missing is no use to hear where something else was taken for nothing.
std::string Explain(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<std::string> unknown = program.remaining(/*recurse=*/true);
  if (unknown.empty() || error.get_name() != "RequiredError") return error.what();
  const std::string& word = unknown.front();
  return std::string("there is no ") + (word[0] == '-' ? "option" : "command") + " '" + word + "'";
}

int Run(int argc, char** argv, const std::function<void(CLI::App*)>& add_commands) {
  CLI::App program(
      "BulletNav: embodied navigation in indoor meshes, with physics, panoramas and noise",
      "bulletnav");
  program.require_subcommand(1);
  program.set_version_flag("--version", "bulletnav " + ProgramVersion());
  add_commands(&program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(e);
    // A command has told its trouble itself.
    if (e.get_name() == "RuntimeError") return e.get_exit_code();
    const std::string command = argc > 1 ? argv[1] : "";
    if (!command.empty() && command[0] != '-' && !HasCommand(program, command)) {
      return Complain("there is no command '" + command + "'; see --help", kBadUse);
    }
    return Complain(Explain(program, e) + "; see --help", kBadUse);
  }
  return 0;
}

}  // namespace

int RunProgram(int argc, char** argv, const std::function<void(CLI::App*)>& add_commands) {
  try {
    const StopWatch stops;
    std::signal(SIGXFSZ,
                SIG_IGN);  // writing beyond a limit of file sizes is then an error like others
    const int status = Run(argc, argv, add_commands);
    const bool is_told = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (status != 0 || is_told) return status;
    return Complain("standard output cannot be written; free some space and retry", kFailed);
  } catch (const sim::Error& e) {
    return Complain(e.what(), kFailed);
  } catch (const std::bad_alloc&) {
    return Complain("out of memory", kFailed);
  } catch (const std::exception& e) {
    return Complain(e.what(), kFailed);
  }
}

}  // namespace bulletnav::bench
