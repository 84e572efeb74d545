// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "agent/slam/retrieval/binary_descriptor.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {

/// Descriptors in groups about centres.
struct MajorityClusters {
  std::vector<BinaryDescriptor> centres;
  std::vector<int> group;  // by descriptor
};

/// Each bit as most of the descriptors have it; 0 where they are even. Expects: at least one
/// (checked).
BinaryDescriptor MajorityOf(std::span<const BinaryDescriptor> descriptors);

/// At most `k` groups of descriptors near each other, none empty: centres drawn far from each
/// other, then in turn the nearest centre of each descriptor (the first of several) and the
/// majority of each group, until nothing changes or for 100 rounds. Up to k different descriptors
/// are a group each.
/// Source: Grana et al., "A fast approach for integrating ORB descriptors in the bag of words
/// model", SPIE 2013; seeds by Arthur and Vassilvitskii, "k-means++", SODA 2007.
MajorityClusters ClusterByMajority(std::span<const BinaryDescriptor> descriptors, int k,
                                   sim::Rng* rng);

}  // namespace bulletnav::agent
