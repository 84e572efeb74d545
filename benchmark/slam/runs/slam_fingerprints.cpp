// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_fingerprints.h"

#include <initializer_list>
#include <optional>

#include "benchmark/base/file_hash.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/episodes/generator.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "fingerprints.yaml";

struct FingerprintFile {
  SlamFingerprints files;

  template <class V>
  void Visit(V& v) {
    v("files", files);
  }
};

void Add(const std::string& name, const fs::path& file, SlamFingerprints* all) {
  if (fs::is_regular_file(file)) (*all)[name] = FileHash(file);
}

/// Throws if a file of the first ones has another hash among the second ones, or none.
void CheckSame(const SlamFingerprints& some, const SlamFingerprints& others, const fs::path& file) {
  for (const auto& [name, hash] : some) {
    const auto other = others.find(name);
    if (other != others.end() && other->second == hash) continue;
    throw sim::FileError(file, "",
                         "results here are of another '" + name +
                             "', which has changed since; choose another --out, or bring it back");
  }
}

}  // namespace

SlamFingerprints FingerprintsOf(const SlamConfig& config) {
  SlamFingerprints all;
  for (const std::string& recording : config.recordings) {
    for (const char* list :
         {"rgb.txt", "depth.txt", "odometry.txt", "groundtruth.txt", "calibration.txt"}) {
      const fs::path file = fs::path(recording) / list;
      Add(file.string(), file, &all);
    }
  }
  GeneratorSpec own;
  own.scenes = config.scenes;
  for (const std::string& scene : ScenesOf(own)) Add(scene, scene, &all);
  for (const std::optional<std::string>* weights :
       {&config.descriptors, &config.places, &config.sequences, &config.filter}) {
    if (*weights) Add(**weights, ShippedOr(**weights), &all);
  }
  return all;
}

SlamFingerprints CheckFingerprints(const SlamConfig& config, const fs::path& folder) {
  const fs::path file = folder / kFile;
  SlamFingerprints now = FingerprintsOf(config);
  if (!fs::exists(file)) return now;
  const SlamFingerprints before = sim::LoadYaml<FingerprintFile>(file).files;
  CheckSame(before, now, file);
  // A recording that has a list more is another one. Detectors that were added may use weights that
  // nobody used before, and earlier versions did not note scenes.
  SlamFingerprints known = now;
  std::erase_if(known, [&](const auto& one) {
    return before.count(one.first) == 0 && fs::path(one.first).extension() != ".txt";
  });
  CheckSame(known, before, file);
  return now;
}

void KeepFingerprints(const SlamConfig& config, const fs::path& folder, bool is_new) {
  FingerprintFile now;
  now.files = is_new ? FingerprintsOf(config) : CheckFingerprints(config, folder);
  if (is_new || !now.files.empty()) {
    sim::WriteFileAtomically(folder / kFile, sim::ToYaml(now));
  }
}

}  // namespace bulletnav::bench
