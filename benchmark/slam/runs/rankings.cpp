// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/rankings.h"

#include <map>
#include <string>
#include <string_view>

namespace bulletnav::bench {
namespace {

using ByName = std::map<std::string, RankingOutcome>;

Rankings Collect(const std::vector<const DriveResult*>& results, std::size_t detector,
                 ByName DetectorResult::*member, std::string_view name) {
  Rankings rankings;
  for (const DriveResult* result : results) {
    if (detector >= result->detectors.size()) continue;
    const ByName& by_name = result->detectors[detector].*member;
    const auto found = by_name.find(std::string(name));
    if (found != by_name.end() && found->second.loops > 0) rankings.push_back(&found->second);
  }
  return rankings;
}

}  // namespace

Rankings RankingsOf(const std::vector<const DriveResult*>& results, std::size_t detector,
                    LoopKind kind) {
  return Collect(results, detector, &DetectorResult::rankings, NameOf(kind));
}

Rankings RankingsOf(const std::vector<const DriveResult*>& results, std::size_t detector,
                    HeadingBin bin) {
  return Collect(results, detector, &DetectorResult::headings, NameOf(bin));
}

}  // namespace bulletnav::bench
