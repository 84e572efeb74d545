// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "agent/models/safetensors.h"

namespace bulletnav::agent {

/// A tensor of weights in whole steps of 1 / `steps`, up to 2^20 of them. Throws FileError, naming
/// `file` and the tensor, if it is not there, has another shape or holds other numbers.
std::vector<std::int32_t> WeightSteps(const TensorFile& weights, const std::string& name,
                                      const std::vector<std::int64_t>& shape, int steps,
                                      const std::filesystem::path& file);

}  // namespace bulletnav::agent
