// SPDX-License-Identifier: MIT
// Agents see observations and nothing else. No header they can reach knows the simulator.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "agent/registry.h"

namespace bulletnav::sim {

class Navmesh;
class NavmeshQuery;
class PhysicsWorld;
class SimulatedBody;
class Simulator;
class World;
struct SceneMesh;

}  // namespace bulletnav::sim

namespace bulletnav::agent {
namespace {

namespace fs = std::filesystem;

template <class T>
concept Complete = requires {
  sizeof(T);
};

static_assert(!Complete<sim::Navmesh>);
static_assert(!Complete<sim::NavmeshQuery>);
static_assert(!Complete<sim::PhysicsWorld>);
static_assert(!Complete<sim::SceneMesh>);
static_assert(!Complete<sim::SimulatedBody>);
static_assert(!Complete<sim::Simulator>);
static_assert(!Complete<sim::World>);

const std::vector<std::string> kAllowed = {"agent/",
                                           "sim/base/",
                                           "sim/config/",
                                           "sim/grid/",
                                           "sim/math/",
                                           "sim/observation.h",
                                           "sim/render/projection.h",
                                           "sim/sensors/array.h"};

bool IsAllowed(const std::string& header) {
  return std::any_of(kAllowed.begin(), kAllowed.end(), [&](const std::string& start) {
    return header.starts_with(start);
  });
}

/// What stands between the quotes or brackets of the #include lines of a file.
std::vector<std::string> Includes(const fs::path& file, char open, char close) {
  std::vector<std::string> found;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || !line.substr(hash).starts_with("#include")) continue;
    const std::size_t begin = line.find(open, hash);
    if (begin == std::string::npos) continue;
    found.push_back(line.substr(begin + 1, line.find(close, begin + 1) - begin - 1));
  }
  return found;
}

std::vector<fs::path> AgentSources() {
  std::vector<fs::path> sources;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(BULLETNAV_SOURCE_DIR) / "agent")) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".h" || kind == ".cpp") sources.push_back(entry.path());
  }
  return sources;
}

TEST(Boundary, WhatAgentsIncludeLeadsToNoGroundTruth) {
  std::vector<fs::path> queue = AgentSources();
  ASSERT_GT(queue.size(), 5u);
  std::set<fs::path> seen(queue.begin(), queue.end());
  while (!queue.empty()) {
    const fs::path file = queue.back();
    queue.pop_back();
    for (const std::string& header : Includes(file, '"', '"')) {
      EXPECT_TRUE(IsAllowed(header)) << file << " includes " << header;
      const fs::path next = fs::path(BULLETNAV_SOURCE_DIR) / header;
      if (fs::exists(next) && seen.insert(next).second) queue.push_back(next);
    }
  }
}

TEST(Boundary, AgentsDoNotReachForBulletOrRecastThemselves) {
  for (const fs::path& file : AgentSources()) {
    for (const std::string& header : Includes(file, '<', '>')) {
      EXPECT_FALSE(header.starts_with("bullet") || header.starts_with("bt") ||
                   header.starts_with("recast") || header.starts_with("embree"))
          << file << " includes " << header;
    }
  }
}

}  // namespace
}  // namespace bulletnav::agent
