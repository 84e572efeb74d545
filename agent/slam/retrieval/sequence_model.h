// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "agent/slam/retrieval/picture_descriptor.h"

namespace bulletnav::agent {

/// Describes several pictures in a row as one, whatever their number, from what a network sees in
/// the cells of each.
class SequenceModel {
 public:
  using Sum = std::vector<std::int64_t>;

  SequenceModel() = default;
  virtual ~SequenceModel() = default;
  SequenceModel(const SequenceModel&) = delete;
  SequenceModel& operator=(const SequenceModel&) = delete;
  SequenceModel(SequenceModel&&) = delete;
  SequenceModel& operator=(SequenceModel&&) = delete;

  /// Adds a picture, [cells, channels] bytes, to a sum, which begins empty. May be called from
  /// several threads.
  virtual void Add(std::span<const std::uint8_t> cells, Sum* sum) const = 0;
  /// Of a sum of at least one picture.
  virtual PictureDescriptor Describe(const Sum& sum) const = 0;
};

}  // namespace bulletnav::agent
