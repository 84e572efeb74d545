// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/majority_clusters.h"

#include <algorithm>
#include <cstddef>

#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr int kRounds = 100;

using Descriptors = std::span<const BinaryDescriptor>;

/// Fewer than k where all descriptors are one of those drawn.
std::vector<BinaryDescriptor> Seeds(Descriptors descriptors, int k, sim::Rng* rng) {
  std::vector<BinaryDescriptor> seeds = {rng->Pick(descriptors)};
  std::vector<double> squares(descriptors.size(), 1e9);
  while (static_cast<int>(seeds.size()) < k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < descriptors.size(); ++i) {
      const double distance = Distance(descriptors[i], seeds.back());
      squares[i] = std::min(squares[i], distance * distance);
      sum += squares[i];
    }
    if (sum == 0.0) break;
    seeds.push_back(descriptors[rng->Weighted(squares)]);
  }
  return seeds;
}

/// Groups as they are, without those that are empty.
MajorityClusters Dense(const MajorityClusters& clusters) {
  std::vector<int> number(clusters.centres.size(), -1);
  for (const int group : clusters.group) number[static_cast<std::size_t>(group)] = 0;
  MajorityClusters dense;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(dense.centres.size());
    dense.centres.push_back(clusters.centres[i]);
  }
  dense.group.reserve(clusters.group.size());
  for (const int group : clusters.group) {
    dense.group.push_back(number[static_cast<std::size_t>(group)]);
  }
  return dense;
}

/// The centre of an empty group stays where it is.
std::vector<BinaryDescriptor> Centres(Descriptors descriptors, const MajorityClusters& clusters) {
  std::vector<std::vector<BinaryDescriptor>> members(clusters.centres.size());
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    members[static_cast<std::size_t>(clusters.group[i])].push_back(descriptors[i]);
  }
  std::vector<BinaryDescriptor> centres = clusters.centres;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!members[i].empty()) centres[i] = MajorityOf(members[i]);
  }
  return centres;
}

}  // namespace

BinaryDescriptor MajorityOf(Descriptors descriptors) {
  BULLETNAV_CHECK(!descriptors.empty());
  std::array<std::size_t, kDescriptorBits> ones{};
  for (const BinaryDescriptor& descriptor : descriptors) {
    for (std::size_t bit = 0; bit < ones.size(); ++bit) {
      ones[bit] += descriptor[bit / 64] >> (bit % 64) & 1u;
    }
  }
  BinaryDescriptor majority{};
  for (std::size_t bit = 0; bit < ones.size(); ++bit) {
    if (2 * ones[bit] > descriptors.size()) majority[bit / 64] |= std::uint64_t{1} << (bit % 64);
  }
  return majority;
}

MajorityClusters ClusterByMajority(Descriptors descriptors, int k, sim::Rng* rng) {
  BULLETNAV_CHECK(k > 0);
  if (descriptors.empty()) return {};
  MajorityClusters clusters = {Seeds(descriptors, k, rng), {}};
  for (int round = 0; round < kRounds; ++round) {
    std::vector<int> group;
    group.reserve(descriptors.size());
    for (const BinaryDescriptor& descriptor : descriptors) {
      group.push_back(static_cast<int>(NearestTo(descriptor, clusters.centres)));
    }
    const bool is_same = group == clusters.group;
    clusters.group = std::move(group);
    if (is_same) break;
    clusters.centres = Centres(descriptors, clusters);
  }
  return Dense(clusters);
}

}  // namespace bulletnav::agent
