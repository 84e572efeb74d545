// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "agent/mapping/map_spec.h"
#include "agent/mapping/view_window.h"
#include "agent/models/free_space_model.h"

namespace bulletnav::agent {

/// Puts a mapper's map of what surrounds the body in place of depth: for bodies that see colour
/// alone. A cell that is probably seen counts as obstacle or floor if that is probable enough;
/// between the two it changes no opinion. Nothing beyond the vision, or 3.2 m.
class LearnedRing final : public ViewWindow {
 public:
  LearnedRing(std::shared_ptr<FreeSpaceModel> model, const MapSpec& spec);

  void Project(const Panorama& panorama, double x, double y, double yaw) override;

 private:
  void Take(const FreeSpace& space, const sim::Cell& told, const sim::Cell& cell);

  std::shared_ptr<FreeSpaceModel> model_;
  double vision_;
  double cell_;
  std::uint16_t obstacle_;  // points that make an obstacle
};

}  // namespace bulletnav::agent
