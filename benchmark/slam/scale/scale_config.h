// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/episodes/import_spec.h"
#include "benchmark/episodes/made_houses.h"
#include "benchmark/slam/traversal/traversal.h"
#include "sim/house/house_index.h"

namespace bulletnav::bench {

/// How finding a place again fares as more and more frames are known: queries are frames of drives
/// through some houses, and what they are searched among are the frames of their own drive that are
/// far enough back, and frames of drives through other houses, up to a size. No frame is there
/// twice.
struct ScaleConfig {
  std::string name;  // of the folder of results; the config file's if empty
  std::optional<HousesSpec> houses;
  sim::Split queries = sim::Split::kTest;
  sim::Split others = sim::Split::kTrain;
  std::vector<std::string> query_scenes;  // mesh files, in addition
  std::vector<std::string> other_scenes;
  ImportSpec import;
  sim::BodySpec body;
  sim::PinholeSpec camera = {.rows = 240, .cols = 320};
  sim::NoiseMode noise = sim::NoiseMode::kAnsReleased;
  int actions = 700;  // of a drive with queries
  int query_every = 5;
  int other_actions = 1500;
  std::uint64_t seed = 0;
  double apart_m = 10.0;    // of travel, as odometry has it, between frames that may be a loop
  std::string descriptors;  // file of weights of a PictureDescriber
  std::vector<int> sizes = {1000, 3000, 10000, 30000, 100000};

  template <class V>
  void Visit(V& v) {
    v("name", name);
    v("houses", houses);
    v("queries", queries);
    v("others", others);
    v("query_scenes", query_scenes);
    v("other_scenes", other_scenes);
    v("import", import);
    v("body", body);
    v("camera", camera);
    v("noise", noise);
    v("actions", actions);
    v("query_every", query_every);
    v("other_actions", other_actions);
    v("seed", seed);
    v("apart_m", apart_m);
    v.Required("descriptors", descriptors);
    v("sizes", sizes);
  }
  void Validate() const;
};

/// Reads a config and fills in its name. Throws sim::FileError at file:line:column. `overrides`:
/// see sim::WithOverrides.
ScaleConfig LoadScaleConfig(const std::filesystem::path& file,
                            std::span<const std::string> overrides = {});

}  // namespace bulletnav::bench
