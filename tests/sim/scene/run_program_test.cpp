// SPDX-License-Identifier: MIT
#include "sim/scene/run_program.h"

#include <csignal>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

std::string OutputOf(const std::string& shell_command) {
  const EndedProgram program("/bin/sh", {"-c", shell_command});
  return {program.output().begin(), program.output().end()};
}

std::optional<int> SignalOf(const std::string& shell_command) {
  return EndedProgram("/bin/sh", {"-c", shell_command}).signal();
}

TEST(EndedProgram, GivesBackWhatItWrote) {
  EXPECT_EQ(OutputOf("echo one; echo two >&2"), "one\n");
  EXPECT_EQ(OutputOf("cat"), "");  // its input is empty
  EXPECT_EQ(OutputOf("head -c 300000 /dev/zero").size(), 300000u);
}

TEST(EndedProgram, ArgumentsArriveAsTheyAre) {
  const EndedProgram program("/bin/sh", {"-c", "printf '%s|' \"$@\"", "sh", "a b", "", "'\"$"});
  EXPECT_EQ(std::string(program.output().begin(), program.output().end()), "a b||'\"$|");
}

TEST(EndedProgram, SignalsThatEndItAreTold) {
  EXPECT_EQ(SignalOf("exit 3"), std::nullopt);
  EXPECT_EQ(SignalOf("kill -SEGV $$"), SIGSEGV);
}

TEST(EndedProgram, WhatTheHostIgnoresEndsItAllTheSame) {
  const auto before = std::signal(SIGTERM, SIG_IGN);
  EXPECT_EQ(SignalOf("kill -TERM $$"), SIGTERM);
  std::signal(SIGTERM, before);
}

/// Some hosts never wait for their children.
TEST(EndedProgram, ItsEndIsSeenWhereChildrenAreNotWaitedFor) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_EQ(OutputOf("sleep 0.1; echo done"), "done\n");
  std::signal(SIGCHLD, before);
}

TEST(EndedProgram, AMissingOneIsNamed) {
  try {
    EndedProgram("/nowhere/at/all", {});
    FAIL() << "it ran";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("/nowhere/at/all cannot be run: No such file"));
  }
}

}  // namespace
}  // namespace bulletnav::sim
