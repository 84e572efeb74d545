// SPDX-License-Identifier: MIT
#include "benchmark/runs/call_watch.h"

#include <atomic>
#include <chrono>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

using namespace std::chrono_literals;

/// Says what it is told to, of a call that does not come back.
class Stuck final : public agent::ForeignAgent {
 public:
  double time_limit_s() const override { return 0.5; }
  std::optional<agent::ForeignCall> busy() const override {
    if (seconds < 0) return std::nullopt;
    return agent::ForeignCall{3, seconds};
  }
  void Interrupt() override { ++interrupts; }
  std::vector<std::filesystem::path> sources() const override { return {}; }

  std::atomic<double> seconds = -1.0;
  std::atomic<int> interrupts = 0;
};

/// Whether it comes to be before long.
template <class Condition>
bool Comes(const Condition& condition) {
  for (int i = 0; i < 500; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

class CallWatchTest : public testing::Test {
 protected:
  void SetUp() override {
    watch_.Add(&agent_, [this](const agent::ForeignCall& call) {
      EXPECT_EQ(call.lane, 3);
      ++given_up_;
    });
  }
  void TearDown() override { watch_.Remove(&agent_); }

  Stuck agent_;
  std::atomic<int> given_up_ = 0;
  CallWatch watch_;
};

TEST_F(CallWatchTest, LeavesQuickCallsAlone) {
  for (const double seconds : {-1.0, 0.0, 0.3, 0.49}) {
    agent_.seconds = seconds;
    std::this_thread::sleep_for(60ms);
  }
  EXPECT_EQ(agent_.interrupts, 0);
  EXPECT_EQ(given_up_, 0);
}

TEST_F(CallWatchTest, InterruptsOnceAndAgainThenGivesUpOnce) {
  agent_.seconds = 0.6;
  EXPECT_TRUE(Comes([&] {
    return agent_.interrupts == 1;
  }));
  std::this_thread::sleep_for(60ms);
  EXPECT_EQ(agent_.interrupts, 1);
  agent_.seconds = 1.5;
  EXPECT_TRUE(Comes([&] {
    return agent_.interrupts == 2;
  }));
  EXPECT_EQ(given_up_, 0);
  agent_.seconds = 2.6;
  EXPECT_TRUE(Comes([&] {
    return given_up_ == 1;
  }));
  std::this_thread::sleep_for(60ms);
  EXPECT_EQ(given_up_, 1);
}

TEST_F(CallWatchTest, BeginsAnewWithTheNextCall) {
  agent_.seconds = 1.0;
  EXPECT_TRUE(Comes([&] {
    return agent_.interrupts == 1;
  }));
  agent_.seconds = -1.0;
  std::this_thread::sleep_for(60ms);
  agent_.seconds = 0.7;
  EXPECT_TRUE(Comes([&] {
    return agent_.interrupts == 2;
  }));
}

TEST_F(CallWatchTest, ForgetsWhatIsRemoved) {
  watch_.Remove(&agent_);
  agent_.seconds = 1000.0;
  std::this_thread::sleep_for(60ms);
  EXPECT_EQ(agent_.interrupts + given_up_, 0);
}

}  // namespace
}  // namespace bulletnav::bench
