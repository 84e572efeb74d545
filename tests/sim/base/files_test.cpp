// SPDX-License-Identifier: MIT
#include "sim/base/files.h"

#include <csignal>
#include <functional>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/base/require_writable.h"
#include "sim/base/unfinished_files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;
using tests::TemporaryFolder;

std::string ErrorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const FileError& e) {
    return e.what();
  }
  return "";
}

std::size_t FilesIn(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Files, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "deep" / "er" / "file.txt";
  WriteFileAtomically(file, std::string_view("hello\0world", 11));
  EXPECT_EQ(ReadTextFile(file), std::string("hello\0world", 11));
  WriteFileAtomically(file, std::string_view("again"));
  EXPECT_EQ(ReadTextFile(file), "again");
  EXPECT_EQ(FilesIn(file.parent_path()), 1u);
}

TEST(Files, ReadingWhatCannotBeReadSaysWhy) {
  const TemporaryFolder folder;
  EXPECT_NE(ErrorOf([&] {
              ReadFile(folder.path() / "none");
            }).find("No such file"),
            std::string::npos);
  EXPECT_NE(ErrorOf([&] {
              ReadFile(folder.path());
            }).find("is a directory"),
            std::string::npos);
  EXPECT_NE(ErrorOf([&] {
              ReadFile("/dev/zero");
            }).find("regular file"),
            std::string::npos);
}

TEST(Files, AFailedWriteLeavesTheOldContentAndNoRubbish) {
  const TemporaryFolder folder;
  const fs::path file = folder.Write("file.txt", "old");
  const auto fails = [](const fs::path& temporary) {
    WriteFileAtomically(temporary, std::string_view("half"));
    throw FileError(temporary, "", "stopped half way");
  };
  EXPECT_THROW(WriteFileAtomically(file, fails), FileError);
  EXPECT_EQ(ReadTextFile(file), "old");
  EXPECT_EQ(FilesIn(folder.path()), 1u);
}

TEST(Files, WhatIsBeingWrittenCanBeRemovedByAProcessThatEnds) {
  const TemporaryFolder folder;
  const auto write = [&](const fs::path& temporary) {
    folder.Write(temporary.filename().string(), "half");
    EXPECT_EQ(FilesIn(folder.path()), 1u);
    RemoveUnfinishedFiles();
    EXPECT_EQ(FilesIn(folder.path()), 0u);
    folder.Write(temporary.filename().string(), "whole");
  };
  WriteFileAtomically(folder.path() / "file.txt", write);
  RemoveUnfinishedFiles();
  EXPECT_EQ(ReadTextFile(folder.path() / "file.txt"), "whole");
}

TEST(Files, WhatCannotBeWrittenIsToldBeforeTheWork) {
  const TemporaryFolder folder;
  const fs::path file = folder.Write("file.txt", "old");
  RequireWritable(file);
  RequireWritable(folder.path() / "new" / "other.txt");
  EXPECT_EQ(ReadTextFile(file), "old");
  EXPECT_EQ(FilesIn(folder.path() / "new"), 0u);
  EXPECT_THROW(RequireWritable(folder.path()), FileError);
  EXPECT_THROW(RequireWritable(file / "below_a_file.txt"), FileError);
  EXPECT_THROW(RequireWritable("/proc/none.txt"), FileError);
}

/// A limit on the size of files stands in for a disk that is full.
TEST(Files, ADiskThatIsFullIsSaidAndNothingIsLeft) {
  const TemporaryFolder folder;
  const fs::path file = folder.Write("file.txt", "old");
  rlimit saved{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &saved), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, saved.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string error = ErrorOf([&] {
    WriteFileAtomically(file, std::string_view(std::string(5000, 'x')));
  });
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &saved), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(error.find("cannot be written"), std::string::npos) << error;
  EXPECT_EQ(ReadTextFile(file), "old");
  EXPECT_EQ(FilesIn(folder.path()), 1u);
}

TEST(Files, PlacesThatCannotBeWrittenAreNamed) {
  const TemporaryFolder folder;
  folder.Write("file", "x");
  EXPECT_NE(ErrorOf([&] {
              MakeFolder(folder.path() / "file" / "sub");
            }).find("file/sub"),
            std::string::npos);
  EXPECT_NE(ErrorOf([&] {
              WriteFileAtomically(folder.path(), std::string_view("x"));
            }).find("is a directory"),
            std::string::npos);
  EXPECT_NE(ErrorOf([&] {
              WriteFileAtomically("/proc/nothing/here", std::string_view("x"));
            }).find("/proc/nothing"),
            std::string::npos);
}

TEST(Files, APipeIsNotWaitedFor) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_NE(ErrorOf([&] {
              ReadFile(pipe);
            }).find("pipe: is not a regular file"),
            std::string::npos);
}

TEST(Files, OnlyFilesAreReplaced) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_NE(ErrorOf([&] {
              WriteFileAtomically(pipe, std::string_view("x"));
            }).find("pipe: is not a regular file"),
            std::string::npos);
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_NE(ErrorOf([&] {
              WriteFileAtomically(folder.path() / std::string(300, 'n'), std::string_view("x"));
            }).find("choose another place"),
            std::string::npos);
}

TEST(Files, ALinkIsWrittenThrough) {
  const TemporaryFolder folder;
  const fs::path file = folder.Write("file", "old");
  fs::create_symlink("file", folder.path() / "link");
  WriteFileAtomically(folder.path() / "link", std::string_view("new"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(ReadTextFile(file), "new");
}

TEST(Files, WhatAKilledProcessLeftIsNotInTheWay) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  for (int i = 0; i < 1000; ++i) {
    folder.Write("file.tmp" + std::to_string(::getpid()) + "-" + std::to_string(i), "rubbish");
  }
  WriteFileAtomically(file, std::string_view("x"));
  EXPECT_EQ(ReadTextFile(file), "x");
}

TEST(Files, OnlyWhatKilledProcessesLeftIsRemoved) {
  const TemporaryFolder folder;
  const pid_t killed = ::fork();
  if (killed == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(killed, nullptr, 0), killed);
  const fs::path left = folder.Write("a.bin.tmp" + std::to_string(killed) + "-7", "half");
  const std::vector<fs::path> others = {
      folder.Write("a.bin.tmp" + std::to_string(::getpid()) + "-7", "being written"),
      folder.Write("a.bin", "whole"),
      folder.Write("a.tmp", "of somebody else"),
      folder.Write("a.tmp" + std::to_string(killed), "of somebody else"),
      folder.Write("a.tmp0-1", "of nobody"),
  };
  RemoveLeftovers(folder.path());
  EXPECT_FALSE(fs::exists(left));
  for (const fs::path& other : others) EXPECT_TRUE(fs::exists(other)) << other;
  EXPECT_NO_THROW(RemoveLeftovers(folder.path() / "none"));
}

TEST(Files, ErrorsAreOneLine) {
  const FileError error("a\nb", "3:4", "is\nbroken");
  EXPECT_EQ(std::string(error.what()), "a b:3:4: is broken");
  EXPECT_EQ(std::string(FileError("", "", "is broken").what()), "an empty path: is broken");
}

TEST(Files, HashesAreThePublishedOnes) {
  EXPECT_EQ(Hash64(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(Hash64("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(Hash64("foobar"), 0x85944171f73967e8ULL);
}

}  // namespace
}  // namespace bulletnav::sim
