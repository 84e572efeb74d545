// SPDX-License-Identifier: MIT
#include "agent/slam/loops/descriptor_frames.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr std::size_t kProposals = 3;
constexpr int kProposalGap = 20;  // frames

}  // namespace

void FixedSequences::Validate() const {
  if (length < 1) throw sim::Error("length must be at least 1");
}

DescriptorFrames::DescriptorFrames(std::string_view detector, const LoopContext& context)
    : keeps_cells_(context.sequences != nullptr) {
  if (context.descriptor_size > 0) return;
  throw sim::Error("the detector '" + std::string(detector) +
                   "' needs descriptors of pictures; add 'descriptors', a file of weights, to the "
                   "config");
}

void DescriptorFrames::Add(const LoopFrame& frame) {
  descriptors_.emplace_back(frame.descriptor.begin(), frame.descriptor.end());
  comparable_.push_back(frame.comparable);
  odometry_.Add(frame.odometry);
  if (keeps_cells_) cells_.emplace_back(frame.cells.begin(), frame.cells.end());
}

std::vector<std::uint8_t> DescriptorFrames::Cells(int first, int last) const {
  std::vector<std::uint8_t> cells;
  for (int frame = first; frame <= last; ++frame) {
    const auto& one = cells_[static_cast<std::size_t>(frame)];
    cells.insert(cells.end(), one.begin(), one.end());
  }
  return cells;
}

std::span<const PictureDescriptor> DescriptorFrames::Last(int length) const {
  const std::span<const PictureDescriptor> all(descriptors_);
  return all.last(std::min(all.size(), static_cast<std::size_t>(length)));
}

double OrderedCosine(const DescriptorFrames& frames, int later, int earlier, int length) {
  const int count = std::min(length, earlier + 1);
  double sum = 0.0;
  for (int back = 0; back < count; ++back) {
    sum += Cosine(frames.descriptor(later - back), frames.descriptor(earlier - back));
  }
  return sum / count;
}

void ProposeBest(std::size_t first, double least, std::vector<LoopCandidate>* candidates) {
  std::vector<LoopCandidate*> proposed;
  const auto is_free = [&proposed](const LoopCandidate& candidate) {
    return std::none_of(proposed.begin(), proposed.end(), [&](const LoopCandidate* other) {
      return std::abs(other->earlier - candidate.earlier) < kProposalGap;
    });
  };
  while (proposed.size() < kProposals) {
    LoopCandidate* best = nullptr;
    for (std::size_t i = first; i < candidates->size(); ++i) {
      LoopCandidate& candidate = (*candidates)[i];
      if (candidate.score < least || !is_free(candidate)) continue;
      if (best == nullptr || candidate.score > best->score) best = &candidate;
    }
    if (best == nullptr) return;
    best->is_proposed = true;
    proposed.push_back(best);
  }
}

std::vector<LoopCandidate> ScoreAll(int later, int comparable,
                                    const std::vector<PictureDescriptor>& descriptors) {
  std::vector<LoopCandidate> candidates;
  candidates.reserve(static_cast<std::size_t>(comparable));
  for (int earlier = 0; earlier < comparable; ++earlier) {
    const double cosine = Cosine(descriptors[static_cast<std::size_t>(later)],
                                 descriptors[static_cast<std::size_t>(earlier)]);
    candidates.push_back({later, earlier, cosine, false});
  }
  return candidates;
}

std::vector<LoopCandidate> CompareWithAll(int later, int comparable,
                                          const std::vector<PictureDescriptor>& descriptors,
                                          double least) {
  std::vector<LoopCandidate> candidates = ScoreAll(later, comparable, descriptors);
  ProposeBest(0, least, &candidates);
  return candidates;
}

}  // namespace bulletnav::agent
