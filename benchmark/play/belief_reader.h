// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>

#include "agent/belief.h"
#include "benchmark/base/json_cursor.h"

namespace bulletnav::bench {

/// Reads what a BeliefLog told, from first to last.
class BeliefReader {
 public:
  /// Throws sim::FileError, naming file and place in it.
  explicit BeliefReader(const std::filesystem::path& file);

  /// Actions that there is a belief of.
  std::size_t size() const { return frames_; }
  /// What was believed when action `i` had been chosen. Expects: i < size(), and not less than
  /// before (checked). Throws sim::FileError.
  const agent::Belief& At(std::size_t i);

 private:
  void Apply(const JsonCursor& frame);
  void ApplyMap(const JsonCursor& frame);
  void ApplyGraph(const JsonCursor& frame);

  std::filesystem::path file_;
  Json json_;
  std::size_t frames_ = 0;
  std::size_t applied_ = 0;
  agent::Belief belief_;
};

}  // namespace bulletnav::bench
