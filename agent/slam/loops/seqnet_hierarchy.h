// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "agent/slam/loops/descriptor_frames.h"
#include "agent/slam/loops/loop_detector.h"

namespace bulletnav::agent {

struct SeqNetSpec {
  int shortlist = 50;        // sequences whose pictures are compared
  double least_frame = 0.3;  // mean cosine of pictures

  template <class V>
  void Visit(V& v) {
    v("shortlist", shortlist);
    v("least_frame", least_frame);
  }
  void Validate() const;
};

/// SeqNet's hierarchy: the sequence that ends with a frame finds those most like it by one
/// descriptor each, and of these alone pictures are compared, one by one in order. Source: Garg and
/// Milford, "SeqNet: learning descriptors for sequence-based hierarchical place recognition", RA-L
/// 2021.
class SeqNetHierarchy : public LoopDetector {
 public:
  std::vector<LoopCandidate> Add(const LoopFrame& frame) override;

 protected:
  /// `length`: frames of a sequence.
  SeqNetHierarchy(std::string_view name, const SeqNetSpec& spec, int length,
                  const LoopContext& context);
  /// Of a sequence, or of what there is of it where the drive begins.
  virtual PictureDescriptor DescribeSequence(std::span<const PictureDescriptor> frames) const = 0;

 private:
  void Shorten(std::vector<LoopCandidate>* candidates) const;

  SeqNetSpec spec_;
  int length_;
  DescriptorFrames frames_;
  std::vector<PictureDescriptor> sequences_;  // that end with each frame
};

}  // namespace bulletnav::agent
