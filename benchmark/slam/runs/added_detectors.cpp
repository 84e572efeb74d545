// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/added_detectors.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

bool HasRow(const std::vector<DetectorResult>& rows, const std::string& name) {
  return std::any_of(rows.begin(), rows.end(), [&](const DetectorResult& row) {
    return row.name == name;
  });
}

/// The entries of `config` that have the names of `before`'s, in their order; fewer if some lack.
std::vector<DetectorEntry> Known(const SlamConfig& before, const SlamConfig& config) {
  std::vector<DetectorEntry> known;
  for (const DetectorEntry& old : before.detectors) {
    for (const DetectorEntry& entry : config.detectors) {
      if (entry.name == old.name) known.push_back(entry);
    }
  }
  return known;
}

}  // namespace

bool OnlyAddsDetectors(const SlamConfig& before, const SlamConfig& config) {
  SlamConfig same = config;
  same.detectors = Known(before, config);
  same.published = before.published;
  if (before.against.empty()) same.against.clear();
  for (std::optional<std::string> SlamConfig::*weights :
       {&SlamConfig::sequences, &SlamConfig::filter}) {
    if (!(before.*weights)) (same.*weights).reset();
  }
  return sim::ToYaml(same) == sim::ToYaml(before);
}

bool HasAllRows(const SlamConfig& config, const DriveResult& result) {
  return result.detectors.size() == config.detectors.size() &&
         std::equal(result.detectors.begin(), result.detectors.end(), config.detectors.begin(),
                    [](const DetectorResult& row, const DetectorEntry& entry) {
                      return row.name == entry.name;
                    });
}

SlamConfig WithMissingRows(SlamConfig config, const DriveResult& result) {
  // Copies, since assigning a yaml-cpp node changes all that share it.
  std::vector<DetectorEntry> missing;
  for (const DetectorEntry& entry : config.detectors) {
    const bool is_needed = entry.name == config.against || !HasRow(result.detectors, entry.name);
    if (is_needed) missing.push_back(entry);
  }
  config.detectors = std::move(missing);
  return config;
}

void AddEarlierRows(const SlamConfig& config, const DriveResult& earlier, const TimesByStage& times,
                    PlayedDrive* played) {
  std::vector<DetectorResult> rows;
  rows.reserve(config.detectors.size());
  for (const DetectorEntry& entry : config.detectors) {
    const auto is_it = [&](const DetectorResult& row) {
      return row.name == entry.name;
    };
    const auto old = std::find_if(earlier.detectors.begin(), earlier.detectors.end(), is_it);
    if (old != earlier.detectors.end()) {
      rows.push_back(*old);
      continue;
    }
    auto& now = played->result.detectors;
    const auto found = std::find_if(now.begin(), now.end(), is_it);
    if (found != now.end()) rows.push_back(std::move(*found));
  }
  played->result.detectors = std::move(rows);
  for (const auto& [stage, its] : times) played->times[stage] = its;
}

}  // namespace bulletnav::bench
