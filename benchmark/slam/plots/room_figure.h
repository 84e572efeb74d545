// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/report/figure.h"
#include "benchmark/slam/plots/sequence_figure.h"
#include "sim/house/floor_plan.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {

/// How many of a drive's frames of each cluster were taken in each room.
struct RoomCounts {
  std::vector<std::string> rooms;        // those that the drive was in, in the plan's order
  std::vector<std::vector<int>> frames;  // [cluster][room]
  int between = 0;                       // frames in no room, as in a doorway
  /// Of the frames in rooms, the share in the room where most of their cluster are; 0 of none.
  double purity = 0.0;
};

/// Frames are where they are by the truth. Frames beyond the truth's end are left out.
RoomCounts CountRooms(const agent::SequenceTrace& trace, const std::vector<sim::BodyPose>& truth,
                      const sim::FloorPlan& plan);

/// A row a cluster, a column a room: the darker, the larger the share of the cluster's frames that
/// were taken there; clusters in the order of the room where most of them are. A panel a detector.
Figure RoomFigure(const std::vector<sim::BodyPose>& truth, const std::vector<SequencePanel>& panels,
                  const sim::FloorPlan& plan);

}  // namespace bulletnav::bench
