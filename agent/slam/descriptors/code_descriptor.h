// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "agent/slam/retrieval/picture_descriptor.h"

namespace bulletnav::agent {

/// Describes a panorama by the codes of its patches, which the encoder of Neural Topological SLAM
/// has made anyway: GeM with exponent 3 over the patches, length 1. `codes` [patches, size] as
/// IntegerEncoder gives them. The order of patches, which way the body looks, does not count.
/// Expects: numbers of 0 to 4095, whole patches, at most 1024 of them (checked).
PictureDescriptor DescribeCodes(std::span<const std::int16_t> codes, int size);

}  // namespace bulletnav::agent
