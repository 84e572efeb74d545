// SPDX-License-Identifier: MIT
// What holds for the sources as a whole. No include runs from a lower floor to a higher one: a part
// of the program can be read, tested and taken away without those above it. And nothing that
// decides calls what the C library has in several versions, chosen by the processor.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace bulletnav {
namespace {

namespace fs = std::filesystem;

/// From the ground up. A file belongs to the entry that is the longest start of its path; entries
/// of one floor do not know each other.
const std::vector<std::vector<std::string>> kFloors = {
    {"sim/base/"},
    {"sim/config/", "sim/threads/"},
    {"sim/math/"},
    {"sim/grid/", "sim/image/", "sim/noise/", "sim/sensors/array.h"},
    {"sim/render/projection", "sim/observation.h"},
    {"sim/scene/"},
    {"sim/import/", "sim/physics/", "sim/navmesh/", "sim/render/"},
    {"sim/sensors/"},
    {"sim/house/", "sim/"},
    {"agent/observation.h", "agent/belief.h"},
    {"agent/models/"},
    {"agent/slam/pose_graph/", "agent/slam/retrieval/"},
    {"agent/slam/topology/"},
    {"agent/slam/features/"},
    {"agent/slam/verify/"},
    {"agent/slam/loops/"},
    {"agent/"},
    {"agent/mapping/"},
    {"agent/integer/"},
    {"agent/perception/"},
    {"agent/slam/descriptors/"},
    {"agent/policy/"},
    {"agent/metric_map/", "agent/nts/"},
    {"agent/baselines/"},
    {"benchmark/base/"},
    {"benchmark/episodes/"},
    {"benchmark/play/"},
    {"benchmark/privileged/"},
    {"benchmark/runs/"},
    {"benchmark/report/"},
    {"benchmark/replay/"},
    {"benchmark/training/"},
    {"benchmark/perf/"},
    {"benchmark/evaluate_perception/"},
    {"benchmark/slam/io/", "benchmark/slam/metrics/"},
    {"benchmark/slam/traversal/"},
    {"benchmark/slam/truth/"},
    {"benchmark/slam/runs/", "benchmark/slam/training/"},
    {"benchmark/slam/scale/"},
    {"benchmark/slam/plots/", "benchmark/slam/recordings/"},
    {"python/"},
    {"benchmark/cli/"},
};

struct Room {
  std::size_t floor = 0;
  std::string name;
};

/// Where a file is; floor kFloors.size() if nowhere.
Room RoomOf(std::string_view file) {
  Room best{kFloors.size(), ""};
  for (std::size_t floor = 0; floor < kFloors.size(); ++floor) {
    for (const std::string& room : kFloors[floor]) {
      if (file.starts_with(room) && room.size() > best.name.size()) best = {floor, room};
    }
  }
  return best;
}

std::vector<std::string> IncludesOf(const fs::path& file) {
  constexpr std::string_view kStart = "#include \"";
  std::vector<std::string> includes;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(kStart)) continue;
    includes.push_back(line.substr(kStart.size(), line.rfind('"') - kStart.size()));
  }
  return includes;
}

std::vector<fs::path> Sources() {
  std::vector<fs::path> sources;
  for (const char* part : {"sim", "agent", "benchmark", "python"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(BULLETNAV_SOURCE_DIR) / part)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".h" || extension == ".cpp") sources.push_back(entry.path());
    }
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

TEST(Floors, NoIncludeRunsUpwards) {
  const std::vector<fs::path> sources = Sources();
  ASSERT_GT(sources.size(), 500u);
  for (const fs::path& source : sources) {
    const std::string file = fs::relative(source, BULLETNAV_SOURCE_DIR).generic_string();
    const Room here = RoomOf(file);
    ASSERT_LT(here.floor, kFloors.size()) << file << " is on no floor";
    for (const std::string& include : IncludesOf(source)) {
      const Room there = RoomOf(include);
      const bool is_below = there.floor < here.floor;
      EXPECT_TRUE(is_below || there.name == here.name) << file << " includes " << include;
    }
  }
}

/// Pose graphs are solved by libraries that make no such promise.
bool MayDependOnProcessor(const std::string& file) {
  return file.starts_with("agent/slam/") || file.starts_with("benchmark/slam/");
}

/// The first of the functions that a line calls and that are not ours; empty if there is none.
std::string ForeignCallIn(const std::string& line) {
  static const std::vector<std::string> functions = {
      "sin", "cos",   "tan", "asin",  "acos", "atan",  "atan2",  "sinh",   "cosh", "tanh",
      "exp", "expm1", "log", "log1p", "log2", "log10", "lgamma", "tgamma", "pow",  "erf"};
  for (const std::string& function : functions) {
    const std::string call = "std::" + function + "(";
    if (line.find(call) != std::string::npos) return call;
  }
  for (const std::string call : {"AngleAxisf(", "AngleAxisd(", "AngleAxisf ", "AngleAxisd "}) {
    if (line.find(call) != std::string::npos) return call;
  }
  return "";
}

TEST(Sources, ElementaryFunctionsAreOurs) {
  EXPECT_EQ(ForeignCallIn("x = std::atan2(y, x);"), "std::atan2(");
  for (const fs::path& source : Sources()) {
    const std::string file = fs::relative(source, BULLETNAV_SOURCE_DIR).generic_string();
    if (MayDependOnProcessor(file)) continue;
    std::ifstream in(source);
    int number = 1;
    for (std::string line; std::getline(in, line); ++number) {
      EXPECT_EQ(ForeignCallIn(line), "")
          << file << ':' << number << " may give other bits on other processors; see"
          << " sim/base/elementary.h and sim/math/rotation.h: " << line;
    }
  }
}

}  // namespace
}  // namespace bulletnav
