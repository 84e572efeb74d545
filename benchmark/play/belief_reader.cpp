// SPDX-License-Identifier: MIT
#include "benchmark/play/belief_reader.h"

#include <string>
#include <utility>
#include <vector>

#include "benchmark/base/gzip.h"
#include "benchmark/play/belief_json.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

using agent::GraphPicture;
using agent::MapPicture;

constexpr int kLargestMap = 10'000;  // cells a side
constexpr std::size_t kKinds = 4;

Json ReadGzipJson(const std::filesystem::path& file) {
  std::string text;
  try {
    text = Decompress(sim::ReadFile(file));
  } catch (const sim::FileError&) {
    throw;
  } catch (const sim::Error& e) {
    throw sim::FileError(file, "", e.what());
  }
  return ParseJson(text, file);
}

GraphPicture::Node ReadNode(const JsonCursor& json) {
  const bool has_score = json.Size(3) > 3;
  GraphPicture::Node node{json.Item(0).Number(), json.Item(1).Number(), json.Item(2).Whole(1) == 1};
  if (has_score) node.score = json.Item(3).Number();
  return node;
}

void ReadCells(const JsonCursor& runs, std::vector<MapPicture::Kind>* kinds) {
  std::size_t at = 0;
  for (std::size_t i = 0; i + 1 < runs.Size(); i += 2) {
    at += runs.Item(i).Whole(kinds->size() - at);
    const auto code = static_cast<std::size_t>(runs.Item(i + 1).Whole());
    const std::size_t length = code / kKinds;
    if (length > kinds->size() - at) runs.Fail("holds more cells than the map");
    for (const std::size_t end = at + length; at < end; ++at) {
      (*kinds)[at] = static_cast<MapPicture::Kind>(code % kKinds);
    }
  }
}

}  // namespace

BeliefReader::BeliefReader(const std::filesystem::path& file)
    : file_(file), json_(ReadGzipJson(file)) {
  frames_ = JsonCursor(json_, file_).At("frames").Size();
}

const agent::Belief& BeliefReader::At(std::size_t i) {
  BULLETNAV_CHECK_LT(i, frames_);
  BULLETNAV_CHECK_LE(applied_, i + 1);
  const JsonCursor root(json_, file_);
  const JsonCursor frames = root.At("frames");
  for (; applied_ <= i; ++applied_) Apply(frames.Item(applied_));
  return belief_;
}

void BeliefReader::Apply(const JsonCursor& frame) {
  belief_.pose.reset();
  if (frame.Has("p")) belief_.pose = ReadPlanarPose(frame.At("p"));
  if (frame.Has("t")) {
    const JsonCursor target = frame.At("t");
    belief_.target.reset();
    if (!target.IsNull()) {
      target.ExpectList(2);
      belief_.target = sim::PlanarPose{target.Item(0).Number(), target.Item(1).Number(), 0.0};
    }
  }
  ApplyMap(frame);
  ApplyGraph(frame);
}

void BeliefReader::ApplyMap(const JsonCursor& frame) {
  if (frame.Has("low")) {
    const JsonCursor root(json_, file_);
    MapPicture map;
    map.size = static_cast<int>(root.At("size").Whole(kLargestMap));
    map.cell = root.At("cell").Positive();
    const JsonCursor low = frame.At("low");
    low.ExpectList(2);
    map.low_x = low.Item(0).Number();
    map.low_y = low.Item(1).Number();
    const auto side = static_cast<std::size_t>(map.size);
    map.kinds.assign(side * side, MapPicture::Kind::kUnknown);
    belief_.map = std::move(map);
  }
  if (!frame.Has("m")) return;
  if (!belief_.map) frame.At("m").Fail("changes a map that is nowhere");
  ReadCells(frame.At("m"), &belief_.map->kinds);
}

void BeliefReader::ApplyGraph(const JsonCursor& frame) {
  if (!frame.Has("n") && !belief_.graph) return;
  if (!belief_.graph) belief_.graph.emplace();
  GraphPicture& graph = *belief_.graph;
  if (frame.Has("n")) {
    const JsonCursor nodes = frame.At("n");
    graph.nodes.clear();
    for (std::size_t i = 0; i < nodes.Size(); ++i) graph.nodes.push_back(ReadNode(nodes.Item(i)));
  }
  const auto node = [&](const JsonCursor& json) {
    return json.Index(graph.nodes.size(), "nodes");
  };
  if (frame.Has("e")) {
    const JsonCursor edges = frame.At("e");
    graph.edges.clear();
    for (std::size_t i = 0; i < edges.Size(); ++i) {
      const JsonCursor edge = edges.Item(i);
      edge.ExpectList(2);
      graph.edges.emplace_back(node(edge.Item(0)), node(edge.Item(1)));
    }
  }
  if (frame.Has("w")) {
    const JsonCursor way = frame.At("w");
    graph.path.clear();
    for (std::size_t i = 0; i < way.Size(); ++i) graph.path.push_back(node(way.Item(i)));
  }
}

}  // namespace bulletnav::bench
