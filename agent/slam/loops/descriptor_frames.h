// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "agent/slam/loops/loop_detector.h"
#include "agent/slam/loops/odometry_prior.h"
#include "agent/slam/retrieval/picture_descriptor.h"

namespace bulletnav::agent {

/// What detectors that compare sequences of a fixed length are told.
struct FixedSequences {
  int length = 5;            // frames
  double least_frame = 0.3;  // cosine of two sequences that are taken for one place

  template <class V>
  void Visit(V& v) {
    v("length", length);
    v("least_frame", least_frame);
  }
  /// Throws sim::Error.
  void Validate() const;
};

/// What detectors that go by descriptors of pictures keep of a drive.
class DescriptorFrames {
 public:
  /// Throws sim::Error, naming `detector`, if frames will have no descriptor.
  DescriptorFrames(std::string_view detector, const LoopContext& context);

  void Add(const LoopFrame& frame);

  int size() const { return static_cast<int>(descriptors_.size()); }
  const std::vector<PictureDescriptor>& descriptors() const { return descriptors_; }
  const PictureDescriptor& descriptor(int frame) const {
    return descriptors_[static_cast<std::size_t>(frame)];
  }
  /// Of the last `length` frames, or of all while they are fewer.
  std::span<const PictureDescriptor> Last(int length) const;
  const OdometryTrack& odometry() const { return odometry_; }
  int comparable(int frame) const { return comparable_[static_cast<std::size_t>(frame)]; }
  /// Of frames `first` to `last`, one after the other.
  std::vector<std::uint8_t> Cells(int first, int last) const;

 private:
  std::vector<PictureDescriptor> descriptors_;
  std::vector<int> comparable_;
  OdometryTrack odometry_;
  bool keeps_cells_;
  std::vector<std::vector<std::uint8_t>> cells_;  // by frame, if there is who describes sequences
};

/// The mean cosine of the `length` frames up to `later` with those up to `earlier`, in their order;
/// of fewer at the start of the drive. That of their descriptors one after the other, as one.
/// Expects: earlier <= later.
double OrderedCosine(const DescriptorFrames& frames, int later, int earlier, int length);

/// Takes the best of the candidates from position `first` on for loops, if they score `least`: at
/// most three, whose earlier frames are 20 apart or more.
void ProposeBest(std::size_t first, double least, std::vector<LoopCandidate>* candidates);

/// Compares frame `later` with each before its `comparable`: their cosines. `descriptors` are by
/// frame, of frames or of what ends with them.
std::vector<LoopCandidate> ScoreAll(int later, int comparable,
                                    const std::vector<PictureDescriptor>& descriptors);
/// The same, and takes the best for loops, see ProposeBest.
std::vector<LoopCandidate> CompareWithAll(int later, int comparable,
                                          const std::vector<PictureDescriptor>& descriptors,
                                          double least);

}  // namespace bulletnav::agent
