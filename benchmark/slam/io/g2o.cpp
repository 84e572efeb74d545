// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/g2o.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "agent/slam/pose_graph/check_pose_graph.h"
#include "benchmark/slam/io/rigid_numbers.h"
#include "benchmark/slam/io/text_lines.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

using agent::PoseMatrix;
using agent::SpatialPose;
using sim::PlanarPose;

/// How a kind of pose stands in a file.
template <class Pose>
struct Format;

template <>
struct Format<PlanarPose> {
  static constexpr std::string_view kVertex = "VERTEX_SE2";
  static constexpr std::string_view kEdge = "EDGE_SE2";
  static constexpr std::string_view kVertexWords = "VERTEX_SE2 id x y yaw";
  static constexpr std::string_view kEdgeWords = "EDGE_SE2 from to x y yaw I11 I12 I13 I22 I23 I33";
  static constexpr std::size_t kNumbers = 3;

  static PlanarPose Read(const TextLine& line, std::size_t first) {
    const std::vector<double> n = line.Numbers(first, kNumbers);
    return {n[0], n[1], n[2]};
  }
  static std::string Text(const PlanarPose& pose) {
    return fmt::format("{} {} {}", pose.x, pose.y, pose.yaw);
  }
  /// Numbers of g2o's error over ours.
  static PoseMatrix<PlanarPose> Scale() { return PoseMatrix<PlanarPose>::Identity(); }
};

template <>
struct Format<SpatialPose> {
  static constexpr std::string_view kVertex = "VERTEX_SE3:QUAT";
  static constexpr std::string_view kEdge = "EDGE_SE3:QUAT";
  static constexpr std::string_view kVertexWords = "VERTEX_SE3:QUAT id x y z qx qy qz qw";
  static constexpr std::string_view kEdgeWords =
      "EDGE_SE3:QUAT from to x y z qx qy qz qw I11 I12 ... I66";
  static constexpr std::size_t kNumbers = 7;

  static SpatialPose Read(const TextLine& line, std::size_t first) {
    return QuaternionPose(line, first);
  }
  static std::string Text(const SpatialPose& pose) { return ToText(pose); }
  static PoseMatrix<SpatialPose> Scale() {
    Eigen::Matrix<double, 6, 1> scale;
    scale << 1.0, 1.0, 1.0, 0.5, 0.5, 0.5;
    return scale.asDiagonal();
  }
};

template <class Pose>
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file) {}

  agent::PoseGraph<Pose> Read() {
    ForEachLine(file_, [&](const TextLine& line) {
      Take(line);
    });
    if (graph_.vertices.empty())
      throw sim::FileError(file_, "",
                           "has no vertices; a graph needs lines VERTEX_SE2 or VERTEX_SE3:QUAT");
    FinishEdges();
    for (const auto& [id, line] : fixed_) graph_.vertices[At(id, line)].is_fixed = true;
    return std::move(graph_);
  }

 private:
  using Kind = Format<Pose>;
  static constexpr int kSize = agent::kFreedoms<Pose>;

  void Take(const TextLine& line) {
    const std::string_view tag = line.words()[0];
    if (tag == Kind::kVertex) {
      TakeVertex(line);
    } else if (tag == Kind::kEdge) {
      TakeEdge(line);
    } else if (tag == "FIX") {
      for (std::size_t i = 1; i < line.words().size(); ++i) {
        fixed_.emplace_back(line.Integer(i), line.number());
      }
    } else {
      line.Fail(
          fmt::format("'{}' is not known here; expected {}, {} or FIX, and one kind in a file", tag,
                      Kind::kVertex, Kind::kEdge));
    }
  }

  void TakeVertex(const TextLine& line) {
    line.ExpectWords(2 + Kind::kNumbers, Kind::kVertexWords);
    const std::int64_t id = line.Integer(1);
    if (!positions_.try_emplace(id, graph_.vertices.size()).second) {
      line.Fail(fmt::format("vertex {} is there twice; give each a number of its own", id));
    }
    graph_.vertices.push_back({id, Kind::Read(line, 2)});
    if (const auto trouble = agent::Trouble(graph_.vertices.back())) line.Fail(*trouble);
  }

  void TakeEdge(const TextLine& line) {
    constexpr std::size_t kTriangle = kSize * (kSize + 1) / 2;
    line.ExpectWords(3 + Kind::kNumbers + kTriangle, Kind::kEdgeWords);
    agent::PoseEdge<Pose> edge = {line.Integer(1), line.Integer(2), Kind::Read(line, 3)};
    std::size_t word = 3 + Kind::kNumbers;
    for (int row = 0; row < kSize; ++row) {
      for (int column = row; column < kSize; ++column) {
        edge.information(row, column) = line.Number(word++);
        edge.information(column, row) = edge.information(row, column);
      }
    }
    edge.information = Kind::Scale() * edge.information * Kind::Scale();
    if (const auto trouble = agent::Trouble(edge)) line.Fail(*trouble);
    graph_.edges.push_back(edge);
    edge_lines_.push_back(line.number());
  }

  std::size_t At(std::int64_t id, int line) const {
    const auto found = positions_.find(id);
    if (found != positions_.end()) return found->second;
    throw sim::FileError(file_, std::to_string(line),
                         fmt::format("there is no vertex {}; add it or leave the line out", id));
  }

  /// Vertices may stand after the edges that name them.
  void FinishEdges() {
    for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
      agent::PoseEdge<Pose>& edge = graph_.edges[i];
      const std::size_t from = At(edge.from, edge_lines_[i]);
      const std::size_t to = At(edge.to, edge_lines_[i]);
      edge.is_loop = std::max(from, to) - std::min(from, to) != 1;
    }
  }

  const std::filesystem::path& file_;
  agent::PoseGraph<Pose> graph_;
  std::unordered_map<std::int64_t, std::size_t> positions_;
  std::vector<int> edge_lines_;
  std::vector<std::pair<std::int64_t, int>> fixed_;
};

/// What the first line that is not FIX says.
bool IsInSpace(const std::filesystem::path& file) {
  std::optional<bool> in_space;
  ForEachLine(file, [&](const TextLine& line) {
    if (in_space || line.words()[0] == "FIX") return;
    in_space = line.words()[0].find("_SE3") != std::string_view::npos;
  });
  return in_space.value_or(false);
}

/// The upper triangle, row by row.
template <class Pose>
std::string TriangleText(const PoseMatrix<Pose>& matrix) {
  std::string text;
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = row; column < matrix.cols(); ++column) {
      text += fmt::format(" {}", matrix(row, column));
    }
  }
  return text;
}

template <class Pose>
std::string ToText(const agent::PoseGraph<Pose>& graph) {
  using Kind = Format<Pose>;
  std::string text;
  for (const auto& vertex : graph.vertices) {
    text += fmt::format("{} {} {}\n", Kind::kVertex, vertex.id, Kind::Text(vertex.pose));
    if (vertex.is_fixed) text += fmt::format("FIX {}\n", vertex.id);
  }
  const PoseMatrix<Pose> scale = Kind::Scale().inverse();
  for (const auto& edge : graph.edges) {
    text += fmt::format("{} {} {} {}", Kind::kEdge, edge.from, edge.to, Kind::Text(edge.measured));
    text += TriangleText<Pose>(scale * edge.information * scale) + "\n";
  }
  return text;
}

}  // namespace

AnyPoseGraph ReadG2o(const std::filesystem::path& file) {
  if (IsInSpace(file)) return Reader<SpatialPose>(file).Read();
  return Reader<PlanarPose>(file).Read();
}

std::string ToG2o(const agent::PlanarPoseGraph& graph) {
  return ToText(graph);
}

std::string ToG2o(const agent::SpatialPoseGraph& graph) {
  return ToText(graph);
}

void WriteG2o(const std::filesystem::path& file, const AnyPoseGraph& graph) {
  const std::string text = std::visit(
      [](const auto& any) {
        return ToG2o(any);
      },
      graph);
  sim::WriteFileAtomically(file, text);
}

}  // namespace bulletnav::bench
