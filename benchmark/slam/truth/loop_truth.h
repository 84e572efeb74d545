// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "benchmark/slam/truth/covisibility.h"

namespace bulletnav::bench {

/// What two frames must have in common to be a loop.
enum class LoopKind {
  kNear,      // the paper's: within 5 m, walls or not
  kNode,      // one can be walked to and seen from the other, see IsInNode
  kCovisible  // 30% of each other's points are seen, see Covisibility
};
inline constexpr std::array kLoopKinds = {LoopKind::kNear, LoopKind::kNode, LoopKind::kCovisible};
std::string_view NameOf(LoopKind kind);

/// Loops by how far the later camera is turned from the earlier one.
enum class HeadingBin { kAlong, kAside, kAcross, kOpposite };
inline constexpr int kHeadingBins = 4;
/// "0-30", "30-90", "90-150", "150-180" degrees.
std::string_view NameOf(HeadingBin bin);
HeadingBin HeadingBinOf(double radians);

/// Where a frame truly was, and what it saw.
struct TruthFrame {
  sim::BodyPose pose;
  DepthThumbnail seen;
  int comparable = 0;  // how many of the first frames it is compared with
};

/// Which pairs of a drive's frames are loops, of all pairs that are compared: known once, asked
/// often. Source of kNear: Sharma et al., "Hierarchical Unsupervised Topological SLAM", 2023,
/// section IV.
class LoopTruth {
 public:
  using IsNode = std::function<bool(const sim::BodyPose& earlier, const sim::BodyPose& later)>;

  /// `is_node` says whether two body poses are of one node; without it no pair is.
  /// Cost: covisibility of all pairs within 12 m.
  LoopTruth(std::span<const TruthFrame> frames, const IsNode& is_node);

  /// Expects: earlier < comparable of later (checked).
  bool Is(LoopKind kind, int later, int earlier) const;
  HeadingBin Heading(int later, int earlier) const;
  /// Whether a frame is a loop with any before it.
  bool HasLoop(LoopKind kind, int later) const;
  int frames() const { return static_cast<int>(rows_.size()) - 1; }
  /// How many of the first frames a later one is compared with.
  int compared(int later) const {
    const auto row = static_cast<std::size_t>(later);
    return static_cast<int>(rows_[row + 1] - rows_[row]);
  }
  /// Pairs that are, of a kind.
  std::int64_t Count(LoopKind kind) const;
  std::int64_t Count(LoopKind kind, HeadingBin bin) const;
  /// All pairs that are compared; of a bin.
  std::int64_t pairs() const { return static_cast<std::int64_t>(flags_.size()); }
  std::int64_t pairs(HeadingBin bin) const;

 private:
  std::uint8_t At(int later, int earlier) const;

  std::vector<std::size_t> rows_;    // where a later frame's pairs begin in flags_
  std::vector<std::uint8_t> flags_;  // a bit a kind, the bin above them
};

}  // namespace bulletnav::bench
