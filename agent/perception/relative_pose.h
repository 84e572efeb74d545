// SPDX-License-Identifier: MIT
#pragma once
#include "agent/models/goal_estimator.h"
#include "agent/models/semantic_model.h"

namespace bulletnav::agent {

/// Bearing of a direction's middle: radians counter-clockwise from straight ahead, in (-pi, pi].
double BearingOf(int direction);

/// The direction that a bearing falls in.
int DirectionOf(double bearing);

/// F_R of Neural Topological SLAM: distance and direction of a goal of the same node. The direction
/// is the likeliest one, moved towards its neighbours by what they are given, so that a model that
/// is torn between two is taken to mean the line between them.
RelativeGoal RelativePoseOf(const PairPrediction& prediction);

}  // namespace bulletnav::agent
