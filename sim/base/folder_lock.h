// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string_view>

#include "sim/base/error.h"

namespace bulletnav::sim {

/// Another process holds a folder.
class FolderBusy : public FileError {
 public:
  using FileError::FileError;
};

/// Holds a folder for this process alone, by flock on the file `lock` in it: the kernel lets go
/// when the process ends, however it ends, so no lock is ever left behind. What killed processes
/// had half-written there is removed.
class FolderLock {
 public:
  /// Throws FolderBusy, naming the other process and the remedy, if another holds the folder.
  explicit FolderLock(const std::filesystem::path& folder,
                      std::string_view remedy = "wait for it or choose another --out");
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  int fd_;
};

/// Returns when no process holds the folder. Throws FileError if there is no lock to wait for.
void WaitForFolder(const std::filesystem::path& folder);

}  // namespace bulletnav::sim
