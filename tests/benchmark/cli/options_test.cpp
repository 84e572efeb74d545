// SPDX-License-Identifier: MIT
// Messages recommend options: each must be one that some command has.
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// Calls f(file, text) for each string literal of the program's sources.
template <class F>
void ForEachLiteral(const F& f) {
  static const std::regex literal(R"re("((?:[^"\\\n]|\\.)*)")re");
  for (const char* part : {"agent", "benchmark", "python", "sim"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(BULLETNAV_SOURCE) / part)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".h") continue;
      const std::string text = sim::ReadTextFile(entry.path());
      for (std::sregex_iterator at(text.begin(), text.end(), literal), end; at != end; ++at) {
        f(entry.path(), (*at)[1].str());
      }
    }
  }
}

TEST(Options, ThoseThatMessagesRecommendExist) {
  static const std::regex definition("--([a-z][a-z-]*)(,[^ ]*)?");
  static const std::regex mention("--([a-z][a-z-]+)");
  std::set<std::string> defined = {"help", "array"};  // CLI11's own; of Slurm's sbatch
  std::map<std::string, std::string> mentioned;       // where
  ForEachLiteral([&](const fs::path& file, const std::string& text) {
    std::smatch match;
    if (std::regex_match(text, match, definition)) defined.insert(match[1].str());
    for (std::sregex_iterator at(text.begin(), text.end(), mention), end; at != end; ++at) {
      mentioned.try_emplace((*at)[1].str(), file.string() + ": " + text);
    }
  });
  EXPECT_GT(mentioned.size(), 20u);
  for (const auto& [option, place] : mentioned) {
    EXPECT_TRUE(defined.contains(option)) << "--" << option << " in " << place;
  }
}

}  // namespace
}  // namespace bulletnav::bench
