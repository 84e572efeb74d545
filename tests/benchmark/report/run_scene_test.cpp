// SPDX-License-Identifier: MIT
#include "benchmark/report/run_scene.h"

#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string Complaint(const std::filesystem::path& file,
                      const std::map<std::string, std::string>& hashes) {
  try {
    RequireSceneOfRun(file, "house", hashes);
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "";
}

TEST(RunScene, OnlyTheSceneOfTheRunPasses) {
  const tests::TemporaryFolder folder;
  const auto file = folder.Write("house.glb", "walls");
  const std::string hash = fmt::format("{:016x}", sim::Hash64(std::string_view("walls")));
  EXPECT_EQ(Complaint(file, {{"house", hash}}), "");
  EXPECT_EQ(Complaint(file, {{"other", "0"}}), "") << "nothing is known of it";
  folder.Write("house.glb", "other walls");
  EXPECT_THAT(Complaint(file, {{"house", hash}}),
              AllOf(HasSubstr("house.glb"), HasSubstr("changed since the run"),
                    HasSubstr("put back"), testing::Not(HasSubstr("\n"))));
}

}  // namespace
}  // namespace bulletnav::bench
