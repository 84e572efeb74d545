// SPDX-License-Identifier: MIT
#include "sim/scene/low_poly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "sim/scene/mesh_measures.h"

namespace bulletnav::sim {
namespace {

constexpr float kSamePlace = 1e-3f;  // metres between vertices that are one
constexpr float kOfThinnest = 0.6f;  // a cell's part of a part's least extent
constexpr float kExtent = 5e-3f;     // metres; less is none

using CellKey = std::array<std::int64_t, 3>;

CellKey CellOf(const Eigen::Vector3f& p, float cell) {
  return {static_cast<std::int64_t>(std::floor(p.x() / cell)),
          static_cast<std::int64_t>(std::floor(p.y() / cell)),
          static_cast<std::int64_t>(std::floor(p.z() / cell))};
}

class Clusters {
 public:
  Clusters(float cell, SceneMesh* mesh) : cell_(cell), mesh_(mesh) {}

  void Run() {
    Weld();
    Connect();
    MeasureParts();
    Move();
    std::vector<char> kept;
    for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) kept.push_back(HasArea(t) ? 1 : 0);
    if (std::count(kept.begin(), kept.end(), 1) > 0) KeepTriangles(kept, mesh_);
  }

 private:
  struct Sum {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
  };

  /// Each vertex's place: vertices of one place differ in what they look like alone.
  void Weld() {
    std::map<CellKey, std::size_t> places;
    for (const Eigen::Vector3f& p : mesh_->positions) {
      const auto [found, is_new] = places.try_emplace(CellOf(p, kSamePlace), points_.size());
      if (is_new) points_.push_back(p);
      place_.push_back(found->second);
    }
    stays_.resize(points_.size());
  }

  std::size_t RootOf(std::size_t place) {
    while (parent_[place] != place) {
      parent_[place] = parent_[parent_[place]];
      place = parent_[place];
    }
    return place;
  }

  void Connect() {
    parent_.resize(points_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    const float floor = FloorHeight(*mesh_);
    for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) {
      const bool is_floor = IsOnTheFloor(*mesh_, t, floor);
      for (const std::uint32_t corner : mesh_->triangles[t]) {
        const std::size_t place = place_[corner];
        if (is_floor) stays_[place] = 1;
        const std::size_t a = RootOf(place);
        const std::size_t b = RootOf(place_[mesh_->triangles[t][0]]);
        parent_[std::max(a, b)] = std::min(a, b);
      }
    }
  }

  void MeasureParts() {
    for (std::size_t place = 0; place < points_.size(); ++place) {
      boxes_[RootOf(place)].extend(points_[place]);
    }
    for (const auto& [root, box] : boxes_) {
      float least = HUGE_VALF;
      for (const float extent : box.sizes()) {
        if (extent > kExtent) least = std::min(least, extent);
      }
      cells_[root] = std::min(cell_, kOfThinnest * least);
    }
  }

  void Move() {
    std::map<std::pair<std::size_t, CellKey>, Sum> clusters;
    std::vector<Sum*> cluster_of(points_.size(), nullptr);
    for (std::size_t place = 0; place < points_.size(); ++place) {
      if (stays_[place] != 0) continue;
      const std::size_t root = RootOf(place);
      Sum& cluster = clusters[{root, CellOf(points_[place], cells_[root])}];
      cluster.sum += points_[place].cast<double>();
      ++cluster.count;
      cluster_of[place] = &cluster;
    }
    for (std::size_t v = 0; v < mesh_->positions.size(); ++v) {
      const Sum* cluster = cluster_of[place_[v]];
      if (cluster == nullptr || cluster->count == 1) continue;
      mesh_->positions[v] = (cluster->sum / cluster->count).cast<float>();
    }
  }

  bool HasArea(std::size_t t) const {
    constexpr double kLeast = 1e-8;  // m2
    return AreaOf(*mesh_, t) > kLeast;
  }

  float cell_;
  SceneMesh* mesh_;
  std::vector<Eigen::Vector3f> points_;               // by place
  std::vector<std::size_t> place_;                    // by vertex
  std::vector<char> stays_;                           // by place
  std::vector<std::size_t> parent_;                   // by place
  std::map<std::size_t, Eigen::AlignedBox3f> boxes_;  // by a part's first place
  std::map<std::size_t, float> cells_;
};

}  // namespace

void ClusterVertices(double cell, SceneMesh* mesh) {
  if (cell > 0.0) Clusters(static_cast<float>(cell), mesh).Run();
}

}  // namespace bulletnav::sim
