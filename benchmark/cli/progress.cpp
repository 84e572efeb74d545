// SPDX-License-Identifier: MIT
#include "benchmark/cli/progress.h"

#include <memory>
#include <utility>

#include <fmt/core.h>

namespace bulletnav::bench {
namespace {

constexpr double kQuietS = 2.0;
constexpr double kLogStepS = 10.0;
constexpr int kUncounted = -1;

/// "12.3 a second", or what one takes where that would be next to nothing.
std::string Rate(int done, double elapsed_s) {
  if (done >= elapsed_s) return fmt::format("{:.1f} a second", done / elapsed_s);
  return fmt::format("{:.0f} s each", elapsed_s / done);
}

}  // namespace

Progress::Progress(std::string what, int total)
    : what_(std::move(what)),
      total_(total),
      line_(
          [this](double elapsed_s) {
            return Line(elapsed_s) + "\n";
          },
          kQuietS, kLogStepS) {
  if (total_ == 0) line_.End(/*always=*/false);
}

Progress::Progress(std::string what) : Progress(std::move(what), kUncounted) {}

void Progress::Rename(std::string what) {
  line_.Change([&] {
    what_ = std::move(what);
  });
}

void Progress::Advance() {
  bool is_last = false;
  line_.Change([&] {
    is_last = ++done_ == total_;
  });
  if (is_last) line_.End(/*always=*/false);
}

std::string Progress::Line(double elapsed_s) const {
  if (total_ == kUncounted) return fmt::format("{}, {:.0f} s", what_, elapsed_s);
  if (done_ == 0) return fmt::format("{} 0/{}, {:.0f} s so far", what_, total_, elapsed_s);
  const double left_s = elapsed_s / done_ * (total_ - done_);
  return fmt::format("{} {}/{}, {}, {:.0f} s left", what_, done_, total_, Rate(done_, elapsed_s),
                     left_s);
}

std::function<void()> StartLine(const std::string& what, int total) {
  const auto line = std::make_shared<Progress>(what, total);
  return [line] {
    line->Advance();
  };
}

}  // namespace bulletnav::bench
