// SPDX-License-Identifier: MIT
// Trainings that must succeed, or must fail, if the learner learns.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "benchmark/training/core/registry.h"
#include "sim/config/override.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

/// The measures that a config of configs/train/sanity ends with.
Measures Trained(const std::string& name, std::vector<std::string> overrides = {}) {
  const tests::TemporaryFolder folder;
  overrides.push_back("out=" + (folder.path() / "out").string());
  const std::filesystem::path file =
      std::filesystem::path(BULLETNAV_CONFIGS) / "train/sanity" / (name + ".yaml");
  const sim::YamlNode config =
      sim::WithOverrides(sim::ParseYaml(sim::ReadYamlFile(file), file), file, overrides);
  tests::Watcher watcher;
  RunTraining(MakeTraining(config, "nts", {}), &watcher);
  return watcher.measures();
}

TEST(Sanity, AGridIsLearned) {
  EXPECT_GE(Trained("four_rooms").at("score"), 0.95);
}

TEST(Sanity, ACueIsRememberedAcrossRollouts) {
  EXPECT_GE(Trained("memory").at("success"), 0.98);
}

TEST(Sanity, WithoutMemoryACueIsForgotten) {
  EXPECT_NEAR(Trained("memory", {"model.memory=false"}).at("success"), 0.5, 0.05);
}

}  // namespace
}  // namespace bulletnav::bench
