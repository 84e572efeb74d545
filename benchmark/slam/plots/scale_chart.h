// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/report/figure.h"
#include "benchmark/slam/scale/run_scale.h"

namespace bulletnav::bench {

/// The share of queries whose loop is found, over the number of frames that it is searched among.
Figure ScaleFigure(const ScaleResult& result);

}  // namespace bulletnav::bench
