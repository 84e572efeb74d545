// SPDX-License-Identifier: MIT
#include "agent/slam/pose_graph/check_pose_graph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <unordered_map>

#include <Eigen/Cholesky>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Of the length of a quaternion, and of what is symmetric: files have six digits.
constexpr double kRounding = 1e-5;

/// Squares of what is larger are soon infinite.
constexpr double kFarthest = 1e12;
constexpr double kSurest = 1e24;

std::optional<std::string> NumberTrouble(double largest) {
  if (!std::isfinite(largest)) return "the pose is not finite; leave it out or mend what wrote it";
  if (largest > kFarthest) {
    return "the pose has a number beyond 1e12; leave it out or mend what wrote it";
  }
  return {};
}

std::optional<std::string> PoseTrouble(const sim::PlanarPose& pose) {
  // A sum, since comparing with no number finds nothing.
  return NumberTrouble(std::abs(pose.x) + std::abs(pose.y) + std::abs(pose.yaw));
}

std::optional<std::string> PoseTrouble(const SpatialPose& pose) {
  const double sum = pose.position.cwiseAbs().sum() + pose.rotation.coeffs().cwiseAbs().sum();
  if (auto trouble = NumberTrouble(sum)) return trouble;
  if (std::abs(pose.rotation.norm() - 1.0) > kRounding) {
    return "the quaternion is not of length 1; normalise it";
  }
  return {};
}

template <class Matrix>
std::optional<std::string> InformationTrouble(const Matrix& information) {
  if (!information.allFinite()) return "the information is not finite; leave the edge out";
  const double largest = information.cwiseAbs().maxCoeff();
  if (largest > kSurest) {
    return "the information has a number beyond 1e24; give the inverse of a covariance";
  }
  const Matrix twist = information - information.transpose();
  if (twist.cwiseAbs().maxCoeff() > kRounding * largest) {
    return "the information is not symmetric; give the inverse of a covariance";
  }
  if (Eigen::LLT<Matrix>(information).info() != Eigen::Success) {
    return "the information is not positive definite; give the inverse of a covariance";
  }
  return {};
}

/// Of vertices, by joining sets.
class Pieces {
 public:
  explicit Pieces(std::size_t vertices) : parent_(vertices) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int RootOf(int vertex) {
    int& parent = parent_[static_cast<std::size_t>(vertex)];
    while (parent != parent_[static_cast<std::size_t>(parent)]) {
      parent = parent_[static_cast<std::size_t>(parent)];
    }
    return parent;
  }

  /// The first vertex stays the root.
  void Join(int a, int b) {
    const auto [low, high] = std::minmax({RootOf(a), RootOf(b)});
    parent_[static_cast<std::size_t>(high)] = low;
  }

 private:
  std::vector<int> parent_;
};

template <class Pose>
std::string NameOf(const PoseEdge<Pose>& edge, std::size_t position) {
  return "edge " + std::to_string(position + 1) + " from " + std::to_string(edge.from) + " to " +
         std::to_string(edge.to);
}

using Positions = std::unordered_map<std::int64_t, int>;

template <class Pose>
Positions PositionsOf(const PoseGraph<Pose>& graph) {
  if (graph.vertices.empty()) throw sim::Error("the pose graph has no vertices; give it some");
  Positions positions;
  for (const PoseVertex<Pose>& vertex : graph.vertices) {
    const std::string name = "vertex " + std::to_string(vertex.id);
    if (const auto trouble = Trouble(vertex)) throw sim::Error(name + ": " + *trouble);
    if (!positions.try_emplace(vertex.id, static_cast<int>(positions.size())).second) {
      throw sim::Error(name + " is there twice; give each a number of its own");
    }
  }
  return positions;
}

template <class Pose>
std::pair<int, int> EndsOf(const PoseEdge<Pose>& edge, const Positions& positions,
                           const std::string& name) {
  if (const auto trouble = Trouble(edge)) throw sim::Error(name + ": " + *trouble);
  const auto from = positions.find(edge.from);
  const auto to = positions.find(edge.to);
  if (from == positions.end() || to == positions.end()) {
    const std::int64_t unknown = from == positions.end() ? edge.from : edge.to;
    throw sim::Error(name + ": there is no vertex " + std::to_string(unknown) +
                     "; add it or leave the edge out");
  }
  return {from->second, to->second};
}

}  // namespace

template <class Pose>
std::optional<std::string> Trouble(const PoseVertex<Pose>& vertex) {
  return PoseTrouble(vertex.pose);
}

template <class Pose>
std::optional<std::string> Trouble(const PoseEdge<Pose>& edge) {
  if (edge.from == edge.to) return "it joins a vertex to itself; leave it out";
  if (auto trouble = PoseTrouble(edge.measured)) return trouble;
  return InformationTrouble(edge.information);
}

template <class Pose>
PoseGraphLinks LinksOf(const PoseGraph<Pose>& graph) {
  const Positions positions = PositionsOf(graph);
  PoseGraphLinks links;
  Pieces pieces(graph.vertices.size());
  links.ends.reserve(graph.edges.size());
  for (const PoseEdge<Pose>& edge : graph.edges) {
    links.ends.push_back(EndsOf(edge, positions, NameOf(edge, links.ends.size())));
    pieces.Join(links.ends.back().first, links.ends.back().second);
  }
  // The root of a piece is its first vertex, so it has its number by then.
  for (int vertex = 0; vertex < static_cast<int>(graph.vertices.size()); ++vertex) {
    const int root = pieces.RootOf(vertex);
    links.piece.push_back(root == vertex ? links.pieces++
                                         : links.piece[static_cast<std::size_t>(root)]);
  }
  return links;
}

template <class Pose>
void CheckOnePiece(const PoseGraph<Pose>& graph, const PoseGraphLinks& links) {
  if (links.pieces <= 1) return;
  const auto first = std::find(links.piece.begin(), links.piece.end(), 1) - links.piece.begin();
  const auto others = std::count(links.piece.begin(), links.piece.end(), 1);
  throw sim::Error(
      "the pose graph is in " + std::to_string(links.pieces) +
      " pieces: no edges lead from vertex " + std::to_string(graph.vertices.front().id) +
      " to vertex " + std::to_string(graph.vertices[static_cast<std::size_t>(first)].id) +
      " and its piece of " + std::to_string(others) + "; add an edge, or say --pieces");
}

#define BULLETNAV_FOR_POSE(Pose)                                        \
  template std::optional<std::string> Trouble(const PoseVertex<Pose>&); \
  template std::optional<std::string> Trouble(const PoseEdge<Pose>&);   \
  template PoseGraphLinks LinksOf(const PoseGraph<Pose>&);              \
  template void CheckOnePiece(const PoseGraph<Pose>&, const PoseGraphLinks&)
BULLETNAV_FOR_POSE(sim::PlanarPose);
BULLETNAV_FOR_POSE(SpatialPose);
#undef BULLETNAV_FOR_POSE

}  // namespace bulletnav::agent
