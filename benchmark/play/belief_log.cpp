// SPDX-License-Identifier: MIT
#include "benchmark/play/belief_log.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "benchmark/play/trajectory.h"

namespace bulletnav::bench {
namespace {

using agent::GraphPicture;
using agent::MapPicture;

/// To a thousandth; never -0.
double Short(double value) {
  return std::round(value * 1e3) / 1e3 + 0.0;
}

/// `"name":value` if the value is another than before.
void AddIfOther(const char* name, std::string value, std::string* before, std::string* frame) {
  if (value == *before) return;
  *frame += fmt::format(",\"{}\":{}", name, value);
  *before = std::move(value);
}

std::string NodesOf(const GraphPicture& graph) {
  std::string text;
  for (const GraphPicture::Node& node : graph.nodes) {
    text += fmt::format("{}[{},{},{}", text.empty() ? "" : ",", Short(node.x), Short(node.y),
                        node.is_ghost ? 1 : 0);
    text += node.score ? fmt::format(",{}]", Short(*node.score)) : "]";
  }
  return "[" + text + "]";
}

std::string EdgesOf(const GraphPicture& graph) {
  std::string text;
  for (const auto& [from, to] : graph.edges) {
    text += fmt::format("{}[{},{}]", text.empty() ? "" : ",", from, to);
  }
  return "[" + text + "]";
}

bool IsSamePlace(const MapPicture& a, const MapPicture& b) {
  return a.size == b.size && a.low_x == b.low_x && a.low_y == b.low_y;
}

/// Runs of cells that changed to one kind.
std::string ChangedCells(const std::vector<MapPicture::Kind>& before,
                         const std::vector<MapPicture::Kind>& now) {
  std::string text;
  std::size_t told = 0;
  for (std::size_t i = 0; i < now.size();) {
    if (now[i] == before[i]) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < now.size() && now[end] == now[i] && now[end] != before[end]) ++end;
    text += fmt::format("{}{},{}", text.empty() ? "" : ",", i - told,
                        4 * (end - i) + static_cast<std::size_t>(now[i]));
    told = i = end;
  }
  return text;
}

}  // namespace

std::filesystem::path BeliefPath(const std::filesystem::path& run_folder, const ResultKey& key) {
  const auto below = std::filesystem::relative(TrajectoryPath("x", key), "x/trajectories");
  return run_folder / "beliefs" / (below.string() + ".gz");
}

void BeliefLog::Add(const agent::Belief& belief) {
  std::string frame;
  if (belief.pose) {
    frame += fmt::format(",\"p\":[{},{},{}]", Short(belief.pose->x), Short(belief.pose->y),
                         Short(belief.pose->yaw));
  }
  AddIfOther("t",
             belief.target
                 ? fmt::format("[{},{}]", Short(belief.target->x), Short(belief.target->y))
                 : "null",
             &target_, &frame);
  if (belief.map) frame += MapChanges(*belief.map);
  if (belief.graph) frame += GraphChanges(*belief.graph);
  says_anything_ = says_anything_ || belief.pose || belief.target || belief.map || belief.graph;
  frames_ += fmt::format("{}{{{}}}", frames_.empty() ? "" : ",\n",
                         frame.empty() ? frame : frame.substr(1));
}

std::string BeliefLog::MapChanges(const MapPicture& map) {
  std::string text;
  if (!IsSamePlace(map, map_)) {
    text = fmt::format(",\"low\":[{},{}]", Short(map.low_x), Short(map.low_y));
    map_ = map;
    map_.kinds.assign(map.kinds.size(), MapPicture::Kind::kUnknown);
    cell_ = map.cell;
  }
  const std::string cells = ChangedCells(map_.kinds, map.kinds);
  if (!cells.empty()) text += fmt::format(",\"m\":[{}]", cells);
  map_.kinds = map.kinds;
  return text;
}

std::string BeliefLog::GraphChanges(const GraphPicture& graph) {
  std::string text;
  AddIfOther("n", NodesOf(graph), &nodes_, &text);
  AddIfOther("e", EdgesOf(graph), &edges_, &text);
  AddIfOther("w", fmt::format("[{}]", fmt::join(graph.path, ",")), &way_, &text);
  return text;
}

std::string BeliefLog::ToJson() const {
  return fmt::format("{{\"cell\":{},\"size\":{},\"frames\":[\n{}\n]}}\n", cell_, map_.size,
                     frames_);
}

}  // namespace bulletnav::bench
