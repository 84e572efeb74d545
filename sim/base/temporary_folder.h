// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace bulletnav::sim {

/// A new empty folder where temporary files belong, removed with all it holds.
class TemporaryFolder {
 public:
  /// Throws sim::FileError.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace bulletnav::sim
