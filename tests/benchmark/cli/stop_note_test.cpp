// SPDX-License-Identifier: MIT
#include "benchmark/cli/stop_note.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

void WaitForTheEnd() {
  std::this_thread::sleep_for(std::chrono::seconds(20));
  std::exit(0);
}

std::string Text(const char* text) {
  return text;
}

TEST(StopNote, EndsTheProgramWithWhatTheNewestSays) {
  const auto stop = [](int signal) {
    const StopWatch watch;
    const StopWatch within;  // does nothing
    const StopNote outer([] {
      return Text("3 houses stay");
    });
    {
      const StopNote inner([] {
        return Text("4 houses stay");
      });
    }
    std::raise(signal);
    WaitForTheEnd();
  };
  EXPECT_EXIT(stop(SIGINT), testing::ExitedWithCode(130), "^bulletnav: stopped: 3 houses stay\n$");
  EXPECT_EXIT(stop(SIGTERM), testing::ExitedWithCode(143), "^bulletnav: stopped: 3 houses stay\n$");
}

TEST(StopNote, LeavesNoHalfWrittenFile) {
  const tests::TemporaryFolder folder;
  const auto stop = [&] {
    const StopWatch watch;
    sim::WriteFileAtomically(folder.path() / "page.html", [&](const std::filesystem::path& file) {
      folder.Write(file.filename().string(), "half");
      std::raise(SIGTERM);
      WaitForTheEnd();
    });
  };
  EXPECT_EXIT(stop(), testing::ExitedWithCode(143), "^bulletnav: stopped\n$");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(StopNote, HeedsNoSignalThatWasIgnored) {
  const auto go_on = [] {
    std::signal(SIGINT, SIG_IGN);
    const StopWatch watch;
    std::raise(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::_Exit(7);
  };
  EXPECT_EXIT(go_on(), testing::ExitedWithCode(7), "^$");
}

TEST(StopNote, SignalsAreAsBeforeWhenNobodyWatches) {
  { const StopWatch watch; }
  struct sigaction now = {};
  ASSERT_EQ(::sigaction(SIGTERM, nullptr, &now), 0);
  EXPECT_EQ(now.sa_handler, SIG_DFL);
}

}  // namespace
}  // namespace bulletnav::bench
