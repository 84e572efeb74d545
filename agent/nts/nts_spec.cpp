// SPDX-License-Identifier: MIT
#include "agent/nts/nts_spec.h"

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

void RequireProbability(double p, const char* key) {
  if (!(p > 0.0 && p < 1.0)) throw sim::Error(std::string(key) + " must lie between 0 and 1");
}

}  // namespace

void GraphSpec::Validate() const {
  RequireProbability(same_node, "same_node");
  RequireProbability(explorable, "explorable");
  if (!(node_reach > 0.0 && switch_margin >= 0.0 && ghost_clearance >= 0.0)) {
    throw sim::Error("expected node_reach > 0, switch_margin and ghost_clearance >= 0");
  }
  if (misses < 1) throw sim::Error("misses must be at least 1");
  if (!(search_radius >= kNodeRadius)) throw sim::Error("search_radius must be at least 3");
}

void PolicySpec::Validate() const {
  RequireProbability(goal_seen, "goal_seen");
  RequireProbability(stop_certainty, "stop_certainty");
  if (sightings < 1) throw sim::Error("sightings must be at least 1");
  if (!(path_weight >= 0.0 && doubt_weight >= 0.0 && change_margin >= 0.0)) {
    throw sim::Error("path_weight, doubt_weight and change_margin must not be negative");
  }
  if (!(neighbour_weight >= 0.0 && std::isfinite(neighbour_weight) && sight_memory >= 0.0)) {
    throw sim::Error("neighbour_weight and sight_memory must not be negative");
  }
  if (!(ghost_frontier >= 0.0)) throw sim::Error("ghost_frontier must not be negative");
  if (!(opening_reach >= 0.0 && opening_clearance > 0.0 && near_reached > 0.0)) {
    throw sim::Error("expected opening_reach >= 0, opening_clearance and near_reached > 0");
  }
  if (!(ghost_reached > 0.0 && node_reached > 0.0 && stop_distance > 0.0)) {
    throw sim::Error("ghost_reached, node_reached and stop_distance must be positive");
  }
  if (!(miss_within >= 0.0) || misses < 1) {
    throw sim::Error("miss_within must not be negative and misses at least 1");
  }
  if (patience < 1 || !(least_progress > 0.0)) {
    throw sim::Error("patience must be at least 1 and least_progress positive");
  }
}

}  // namespace bulletnav::agent
