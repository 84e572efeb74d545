// SPDX-License-Identifier: MIT
// No include runs from a lower floor to a higher one: a part of the program can be read, tested and
// taken away without those above it.
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
    {"agent/"},
    {"agent/mapping/"},
    {"agent/integer/"},
    {"agent/perception/"},
    {"agent/nts/"},
    {"agent/baselines/"},
    {"benchmark/base/"},
    {"benchmark/episodes/"},
    {"benchmark/play/"},
    {"benchmark/privileged/"},
    {"benchmark/runs/"},
    {"benchmark/report/"},
    {"benchmark/replay/"},
    {"benchmark/training/", "benchmark/perf/"},
    {"benchmark/evaluate_perception/"},
    {"benchmark/slam/io/", "benchmark/slam/metrics/"},
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
  for (const char* part : {"sim", "agent", "benchmark"}) {
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

}  // namespace
}  // namespace bulletnav
