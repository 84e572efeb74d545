// SPDX-License-Identifier: MIT
#include "agent/slam/pose_graph/elimination_order.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>

#include <suitesparse/cholmod.h>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// CHOLMOD's workspace, and what is made in it.
class Cholmod {
 public:
  Cholmod() { cholmod_start(&common_); }
  ~Cholmod() {
    cholmod_free_triplet(&triplet_, &common_);
    cholmod_free_sparse(&pattern_, &common_);
    cholmod_finish(&common_);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  Cholmod(Cholmod&&) = delete;
  Cholmod& operator=(Cholmod&&) = delete;

  /// The upper triangle of the graph's matrix, without values.
  void SetPattern(int vertices, const std::vector<std::pair<int, int>>& edges) {
    constexpr int kUpper = 1;
    const auto size = static_cast<std::size_t>(vertices);
    triplet_ =
        cholmod_allocate_triplet(size, size, edges.size(), kUpper, CHOLMOD_PATTERN, &common_);
    Check(triplet_ != nullptr);
    const std::span rows(static_cast<int*>(triplet_->i), edges.size());
    const std::span columns(static_cast<int*>(triplet_->j), edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      std::tie(rows[i], columns[i]) = std::minmax(edges[i].first, edges[i].second);
    }
    triplet_->nnz = edges.size();
    pattern_ = cholmod_triplet_to_sparse(triplet_, edges.size(), &common_);
    Check(pattern_ != nullptr);
  }

  std::vector<int> NestedDissection() {
    constexpr int kPostorder = 1;
    std::vector<int> order(pattern_->nrow);
    Check(cholmod_metis(pattern_, nullptr, 0, kPostorder, order.data(), &common_) != 0);
    return order;
  }

 private:
  void Check(bool is_done) const {
    if (is_done) return;
    throw sim::Error(common_.status == CHOLMOD_OUT_OF_MEMORY
                         ? "there is not enough memory to order a pose graph"
                         : "CHOLMOD cannot order a pose graph; it may be built without METIS");
  }

  cholmod_common common_ = {};
  cholmod_triplet* triplet_ = nullptr;
  cholmod_sparse* pattern_ = nullptr;
};

}  // namespace

std::vector<int> EliminationOrder(int vertices, const std::vector<std::pair<int, int>>& edges) {
  for (const auto& [from, to] : edges) {
    BULLETNAV_CHECK(std::min(from, to) >= 0 && std::max(from, to) < vertices);
  }
  if (vertices == 0) return {};
  Cholmod cholmod;
  cholmod.SetPattern(vertices, edges);
  return cholmod.NestedDissection();
}

}  // namespace bulletnav::agent
