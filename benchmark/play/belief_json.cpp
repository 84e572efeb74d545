// SPDX-License-Identifier: MIT
#include "benchmark/play/belief_json.h"

#include <string>
#include <string_view>

namespace bulletnav::bench {
namespace {

using agent::GraphPicture;
using agent::MapPicture;

constexpr std::string_view kKinds = "?.#!";  // in the order of MapPicture::Kind
constexpr int kLargestMap = 10'000;          // cells a side

std::string RunLengths(const MapPicture& map, int y) {
  const auto kind = [&](int x) {
    return map.kinds[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.size) +
                     static_cast<std::size_t>(x)];
  };
  std::string text;
  for (int x = 0, run = 1; x < map.size; ++x, ++run) {
    if (x + 1 < map.size && kind(x + 1) == kind(x)) continue;
    text += std::to_string(run) + kKinds[static_cast<std::size_t>(kind(x))];
    run = 0;
  }
  return text;
}

void ReadRow(const JsonCursor& json, MapPicture* map) {
  const std::string text = json.Text();
  std::size_t cells = 0;
  std::size_t run = 0;
  for (const char c : text) {
    const std::size_t kind = kKinds.find(c);
    if (c >= '0' && c <= '9') {
      run = 10 * run + static_cast<std::size_t>(c - '0');
    } else if (kind == std::string_view::npos) {
      json.Fail("expected run lengths and kinds, as in 12?3.1#");
    }
    if (run > static_cast<std::size_t>(map->size) - cells) json.Fail("the row is too long");
    if (kind == std::string_view::npos) continue;
    map->kinds.insert(map->kinds.end(), run, static_cast<MapPicture::Kind>(kind));
    cells += run;
    run = 0;
  }
  if (cells != static_cast<std::size_t>(map->size)) json.Fail("the row is too short");
}

Json ToJson(const MapPicture& map) {
  Json rows = Json::array();
  for (int y = 0; y < map.size; ++y) rows.push_back(RunLengths(map, y));
  return {{"size", map.size},
          {"cell", map.cell},
          {"low_x", Rounded(map.low_x)},
          {"low_y", Rounded(map.low_y)},
          {"rows", std::move(rows)}};
}

MapPicture ReadMap(const JsonCursor& json) {
  MapPicture map;
  map.size = static_cast<int>(json.At("size").Whole(kLargestMap));
  map.cell = json.At("cell").Positive();
  map.low_x = json.At("low_x").Number();
  map.low_y = json.At("low_y").Number();
  const JsonCursor rows = json.At("rows");
  rows.ExpectList(static_cast<std::size_t>(map.size));
  for (std::size_t y = 0; y < rows.Size(); ++y) ReadRow(rows.Item(y), &map);
  return map;
}

Json ToJson(const GraphPicture& graph) {
  Json nodes = Json::array();
  for (const GraphPicture::Node& node : graph.nodes) {
    Json item = {Rounded(node.x), Rounded(node.y), node.is_ghost ? 1 : 0};
    if (node.score) item.push_back(Rounded(*node.score));
    nodes.push_back(std::move(item));
  }
  Json edges = Json::array();
  for (const auto& [from, to] : graph.edges) edges.push_back({from, to});
  Json json = {{"nodes", std::move(nodes)}, {"edges", std::move(edges)}};
  if (!graph.path.empty()) json["path"] = graph.path;
  return json;
}

GraphPicture::Node ReadNode(const JsonCursor& json) {
  const bool has_score = json.Size() == 4;
  if (!has_score) json.ExpectList(3);
  GraphPicture::Node node{json.Item(0).Number(), json.Item(1).Number(), json.Item(2).Whole(1) == 1};
  if (has_score) node.score = json.Item(3).Number();
  return node;
}

void ReadPath(const JsonCursor& json, GraphPicture* graph) {
  for (std::size_t i = 0; i < json.Size(); ++i) {
    graph->path.push_back(json.Item(i).Index(graph->nodes.size(), "nodes"));
  }
}

GraphPicture ReadGraph(const JsonCursor& json) {
  GraphPicture graph;
  const JsonCursor nodes = json.At("nodes");
  for (std::size_t i = 0; i < nodes.Size(); ++i) graph.nodes.push_back(ReadNode(nodes.Item(i)));
  const JsonCursor edges = json.At("edges");
  for (std::size_t i = 0; i < edges.Size(); ++i) {
    const JsonCursor edge = edges.Item(i);
    edge.ExpectList(2);
    const auto node = [&](std::size_t end) {
      return edge.Item(end).Index(graph.nodes.size(), "nodes");
    };
    graph.edges.emplace_back(node(0), node(1));
  }
  if (json.Has("path")) ReadPath(json.At("path"), &graph);
  return graph;
}

}  // namespace

Json ToJson(const sim::PlanarPose& pose) {
  return {Rounded(pose.x), Rounded(pose.y), Rounded(pose.yaw)};
}

sim::PlanarPose ReadPlanarPose(const JsonCursor& json) {
  json.ExpectList(3);
  return {json.Item(0).Number(), json.Item(1).Number(), json.Item(2).Number()};
}

Json ToJson(const agent::Belief& belief) {
  Json json = Json::object();
  if (belief.pose) json["pose"] = ToJson(*belief.pose);
  if (belief.target) json["target"] = ToJson(*belief.target);
  if (belief.map) json["map"] = ToJson(*belief.map);
  if (belief.graph) json["graph"] = ToJson(*belief.graph);
  return json;
}

agent::Belief ReadBelief(const JsonCursor& json) {
  agent::Belief belief;
  if (json.Has("pose")) belief.pose = ReadPlanarPose(json.At("pose"));
  if (json.Has("target")) belief.target = ReadPlanarPose(json.At("target"));
  if (json.Has("map")) belief.map = ReadMap(json.At("map"));
  if (json.Has("graph")) belief.graph = ReadGraph(json.At("graph"));
  return belief;
}

}  // namespace bulletnav::bench
