// SPDX-License-Identifier: MIT
#include "benchmark/cli/progress.h"

#include <chrono>
#include <string>
#include <thread>

#include <gmock/gmock.h>

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::chrono::milliseconds kLong(3500);  // longer than what is left unsaid

template <class Work>
std::string ErrorsOf(const Work& work) {
  testing::internal::CaptureStderr();
  work();
  return testing::internal::GetCapturedStderr();
}

TEST(Progress, ShortWorkSaysNothing) {
  EXPECT_THAT(ErrorsOf([] {
                Progress progress("rooms", 2);
                progress.Advance();
                progress.Advance();
              }),
              IsEmpty());
}

TEST(Progress, TellsOfLongWorkBeforeAnyOfItIsDone) {
  EXPECT_THAT(ErrorsOf([] {
                const Progress progress("rooms", 2);
                std::this_thread::sleep_for(kLong);
              }),
              HasSubstr("rooms 0/2, "));
}

TEST(Progress, TellsHowFarAndTheEnd) {
  const std::string said = ErrorsOf([] {
    Progress progress("rooms", 2);
    progress.Advance();
    std::this_thread::sleep_for(kLong);
    progress.Advance();
  });
  EXPECT_THAT(said, HasSubstr("rooms 1/2, "));
  EXPECT_THAT(said, HasSubstr("rooms 2/2, "));
  EXPECT_THAT(said, HasSubstr(" 0 s left"));
}

TEST(Progress, WorkWithoutPartsIsNamedAsItGoesOn) {
  const std::string said = ErrorsOf([] {
    Progress progress("reading");
    progress.Rename("drawing");
    std::this_thread::sleep_for(kLong);
  });
  EXPECT_THAT(said, HasSubstr("drawing, "));
  EXPECT_THAT(said, Not(HasSubstr("reading")));
}

TEST(Progress, NothingToDoSaysNothing) {
  EXPECT_THAT(ErrorsOf([] {
                const Progress progress("rooms", 0);
                std::this_thread::sleep_for(kLong);
              }),
              IsEmpty());
}

}  // namespace
}  // namespace bulletnav::bench
