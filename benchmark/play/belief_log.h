// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "agent/belief.h"
#include "benchmark/play/episode_result.h"

namespace bulletnav::bench {

/// Where a run keeps what an agent believed during an episode: beliefs/ROW/SCENE-EPISODE.json.gz,
/// named as TrajectoryPath names the trajectory.
std::filesystem::path BeliefPath(const std::filesystem::path& run_folder, const ResultKey& key);

/// What an agent believed at each step of an episode, as changes, for a file of its own. One JSON
/// object {"cell", "size", "frames"}: metres of a cell and cells a side (0: no map), and for each
/// step an object of what has changed since the step before:
///   p     [x, y, yaw] where it believes to be
///   t     [x, y] where it is heading; null: nowhere any more
///   low   [x, y] the map's corner; with it all cells are unknown again before `m`
///   m     cells that changed, rows from the corner: [skip, 4 * length + kind, ...], kind as in
///         agent::MapPicture::Kind
///   n     all nodes: [[x, y, 1 if ghost, score if any]];  e: all edges [[i, j]];  w: the way over
///         nodes that it is on
/// Frame i is what was believed when action i had been chosen, at the pose before it. In the
/// agent's plane: metres and radians from its start, x ahead, y left, rounded to 0.001.
/// Cost of Add: a pass over the map.
class BeliefLog {
 public:
  void Add(const agent::Belief& belief);
  /// Whether nothing was ever believed.
  bool empty() const { return !says_anything_; }
  std::string ToJson() const;

 private:
  std::string MapChanges(const agent::MapPicture& map);
  std::string GraphChanges(const agent::GraphPicture& graph);

  bool says_anything_ = false;
  double cell_ = 0.0;
  std::string frames_;
  agent::MapPicture map_;
  std::string target_;
  std::string nodes_;
  std::string edges_;
  std::string way_;
};

}  // namespace bulletnav::bench
