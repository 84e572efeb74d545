// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "agent/models/free_space_model.h"
#include "agent/models/model_slot.h"
#include "agent/models/semantic_model.h"

namespace bulletnav::agent {

inline constexpr const char* kSemanticModel = "semantic_model";
inline constexpr const char* kMapper = "mapper";

/// The slots of agents that recognise places by a semantic model and plan on a metric map: the map
/// is made from depth or, on a body without it, by a mapper from colour.
inline std::vector<ModelSlot> SemanticAndMapSlots(const Rig& rig) {
  std::vector<ModelSlot> slots = {NeededSlot<SemanticModel>(kSemanticModel, "nts")};
  if (!rig.has_depth) slots.push_back(NeededSlot<FreeSpaceModel>(kMapper, "mapper"));
  return slots;
}

}  // namespace bulletnav::agent
