// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "agent/slam/retrieval/picture_descriptor.h"

namespace bulletnav::agent {

/// A descriptor that is like another one.
struct LikeDescriptor {
  int number = 0;  // in the order in which they were added
  double cosine = 0.0;
};

/// Descriptors of one size, one after the other in memory, and the most alike of them by comparing
/// with all: exact, in whole numbers, the same on every processor. Cost of a search: some 0.02 us a
/// descriptor of 256 numbers, of which memory holds two bytes each.
class DescriptorIndex {
 public:
  /// Expects: 1 to 1024 numbers (checked).
  explicit DescriptorIndex(int size);

  /// Expects: so many numbers (checked).
  void Add(std::span<const std::int16_t> descriptor);
  int count() const { return static_cast<int>(numbers_.size() / size_); }
  std::size_t bytes() const { return numbers_.size() * sizeof(std::int16_t); }

  /// The `most` most alike of the first `among`, the most alike first, of equal ones the earlier.
  /// Expects: a query of the same size, among <= count() (checked).
  std::vector<LikeDescriptor> MostLike(std::span<const std::int16_t> query, int most,
                                       int among) const;

 private:
  std::size_t size_;
  std::vector<std::int16_t> numbers_;
};

}  // namespace bulletnav::agent
