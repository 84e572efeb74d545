// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "benchmark/play/episode_result.h"
#include "sim/base/folder_lock.h"

namespace bulletnav::bench {

/// Lines of episodes.jsonl as they are, without their ends. Their order is the canonical one: by
/// agent, setting, condition, seed, scene and episode.
using ResultLines = std::map<ResultKey, std::string>;

/// The results of one run, in a folder that survives anything: config.yaml (resolved) and
/// episodes.jsonl, one line a finished episode, on the disk before Append returns. After a kill at
/// any moment a store opened on the same folder goes on: the line that was being written is gone,
/// all others are there. episodes.jsonl is made with the first result, or by Add. Thread-safe.
class ResultStore {
 public:
  /// `config`: everything that results depend on, as YAML text. `can_go_on`, if given, is asked
  /// whether results of another config, which then is replaced, hold for this one. Throws
  /// sim::Error if another run holds the folder (with the remedy), if its results are of another
  /// config, or if lines of it are damaged.
  ResultStore(const std::filesystem::path& folder, const std::string& config,
              const std::function<bool(const std::string& other)>& can_go_on = {});
  ~ResultStore();
  ResultStore(const ResultStore&) = delete;
  ResultStore& operator=(const ResultStore&) = delete;
  ResultStore(ResultStore&&) = delete;
  ResultStore& operator=(ResultStore&&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  bool Has(const ResultKey& key) const;
  std::size_t size() const;
  /// Ordered by key.
  std::vector<EpisodeResult> results() const;

  /// Expects: a key that is not there yet (checked). Throws sim::FileError on a full disk, with the
  /// file left as it was before.
  void Append(const EpisodeResult& result);
  /// Takes out the episodes that failed (EpisodeResult::failure), to be played again; returns how
  /// many. The file is whole at any moment.
  int ForgetFailed();
  /// Sorts the file, so that runs of the same results have the same bytes, in whatever order their
  /// episodes ended. The file is whole at any moment.
  void PutInOrder();
  /// Adds results of other stores, and puts all in order, in a file that is whole at any moment.
  /// Takes the place of an episode that failed; throws sim::FileError if anything else that is
  /// there already is another.
  void Add(const ResultLines& lines);

 private:
  void OpenFile();
  void Rewrite(const std::string& text);
  void TakeConfig(const std::string& config,
                  const std::function<bool(const std::string&)>& can_go_on) const;

  std::filesystem::path folder_;
  sim::FolderLock lock_;
  mutable std::mutex mutex_;
  std::map<ResultKey, EpisodeResult> results_;
  int fd_ = -1;
};

/// The results in a folder, ordered by key, also while a run writes there: an unfinished last line
/// is left out, and there may be none yet. Throws sim::FileError for damaged lines and keys that
/// appear twice.
std::vector<EpisodeResult> ReadResults(const std::filesystem::path& folder);

/// Results of a folder, and what is wrong with the lines that are left out: file, line, reason.
struct ReadableResults {
  std::vector<EpisodeResult> results;
  std::vector<std::string> damaged;
};
/// What can be read of the results in a folder, ordered by key; of two results of one key the
/// first. Throws sim::FileError if the file cannot be read at all.
ReadableResults ReadReadableResults(const std::filesystem::path& folder);

/// As ReadResults, as they are written; none if there is no file.
ResultLines ReadResultLines(const std::filesystem::path& folder);

}  // namespace bulletnav::bench
