// SPDX-License-Identifier: MIT
#include "benchmark/base/program_version.h"

#include <gmock/gmock.h>

#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

TEST(ProgramVersion, NamesVersionAndCommit) {
  EXPECT_THAT(ProgramVersion(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+ \\(.+\\)"));
}

TEST(ProgramVersion, CommittedIsEmptyForFilesThatDiffer) {
  const bool is_dirty = ProgramVersion().find("-dirty") != std::string::npos;
  EXPECT_EQ(CommittedVersion(), is_dirty ? "" : ProgramVersion());
}

TEST(ProgramVersion, IsNotedOncePerVersionThatPlayed) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "versions.txt";
  NoteVersion(folder.path());
  NoteVersion(folder.path());
  EXPECT_EQ(sim::ReadTextFile(file), ProgramVersion() + "\n");
  sim::WriteFileAtomically(file, "0.0.9 (abc)\n");
  NoteVersion(folder.path());
  EXPECT_EQ(sim::ReadTextFile(file), "0.0.9 (abc)\n" + ProgramVersion() + "\n");
  EXPECT_EQ(CountVersions(folder.path()), 2);
  EXPECT_THAT(VersionsOf(folder.path()), testing::ElementsAre("0.0.9 (abc)", ProgramVersion()));
  EXPECT_EQ(CountVersions(folder.path() / "none"), 0);
}

}  // namespace
}  // namespace bulletnav::bench
