// SPDX-License-Identifier: MIT
#include "agent/slam/topology/online_sequences.h"

#include <cstddef>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

void AddTo(const PictureDescriptor& frame, std::vector<std::int64_t>* sum) {
  sum->resize(frame.size(), 0);
  for (std::size_t i = 0; i < frame.size(); ++i) (*sum)[i] += frame[i];
}

}  // namespace

void OnlineClusterSpec::Validate() const {
  if (!(least_like >= -1.0 && least_like <= 1.0)) {
    throw sim::Error("least_like must lie between -1 and 1");
  }
  if (!(stay >= 0.0 && stay <= 2.0)) throw sim::Error("stay must lie between 0 and 2");
  if (shortest < 1) throw sim::Error("shortest must be at least 1");
}

int OnlineSequences::ClusterOf(const PictureDescriptor& frame) const {
  const int now = sequences_.empty() ? -1 : sequences_.back().cluster;
  int best = -1;
  double most = spec_.least_like;
  for (int i = 0; i < clusters(); ++i) {
    const double cosine =
        Cosine(frame, centres_[static_cast<std::size_t>(i)]) + (i == now ? spec_.stay : 0.0);
    if (cosine < most || (best >= 0 && cosine == most)) continue;
    most = cosine;
    best = i;
  }
  return best < 0 ? clusters() : best;
}

void OnlineSequences::Join(const PictureDescriptor& frame, int cluster) {
  const auto at = static_cast<std::size_t>(cluster);
  if (cluster == clusters()) {
    centre_sums_.emplace_back();
    centres_.emplace_back();
  }
  AddTo(frame, &centre_sums_[at]);
  centres_[at] = DirectionOf(centre_sums_[at]);
}

void OnlineSequences::MergeLast() {
  const std::size_t last = sequences_.size() - 1;
  sequences_[last - 1].last = sequences_[last].last;
  for (std::size_t i = 0; i < sums_[last].size(); ++i) sums_[last - 1][i] += sums_[last][i];
  wholes_[last - 1] = DirectionOf(sums_[last - 1]);
  sequences_.pop_back();
  sums_.pop_back();
  wholes_.pop_back();
}

void OnlineSequences::Add(const PictureDescriptor& frame) {
  const int cluster = ClusterOf(frame);
  Join(frame, cluster);
  const bool goes_on = !sequences_.empty() && sequences_.back().cluster == cluster;
  if (!goes_on && sequences_.size() > 1 && sequences_.back().size() < spec_.shortest) MergeLast();
  if (sequences_.empty() || sequences_.back().cluster != cluster) {
    sequences_.push_back({frames_, frames_, cluster});
    sums_.emplace_back();
    wholes_.emplace_back();
  }
  sequences_.back().last = frames_++;
  AddTo(frame, &sums_.back());
  wholes_.back() = DirectionOf(sums_.back());
}

}  // namespace bulletnav::agent
