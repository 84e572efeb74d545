// SPDX-License-Identifier: MIT
#include "sim/base/isolated.h"

#include <chrono>
#include <csignal>
#include <future>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

namespace bulletnav::sim {
namespace {

using Bytes = std::vector<std::uint8_t>;
using End = IsolatedResult::End;

constexpr int kSeconds = 10;
constexpr std::uint64_t kMemory = std::uint64_t{1} << 30;

IsolatedResult RunApart(const std::function<Bytes()>& work) {
  return RunIsolated(work, kSeconds, kMemory);
}

TEST(RunIsolated, ReturnsWhatTheWorkReturns) {
  const IsolatedResult result = RunApart([] {
    return Bytes{1, 2, 3};
  });
  EXPECT_EQ(result.end, End::kDone);
  EXPECT_EQ(result.bytes, (Bytes{1, 2, 3}));
}

TEST(RunIsolated, AnExceptionAlwaysHasAText) {
  for (const std::string text : {"this is wrong", ""}) {
    const IsolatedResult result = RunApart([&]() -> Bytes {
      throw std::runtime_error(text);
    });
    EXPECT_EQ(result.end, End::kThrew);
    const std::string said(result.bytes.begin(), result.bytes.end());
    EXPECT_EQ(said, text.empty() ? "fails without saying why" : text);
  }
}

TEST(RunIsolated, ALockThatAnotherThreadHeldDoesNotStopIt) {
  std::mutex lock;
  std::promise<void> is_held;
  std::thread other([&] {
    const std::lock_guard guard(lock);
    is_held.set_value();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  });
  is_held.get_future().wait();
  const IsolatedResult result = RunApart([&] {
    const std::lock_guard guard(lock);
    return Bytes{7};
  });
  other.join();
  EXPECT_EQ(result.end, End::kDone);
  EXPECT_EQ(result.bytes, Bytes{7});
}

TEST(RunIsolated, RunningOutOfMemoryIsTold) {
  const IsolatedResult result = RunApart([]() -> Bytes {
    throw std::bad_alloc();
  });
  EXPECT_EQ(result.end, End::kTooLarge);
}

TEST(RunIsolated, TimeIsLimitedAndWorkMayAskForMore) {
  const auto limit_then = [](int more) {
    const IsolatedResult result = RunApart([&]() -> Bytes {
      AllowCpuSeconds(more);
      rlimit limit{};
      ::getrlimit(RLIMIT_CPU, &limit);
      return {static_cast<std::uint8_t>(limit.rlim_cur)};
    });
    return static_cast<int>(result.bytes.at(0));
  };
  EXPECT_EQ(limit_then(0), kSeconds);
  EXPECT_EQ(limit_then(32), kSeconds + 32);
}

/// Sanitizers end the process with 1 (address, undefined), 23 (leak), 66 (thread) or 77 (memory).
TEST(RunIsolated, WhateverElseEndsTheProcessIsACrash) {
  for (const int status : {0, 1, 2, 23, 66, 77, 255}) {
    const IsolatedResult result = RunApart([&]() -> Bytes {
      ::_exit(status);
    });
    EXPECT_EQ(result.end, End::kCrashed) << "exit status " << status;
  }
  const IsolatedResult killed = RunApart([]() -> Bytes {
    std::raise(SIGTERM);
    return {};
  });
  EXPECT_EQ(killed.end, End::kCrashed);
}

}  // namespace
}  // namespace bulletnav::sim
