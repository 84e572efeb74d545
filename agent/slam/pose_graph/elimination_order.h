// SPDX-License-Identifier: MIT
#pragma once
#include <utility>
#include <vector>

namespace bulletnav::agent {

/// In which order to eliminate the vertices 0 to `vertices` - 1 of a graph with these edges, so
/// that a sparse Cholesky factorisation stays sparse: METIS' nested dissection, by CHOLMOD. For
/// maps that meet themselves often it leaves half of the work that minimum degree, Ceres' order,
/// does. The same on all processors. Throws sim::Error if CHOLMOD was built without METIS, or
/// memory ends. Source: Karypis and Kumar, "A fast and high quality multilevel scheme for
/// partitioning irregular graphs", 1998.
std::vector<int> EliminationOrder(int vertices, const std::vector<std::pair<int, int>>& edges);

}  // namespace bulletnav::agent
