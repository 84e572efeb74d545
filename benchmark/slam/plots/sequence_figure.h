// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agent/slam/loops/loop_detector.h"
#include "benchmark/report/figure.h"
#include "benchmark/report/scene_map.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {

/// The sequences of one detector over a drive.
struct SequencePanel {
  std::string title;
  agent::SequenceTrace trace;
};

/// How many clusters the sequences are of, by the largest number.
int ClustersOf(const agent::SequenceTrace& trace);

/// The paper's figure 3: the true way, each sequence in the colour of its cluster, with a dot where
/// it begins; a panel a detector. Frames are on their places by the truth. On the plan of the scene
/// if there is one. Its edges are not drawn: most sequences were compared with most others.
Figure SequenceFigure(const std::vector<sim::BodyPose>& truth,
                      const std::vector<SequencePanel>& panels, const std::optional<SceneMap>& map);

/// How far clusters spread by their number, as a share of the fewest's, and the number that the
/// elbow chose; a line a panel.
Figure ElbowFigure(const std::vector<SequencePanel>& panels);

}  // namespace bulletnav::bench
