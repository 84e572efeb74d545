// SPDX-License-Identifier: MIT
#include "benchmark/cli/stop_note.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/base/unfinished_files.h"

namespace bulletnav::bench {
namespace {

constexpr std::array<int, 2> kSignals = {SIGINT, SIGTERM};

/// Where the handler writes, as nothing else is safe in one; -1: nobody watches.
std::atomic<int> watched_pipe{-1};
static_assert(std::atomic<int>::is_always_lock_free);

void Handle(int signal) {
  const auto number = static_cast<unsigned char>(signal);
  const int before = errno;
  [[maybe_unused]] const ssize_t told = ::write(watched_pipe.load(), &number, 1);
  errno = before;
}

struct Notes {
  std::mutex mutex;
  std::vector<const StopNote*> all;
};

Notes& AllNotes() {
  static Notes notes;
  return notes;
}

}  // namespace

StopWatch::StopWatch() : is_first_(watched_pipe.load() == -1) {
  if (!is_first_) return;
  if (::pipe2(pipe_.data(), O_CLOEXEC) != 0) throw sim::Error("there are no pipes left to open");
  watched_pipe = pipe_[1];
  thread_ = std::thread([from = pipe_[0]] {
    unsigned char signal = 0;
    if (::read(from, &signal, 1) != 1) return;  // the program ends by itself
    const std::string note = StopNote::Newest();
    std::fprintf(stderr, "%sbulletnav: stopped%s%s\n", ::isatty(STDERR_FILENO) == 1 ? "\n" : "",
                 note.empty() ? "" : ": ", note.c_str());
    sim::RemoveUnfinishedFiles();
    ::_exit(128 + signal);
  });
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler == SIG_IGN) continue;
    struct sigaction action = {};
    action.sa_handler = Handle;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    ::sigaction(kSignals[i], &action, nullptr);
  }
}

StopWatch::~StopWatch() {
  if (!is_first_) return;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], &before_[i], nullptr);
  }
  watched_pipe = -1;
  ::close(pipe_[1]);
  thread_.join();
  ::close(pipe_[0]);
}

StopNote::StopNote(std::function<std::string()> text) : text_(std::move(text)) {
  const std::lock_guard lock(AllNotes().mutex);
  AllNotes().all.push_back(this);
}

StopNote::~StopNote() {
  const std::lock_guard lock(AllNotes().mutex);
  std::erase(AllNotes().all, this);
}

std::string StopNote::Newest() {
  const std::lock_guard lock(AllNotes().mutex);
  return AllNotes().all.empty() ? "" : AllNotes().all.back()->text_();
}

}  // namespace bulletnav::bench
