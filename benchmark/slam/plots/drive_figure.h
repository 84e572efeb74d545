// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "benchmark/report/figure.h"
#include "benchmark/report/scene_map.h"
#include "benchmark/slam/runs/drive_play.h"

namespace bulletnav::bench {

/// A trajectory as somebody has it, beside the truth, and the loops that went into it.
struct DrivePanel {
  std::string title;
  std::vector<sim::PlanarPose> poses;  // from the first frame's body
  std::vector<LoopRecord> loops;
};

/// The body's poses by frame, truth first; empty truth: panels are drawn without it.
struct DrivePicture {
  std::vector<sim::BodyPose> truth;
  std::vector<DrivePanel> panels;
};

/// Panels, three in a row, titled with how far they are off in the mean: the true way in grey, the
/// estimated one, laid on the first true pose, in colour, and a line for each accepted loop between
/// where its frames are thought to be: green, or vermillion where it is wrong. The paper's
/// figure 5. On the plan of the scene if there is one. A legend and a scale bar below.
Figure DriveFigure(const DrivePicture& picture, const std::optional<SceneMap>& map);

}  // namespace bulletnav::bench
