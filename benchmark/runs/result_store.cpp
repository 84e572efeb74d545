// SPDX-License-Identifier: MIT
#include "benchmark/runs/result_store.h"

#include <cerrno>
#include <cstring>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "benchmark/base/first_difference.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using sim::FileError;

constexpr const char* kEpisodesFile = "episodes.jsonl";
constexpr const char* kConfigFile = "config.yaml";

constexpr const char* kIfBusy =
    "share the work with --shard I/N, wait for it, or choose another --out";

/// The whole lines of an episodes file, and how many bytes they are.
struct Lines {
  std::map<ResultKey, EpisodeResult> results;
  ResultLines texts;
  std::size_t bytes = 0;
};

void AddLine(std::string_view line, const fs::path& file, int number, Lines* lines) {
  EpisodeResult result = FromJsonLine(line, file, number);
  const ResultKey key = result.key;
  if (!lines->results.emplace(key, std::move(result)).second) {
    throw FileError(file, std::to_string(number),
                    fmt::format("episode '{}' of agent {} appears a second time; delete the line",
                                key.episode, key.agent));
  }
  lines->texts.emplace(key, line);
}

/// A complaint with the line, also where it names the file alone.
std::string AtLine(const fs::path& file, int number, const std::string& complaint) {
  const std::string place = fmt::format("{}:{}:", file.string(), number);
  return complaint.starts_with(place) ? complaint : place + " " + complaint;
}

/// `damaged`, if given, gets what is wrong with lines that are left out; else they throw.
Lines ReadLines(const fs::path& file, std::vector<std::string>* damaged = nullptr) {
  Lines lines;
  const std::string text = sim::ReadTextFile(file);
  int number = 0;
  // What comes after the last line end was being written when the run was killed.
  for (std::size_t end = text.find('\n'); end != std::string::npos;
       end = text.find('\n', lines.bytes)) {
    const std::string_view line(text.data() + lines.bytes, end - lines.bytes);
    try {
      AddLine(line, file, ++number, &lines);
    } catch (const sim::Error& e) {
      if (damaged == nullptr) throw;
      damaged->push_back(AtLine(file, number, e.what()));
    }
    lines.bytes = end + 1;
  }
  if (damaged != nullptr && lines.bytes < text.size()) {
    damaged->push_back(
        fmt::format("{}:{}: is cut off: the run was stopped here, or is still writing",
                    file.string(), number + 1));
  }
  return lines;
}

/// No lines yet, but a run.
bool IsNewRun(const fs::path& folder) {
  return !fs::exists(folder / kEpisodesFile) && fs::exists(folder / kConfigFile);
}

std::vector<EpisodeResult> InOrder(std::map<ResultKey, EpisodeResult> by_key) {
  std::vector<EpisodeResult> results;
  results.reserve(by_key.size());
  for (auto& [key, result] : by_key) results.push_back(std::move(result));
  return results;
}

std::string Joined(const ResultLines& lines) {
  std::string text;
  for (const auto& [key, line] : lines) text += line + "\n";
  return text;
}

void SyncFolder(const fs::path& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  ::fsync(fd);
  ::close(fd);
}

/// False, with errno set, if not all of it could be written and brought to the disk.
bool WriteDurably(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(fd, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return ::fsync(fd) == 0;
}

/// For lines after the first so many bytes.
int OpenToAppend(const fs::path& file, std::size_t bytes) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (fd >= 0 && ::ftruncate(fd, static_cast<off_t>(bytes)) == 0) return fd;
  const std::string reason = std::strerror(errno);
  if (fd >= 0) ::close(fd);
  throw FileError(file, "", "cannot be written: " + reason);
}

}  // namespace

ResultStore::ResultStore(const fs::path& folder, const std::string& config,
                         const std::function<bool(const std::string&)>& can_go_on)
    : folder_(folder), lock_(folder, kIfBusy) {
  TakeConfig(config, can_go_on);
  const fs::path file = folder / kEpisodesFile;
  Lines lines;
  if (!fs::exists(file)) return;
  lines = ReadLines(file);
  results_ = std::move(lines.results);
  fd_ = OpenToAppend(file, lines.bytes);
}

ResultStore::~ResultStore() {
  if (fd_ >= 0) ::close(fd_);
}

void ResultStore::OpenFile() {
  if (fd_ >= 0) return;
  fd_ = OpenToAppend(folder_ / kEpisodesFile, 0);
  SyncFolder(folder_);
}

void ResultStore::TakeConfig(const std::string& config,
                             const std::function<bool(const std::string&)>& can_go_on) const {
  const fs::path file = folder_ / kConfigFile;
  if (!fs::exists(file)) {
    if (fs::exists(folder_ / kEpisodesFile)) {
      throw FileError(folder_, "", "holds results but no config.yaml; choose another --out");
    }
    sim::WriteFileAtomically(file, config);
    return;
  }
  const std::string old = sim::ReadTextFile(file);
  if (old == config) return;
  if (can_go_on && can_go_on(old)) {
    sim::WriteFileAtomically(file, config);
    return;
  }
  throw FileError(file, "",
                  "the results here are of another config: " + FirstDifference(old, config) +
                      "; choose another --out or delete the folder");
}

bool ResultStore::Has(const ResultKey& key) const {
  const std::lock_guard lock(mutex_);
  return results_.contains(key);
}

std::size_t ResultStore::size() const {
  const std::lock_guard lock(mutex_);
  return results_.size();
}

std::vector<EpisodeResult> ResultStore::results() const {
  const std::lock_guard lock(mutex_);
  std::vector<EpisodeResult> results;
  results.reserve(results_.size());
  for (const auto& [key, result] : results_) results.push_back(result);
  return results;
}

void ResultStore::Append(const EpisodeResult& result) {
  const std::string line = ToJsonLine(result) + "\n";
  const std::lock_guard lock(mutex_);
  BULLETNAV_CHECK(!results_.contains(result.key));
  OpenFile();
  struct stat before = {};
  BULLETNAV_CHECK_EQ(::fstat(fd_, &before), 0);
  if (!WriteDurably(fd_, line)) {
    const std::string reason = std::strerror(errno);
    // Even if this fails too, the next run drops the part of a line.
    [[maybe_unused]] const int status = ::ftruncate(fd_, before.st_size);
    throw FileError(folder_ / kEpisodesFile, "",
                    fmt::format("cannot be written: {}; the {} finished episodes are safe: free "
                                "some space and run the same command again",
                                reason, results_.size()));
  }
  results_.emplace(result.key, result);
}

int ResultStore::ForgetFailed() {
  const std::lock_guard lock(mutex_);
  if (results_.empty()) return 0;
  const fs::path file = folder_ / kEpisodesFile;
  std::istringstream lines(sim::ReadTextFile(file));
  std::string kept;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    if (FromJsonLine(line, file, ++number).failure.empty()) kept += line + "\n";
  }
  const std::size_t forgotten = std::erase_if(results_, [](const auto& entry) {
    return !entry.second.failure.empty();
  });
  if (forgotten == 0) return 0;
  Rewrite(kept);
  return static_cast<int>(forgotten);
}

void ResultStore::PutInOrder() {
  Add({});
}

void ResultStore::Add(const ResultLines& lines) {
  const std::lock_guard lock(mutex_);
  const fs::path file = folder_ / kEpisodesFile;
  const bool is_new = fd_ < 0;
  ResultLines all = is_new ? ResultLines() : ReadLines(file).texts;
  for (const auto& [key, line] : lines) {
    const auto [old, is_added] = all.try_emplace(key, line);
    if (is_added || old->second == line) continue;
    if (results_.at(key).failure.empty()) {
      throw FileError(file, "",
                      fmt::format("holds another result of episode '{}' of agent {} than the one "
                                  "to be added; delete this file and add them again",
                                  key.episode, key.agent));
    }
    old->second = line;  // it was played again
  }
  const std::string text = Joined(all);
  if (!is_new && text == sim::ReadTextFile(file)) return;
  Rewrite(text);
  results_ = ReadLines(file).results;
}

void ResultStore::Rewrite(const std::string& text) {
  const fs::path file = folder_ / kEpisodesFile;
  sim::WriteFileAtomically(file, text);
  const int fd = OpenToAppend(file, text.size());
  const int old = std::exchange(fd_, fd);
  if (old >= 0) ::close(old);
}

std::vector<EpisodeResult> ReadResults(const fs::path& folder) {
  if (IsNewRun(folder)) return {};
  return InOrder(ReadLines(folder / kEpisodesFile).results);
}

ReadableResults ReadReadableResults(const fs::path& folder) {
  if (IsNewRun(folder)) return {};
  ReadableResults readable;
  readable.results = InOrder(ReadLines(folder / kEpisodesFile, &readable.damaged).results);
  return readable;
}

ResultLines ReadResultLines(const fs::path& folder) {
  const fs::path file = folder / kEpisodesFile;
  return fs::exists(file) ? ReadLines(file).texts : ResultLines();
}

}  // namespace bulletnav::bench
