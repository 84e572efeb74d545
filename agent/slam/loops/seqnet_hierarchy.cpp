// SPDX-License-Identifier: MIT
#include "agent/slam/loops/seqnet_hierarchy.h"

#include <algorithm>
#include <cstddef>

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::agent {

void SeqNetSpec::Validate() const {
  if (shortlist < 1) throw sim::KeyError("shortlist", "shortlist must be at least 1");
}

SeqNetHierarchy::SeqNetHierarchy(std::string_view name, const SeqNetSpec& spec, int length,
                                 const LoopContext& context)
    : spec_(spec), length_(length), frames_(name, context) {}

std::vector<LoopCandidate> SeqNetHierarchy::Add(const LoopFrame& frame) {
  constexpr double kNone = 2.0;  // no sequence is a loop by itself
  frames_.Add(frame);
  sequences_.push_back(DescribeSequence(frames_.Last(length_)));
  std::vector<LoopCandidate> candidates =
      CompareWithAll(frame.number, frame.comparable, sequences_, kNone);
  Shorten(&candidates);
  for (LoopCandidate& candidate : candidates) {
    candidate.score = OrderedCosine(frames_, candidate.later, candidate.earlier, length_);
  }
  ProposeBest(0, spec_.least_frame, &candidates);
  return candidates;
}

/// To the most alike, the earlier of equals.
void SeqNetHierarchy::Shorten(std::vector<LoopCandidate>* candidates) const {
  const auto most = static_cast<std::size_t>(spec_.shortlist);
  if (candidates->size() <= most) return;
  const auto is_before = [](const LoopCandidate& a, const LoopCandidate& b) {
    return a.score != b.score ? a.score > b.score : a.earlier < b.earlier;
  };
  std::partial_sort(candidates->begin(), candidates->begin() + spec_.shortlist, candidates->end(),
                    is_before);
  candidates->resize(most);
}

}  // namespace bulletnav::agent
