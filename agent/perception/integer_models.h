// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>

#include "agent/models/free_space_model.h"
#include "agent/models/semantic_model.h"
#include "agent/observation.h"

namespace bulletnav::agent {

/// The semantic model in integers that a file holds; needs no torch. Throws FileError if there is
/// none or it cannot be used, Error if `rig` does not give what it takes.
std::shared_ptr<SemanticModel> LoadIntegerModel(const std::filesystem::path& weights,
                                                const Rig& rig);
/// Likewise, the mapper.
std::shared_ptr<FreeSpaceModel> LoadIntegerMapper(const std::filesystem::path& weights,
                                                  const Rig& rig);

}  // namespace bulletnav::agent
