// SPDX-License-Identifier: MIT
#include "sim/base/files.h"

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/base/require_writable.h"
#include "sim/base/unfinished_files.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;

/// Owns a POSIX file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

std::string Reason() {
  return std::strerror(errno);
}

/// A name that no file has. One may be left of a killed process that had our number.
fs::path TemporaryName(const fs::path& file) {
  static std::atomic<unsigned> counter{0};
  fs::path name;
  std::error_code ignored;
  do {
    name = file.string() + ".tmp" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  } while (fs::exists(name, ignored));
  return name;
}

/// The temporary files that are being written.
struct Unfinished {
  std::mutex mutex;
  std::set<fs::path> files;
};

Unfinished& AllUnfinished() {
  static Unfinished all;
  return all;
}

/// One of them.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(fs::path file) : file_(std::move(file)) {
    const std::lock_guard lock(AllUnfinished().mutex);
    AllUnfinished().files.insert(file_);
  }
  ~UnfinishedFile() {
    const std::lock_guard lock(AllUnfinished().mutex);
    AllUnfinished().files.erase(file_);
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  UnfinishedFile(UnfinishedFile&&) = delete;
  UnfinishedFile& operator=(UnfinishedFile&&) = delete;
  const fs::path& path() const { return file_; }

 private:
  fs::path file_;
};

/// The process that a name as of TemporaryName() belongs to; none if it is no such name.
std::optional<pid_t> WriterOf(std::string_view name) {
  constexpr std::string_view kMark = ".tmp";
  const std::size_t at = name.rfind(kMark);
  if (at == std::string_view::npos || at == 0) return std::nullopt;
  const char* const end = name.data() + name.size();
  pid_t writer = 0;
  unsigned counter = 0;
  const auto [dash, no_pid] = std::from_chars(name.data() + at + kMark.size(), end, writer);
  if (no_pid != std::errc() || writer <= 0 || dash == end || *dash != '-') return std::nullopt;
  const auto [stop, no_counter] = std::from_chars(dash + 1, end, counter);
  if (no_counter != std::errc() || stop != end) return std::nullopt;
  return writer;
}

/// The file that is to be replaced: what `file` points to, if it is a link. Throws FileError if
/// that is there and no file.
fs::path RequireReplaceable(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (error && status.type() != fs::file_type::not_found) {
    throw FileError(file, "", "cannot be written: " + error.message() + "; choose another place");
  }
  if (fs::is_directory(status)) throw FileError(file, "", "is a directory; name a file in it");
  if (!fs::exists(status)) return file;
  if (!fs::is_regular_file(status)) {
    throw FileError(file, "", "is not a regular file, and would be replaced; name another");
  }
  return fs::is_symlink(fs::symlink_status(file)) ? fs::canonical(file) : file;
}

void SyncFile(const fs::path& temporary, const fs::path& file) {
  const Descriptor fd(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
  if (fd.get() < 0 || ::fsync(fd.get()) != 0) {
    throw FileError(file, "", "cannot be written: " + Reason());
  }
}

/// `file` is what users know of.
void WriteAll(const fs::path& temporary, const fs::path& file,
              std::span<const std::uint8_t> bytes) {
  const Descriptor fd(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  if (fd.get() < 0) {
    throw FileError(file, "", "cannot be created: " + Reason() + "; choose another place");
  }
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd.get(), bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      throw FileError(file, "", "cannot be written: " + Reason() + "; free some space and retry");
    }
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
}

}  // namespace

std::vector<std::uint8_t> ReadFile(const fs::path& file) {
  // Without waiting for a pipe's other end.
  const Descriptor fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (fd.get() < 0) {
    throw FileError(file, "", "cannot be read: " + Reason() + "; check the path");
  }
  struct stat status = {};
  if (::fstat(fd.get(), &status) != 0) {
    throw FileError(file, "", "cannot be read: " + Reason());
  }
  if (S_ISDIR(status.st_mode)) throw FileError(file, "", "is a directory; name a file in it");
  if (!S_ISREG(status.st_mode)) {
    throw FileError(file, "", "is not a regular file; save what it gives to one");
  }
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::read(fd.get(), bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FileError(file, "", "cannot be read: " + Reason());
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

std::string ReadTextFile(const fs::path& file) {
  const std::vector<std::uint8_t> bytes = ReadFile(file);
  return {bytes.begin(), bytes.end()};
}

void WriteFileAtomically(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  const fs::path target = RequireReplaceable(file);
  if (file.has_parent_path()) MakeFolder(file.parent_path());
  const UnfinishedFile unfinished(TemporaryName(target));
  const fs::path& temporary = unfinished.path();
  try {
    write(temporary);
    SyncFile(temporary, file);
    fs::rename(temporary, target);
  } catch (const fs::filesystem_error& e) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw FileError(file, "", "cannot be written: " + e.code().message());
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

void WriteFileAtomically(const fs::path& file, std::span<const std::uint8_t> bytes) {
  WriteFileAtomically(file, [&](const fs::path& temporary) {
    WriteAll(temporary, file, bytes);
  });
}

void WriteFileAtomically(const fs::path& file, std::string_view text) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(text.data());
  WriteFileAtomically(file, std::span(data, text.size()));
}

void RequireWritable(const fs::path& file) {
  const fs::path target = RequireReplaceable(file);
  if (file.has_parent_path()) MakeFolder(file.parent_path());
  const UnfinishedFile probe(TemporaryName(target));
  WriteAll(probe.path(), file, {});
  std::error_code ignored;
  fs::remove(probe.path(), ignored);
}

void RemoveUnfinishedFiles() {
  const std::lock_guard lock(AllUnfinished().mutex);
  std::error_code ignored;
  for (const fs::path& file : AllUnfinished().files) fs::remove(file, ignored);
}

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    const std::string why = error ? error.message() : "a file of that name exists";
    throw FileError(folder, "", "folder cannot be made: " + why + "; choose another place");
  }
}

void RemoveLeftovers(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::optional<pid_t> writer = WriterOf(entry.path().filename().string());
    if (!writer || !entry.is_regular_file(ignored)) continue;
    if (::kill(*writer, 0) != 0 && errno == ESRCH) fs::remove(entry.path(), ignored);
  }
}

std::uint64_t Hash64(std::span<const std::uint8_t> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3ULL;
  return hash;
}

std::uint64_t Hash64(std::string_view text) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(text.data());
  return Hash64(std::span(data, text.size()));
}

}  // namespace bulletnav::sim
