// SPDX-License-Identifier: MIT
#pragma once
#include "agent/mapping/depth_ring.h"
#include "agent/mapping/map_spec.h"
#include "agent/models/free_space_model.h"

namespace bulletnav::bench {

/// What a mapper is to learn: the cells that the agents' own mapping by depth fills, as
/// certainties. Explored are those that were looked at or into; obstacles those with as many points
/// in the body's height as a metric map asks for.
class TrueFreeSpace final : public agent::FreeSpaceModel {
 public:
  explicit TrueFreeSpace(const agent::Rig& rig) : ring_(rig, spec_) {}

  /// Looks at nothing but the depth.
  agent::FreeSpace Predict(const agent::Panorama& panorama) override;

 private:
  agent::MapSpec spec_;
  agent::DepthRing ring_;
};

}  // namespace bulletnav::bench
