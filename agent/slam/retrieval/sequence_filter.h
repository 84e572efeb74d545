// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "agent/slam/retrieval/picture_descriptor.h"

namespace bulletnav::agent {

/// Describes a fixed number of pictures in a row as one, from a descriptor of each, in their order.
class SequenceFilter {
 public:
  SequenceFilter() = default;
  virtual ~SequenceFilter() = default;
  SequenceFilter(const SequenceFilter&) = delete;
  SequenceFilter& operator=(const SequenceFilter&) = delete;
  SequenceFilter(SequenceFilter&&) = delete;
  SequenceFilter& operator=(SequenceFilter&&) = delete;

  /// Pictures in a row.
  virtual int length() const = 0;
  /// Numbers of a picture's descriptor.
  virtual int size() const = 0;
  /// Where there are fewer pictures, as where a drive begins, the first one stands for those that
  /// are missing. Expects: 1 to length() descriptors of this size (checked). May be called from
  /// several threads.
  virtual PictureDescriptor Describe(std::span<const PictureDescriptor> pictures) const = 0;
};

}  // namespace bulletnav::agent
