// SPDX-License-Identifier: MIT
#pragma once
#include "agent/mapping/map_navigator.h"
#include "agent/models/semantic_model.h"
#include "agent/nts/loop_closer.h"

namespace bulletnav::agent {

/// How observations become a graph. What the paper leaves open; metres and probabilities.
/// F_L learns from as many pairs of one node as of two, of which an agent meets five times as many:
/// what it calls 0.5 is right 3 times of 4 in unseen homes, 0.8 9 times of 10 (with depth).
struct GraphSpec {
  double same_node = 0.8;        // F_L from which an observation belongs to a node
  double node_reach = 3.0;       // farther off, by F_R, an observation is a place of its own
  double switch_margin = 0.5;    // nearer by this another node takes over from the present one
  int misses = 2;                // steps in a row that no node knows the place, before it is a node
  double explorable = 0.5;       // probability from which a direction gets a ghost node
  double ghost_clearance = 1.0;  // ghosts this near to a place visited are no news
  double search_radius = 6.0;    // nodes farther off by odometry are not asked
  LoopSpec loops;

  template <class V>
  void Visit(V& v) {
    v("same_node", same_node);
    v("node_reach", node_reach);
    v("switch_margin", switch_margin);
    v("misses", misses);
    v("explorable", explorable);
    v("ghost_clearance", ghost_clearance);
    v("search_radius", search_radius);
    v("loops", loops);
  }
  void Validate() const;
};

/// How the place to go is chosen. Metres and probabilities.
struct PolicySpec {
  double goal_seen = 0.5;      // probability from which the goal belongs to a place
  double doubt_weight = 10.0;  // metres of way that a node's doubt whether it has the goal counts
  int sightings = 2;           // of the goal from the body that must agree
  double path_weight = 0.5;    // metres of score that a metre of way to a ghost counts
  double neighbour_weight = 0.5;  // of what nodes near a ghost's owner say of it; the owner's is 1
  double sight_memory = 1.0;      // metres to walk until a node that saw the body counts no more
  double change_margin = 1.0;     // better by this another ghost takes over from the chosen one
  double view_margin = 2.5;       // better by this the present view becomes a node
  double ghost_frontier = 1.5;    // ghosts with no end of known floor this near are no news; 0: all
  double opening_reach = 3.0;  // ends of known floor this near to a new node get a ghost; 0: none
  double opening_clearance = 1.0;  // unless a ghost this near stands for them
  double ghost_reached = 0.5;      // this near a ghost is visited
  double near_reached = 0.3;       // the same for a ghost less than 3 m from its node
  double node_reached = 0.5;       // the same for a regular node
  double stop_distance = 0.5;      // to the goal, by F_R; episodes ask for less than 1
  double stop_certainty = 0.95;    // probability that it is the goal, to stop there
  int patience = 30;               // steps without coming nearer until something is given up
  double least_progress = 0.25;    // what counts as coming nearer
  double miss_within = 1.5;        // this near the goal, in the open, it would be seen; 0: any
  int misses = 3;                  // steps in a row that it is not, until it is not there

  template <class V>
  void Visit(V& v) {
    v("goal_seen", goal_seen);
    v("doubt_weight", doubt_weight);
    v("sightings", sightings);
    v("path_weight", path_weight);
    v("neighbour_weight", neighbour_weight);
    v("sight_memory", sight_memory);
    v("change_margin", change_margin);
    v("view_margin", view_margin);
    v("ghost_frontier", ghost_frontier);
    v("opening_reach", opening_reach);
    v("opening_clearance", opening_clearance);
    v("ghost_reached", ghost_reached);
    v("near_reached", near_reached);
    v("node_reached", node_reached);
    v("stop_distance", stop_distance);
    v("stop_certainty", stop_certainty);
    v("patience", patience);
    v("least_progress", least_progress);
    v("miss_within", miss_within);
    v("misses", misses);
  }
  void Validate() const;
};

/// Config of Neural Topological SLAM.
struct NtsSpec {
  NavigatorSpec navigator;
  GraphSpec graph;
  PolicySpec policy;

  template <class V>
  void Visit(V& v) {
    v("navigator", navigator);
    v("graph", graph);
    v("policy", policy);
  }
};

}  // namespace bulletnav::agent
