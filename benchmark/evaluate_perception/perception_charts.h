// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/evaluate_perception/connection_figures.h"
#include "benchmark/report/figure.h"

namespace bulletnav::bench {

/// Precision against recall of "same node", and what guessing gives.
Figure PrecisionRecallFigure(const ConnectionFigures& figures);

/// Shares of right answers, of pairs of one node that are found and of pairs of two that are taken
/// for one, by distance, by walls between, and by walls within 3 m; bands are 95% confidence over
/// scenes. Bins without such pairs are left out.
Figure ConnectionBinsFigure(const ConnectionFigures& figures);

}  // namespace bulletnav::bench
