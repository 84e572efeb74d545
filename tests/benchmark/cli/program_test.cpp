// SPDX-License-Identifier: MIT
#include "benchmark/cli/program.h"

#include <array>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

/// Status of a program whose one command prints a line into this file.
int StatusOfPrintingTo(const char* file) {
  if (std::freopen(file, "w", stdout) == nullptr) return -1;
  std::array<char, 10> program = {"bulletnav"};
  std::array<char, 4> say = {"say"};
  std::array<char*, 3> arguments = {program.data(), say.data(), nullptr};
  return RunProgram(2, arguments.data(), [](CLI::App* app) {
    app->add_subcommand("say", "Says it")->callback([] {
      std::puts("it");
    });
  });
}

TEST(Program, FailsWhereItsOutputIsLost) {
  EXPECT_EXIT(std::exit(StatusOfPrintingTo("/dev/null")), testing::ExitedWithCode(0), "^$");
  EXPECT_EXIT(std::exit(StatusOfPrintingTo("/dev/full")), testing::ExitedWithCode(1),
              "^bulletnav: error: standard output cannot be written; .*\n$");
}

}  // namespace
}  // namespace bulletnav::bench
