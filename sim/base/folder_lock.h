// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace bulletnav::sim {

/// Holds a folder for this process alone, by flock on the file `lock` in it: the kernel lets go
/// when the process ends, however it ends, so no lock is ever left behind. What killed processes
/// had half-written there is removed.
class FolderLock {
 public:
  /// Throws Error, naming the other process, if another holds the folder.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  int fd_;
};

}  // namespace bulletnav::sim
