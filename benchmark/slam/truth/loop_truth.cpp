// SPDX-License-Identifier: MIT
#include "benchmark/slam/truth/loop_truth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

constexpr double kNearMetres = 5.0;
constexpr double kLeastCovisible = 0.3;
constexpr double kFarthestCovisible = 12.0;  // two cameras that see 10 m share little beyond
constexpr int kBinShift = 3;

int BitOf(LoopKind kind) {
  return 1 << static_cast<int>(kind);
}

int BinOf(std::uint8_t flags) {
  return flags >> kBinShift;
}

std::uint8_t FlagsOf(const TruthFrame& earlier, const TruthFrame& later,
                     const LoopTruth::IsNode& is_node) {
  const sim::PlanarPose apart = sim::RelativePose(earlier.pose, later.pose);
  const double metres = std::hypot(apart.x, apart.y);
  int flags = static_cast<int>(HeadingBinOf(apart.yaw)) << kBinShift;
  if (metres <= kNearMetres) flags |= BitOf(LoopKind::kNear);
  if (is_node && is_node(earlier.pose, later.pose)) flags |= BitOf(LoopKind::kNode);
  if (metres <= kFarthestCovisible &&
      Covisibility(earlier.seen, later.seen, apart) >= kLeastCovisible) {
    flags |= BitOf(LoopKind::kCovisible);
  }
  return static_cast<std::uint8_t>(flags);
}

}  // namespace

std::string_view NameOf(LoopKind kind) {
  constexpr std::array<std::string_view, 3> kNames = {"near", "node", "covisible"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view NameOf(HeadingBin bin) {
  constexpr std::array<std::string_view, kHeadingBins> kNames = {"0-30", "30-90", "90-150",
                                                                 "150-180"};
  return kNames[static_cast<std::size_t>(bin)];
}

HeadingBin HeadingBinOf(double radians) {
  const double degrees = sim::RadToDeg(std::abs(sim::WrapAngle(radians)));
  if (degrees < 30.0) return HeadingBin::kAlong;
  if (degrees < 90.0) return HeadingBin::kAside;
  return degrees < 150.0 ? HeadingBin::kAcross : HeadingBin::kOpposite;
}

LoopTruth::LoopTruth(std::span<const TruthFrame> frames, const IsNode& is_node) {
  rows_.reserve(frames.size() + 1);
  for (const TruthFrame& later : frames) {
    rows_.push_back(flags_.size());
    for (int i = 0; i < later.comparable; ++i) {
      flags_.push_back(FlagsOf(frames[static_cast<std::size_t>(i)], later, is_node));
    }
  }
  rows_.push_back(flags_.size());
}

std::uint8_t LoopTruth::At(int later, int earlier) const {
  const auto row = static_cast<std::size_t>(later);
  BULLETNAV_CHECK(later >= 0 && row + 1 < rows_.size() && earlier >= 0);
  const std::size_t at = rows_[row] + static_cast<std::size_t>(earlier);
  BULLETNAV_CHECK(at < rows_[row + 1]);
  return flags_[at];
}

bool LoopTruth::Is(LoopKind kind, int later, int earlier) const {
  return (At(later, earlier) & BitOf(kind)) != 0;
}

HeadingBin LoopTruth::Heading(int later, int earlier) const {
  return static_cast<HeadingBin>(BinOf(At(later, earlier)));
}

bool LoopTruth::HasLoop(LoopKind kind, int later) const {
  const auto row = static_cast<std::size_t>(later);
  BULLETNAV_CHECK(later >= 0 && row + 1 < rows_.size());
  const auto at = [&](std::size_t place) {
    return flags_.begin() + static_cast<std::ptrdiff_t>(rows_[place]);
  };
  return std::any_of(at(row), at(row + 1), [kind](std::uint8_t flags) {
    return (flags & BitOf(kind)) != 0;
  });
}

std::int64_t LoopTruth::Count(LoopKind kind) const {
  return std::count_if(flags_.begin(), flags_.end(), [kind](std::uint8_t flags) {
    return (flags & BitOf(kind)) != 0;
  });
}

std::int64_t LoopTruth::Count(LoopKind kind, HeadingBin bin) const {
  return std::count_if(flags_.begin(), flags_.end(), [kind, bin](std::uint8_t flags) {
    return (flags & BitOf(kind)) != 0 && BinOf(flags) == static_cast<int>(bin);
  });
}

std::int64_t LoopTruth::pairs(HeadingBin bin) const {
  return std::count_if(flags_.begin(), flags_.end(), [bin](std::uint8_t flags) {
    return BinOf(flags) == static_cast<int>(bin);
  });
}

}  // namespace bulletnav::bench
