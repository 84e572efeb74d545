// SPDX-License-Identifier: MIT
#include "sim/base/folder_lock.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "sim/base/files.h"

namespace bulletnav::sim {
namespace {

constexpr const char* kLockFile = "lock";

/// The process that wrote itself into the lock file, as a part of a sentence.
std::string Holder(int fd) {
  std::array<char, 32> text{};
  const ssize_t size = ::pread(fd, text.data(), text.size() - 1, 0);
  return size > 0 ? " (process " + std::string(text.data()) + ")" : "";
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, std::string_view remedy) {
  MakeFolder(folder);
  const std::filesystem::path file = folder / kLockFile;
  fd_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (fd_ < 0) {
    throw FileError(file, "", std::string("cannot be created: ") + std::strerror(errno));
  }
  if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
    const std::string holder = Holder(fd_);
    ::close(fd_);
    throw FolderBusy(folder, "",
                     "another run" + holder + " is writing here; " + std::string(remedy));
  }
  RemoveLeftovers(folder);
  const std::string pid = std::to_string(::getpid());
  // For people only: nothing depends on it.
  [[maybe_unused]] const bool is_told =
      ::ftruncate(fd_, 0) == 0 && ::pwrite(fd_, pid.data(), pid.size(), 0) > 0;
}

FolderLock::~FolderLock() {
  ::close(fd_);
}

void WaitForFolder(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kLockFile;
  const int fd = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  int status = -1;
  if (fd >= 0) {
    do {
      status = ::flock(fd, LOCK_EX);
    } while (status != 0 && errno == EINTR);
  }
  const std::string reason = std::strerror(errno);
  if (fd >= 0) ::close(fd);
  if (status != 0) throw FileError(file, "", "cannot be locked: " + reason);
}

}  // namespace bulletnav::sim
