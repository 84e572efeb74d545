// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_queue.h"

namespace bulletnav::bench {

std::optional<RunJob> RunQueue::Take() {
  const std::lock_guard lock(mutex_);
  if (failure_ || jobs_.empty()) return std::nullopt;
  const RunJob job = jobs_.front();
  jobs_.pop_front();
  return job;
}

std::optional<RunJob> RunQueue::TakeOfRow(std::size_t row) {
  const std::lock_guard lock(mutex_);
  if (failure_ || jobs_.empty() || jobs_.front().row != row || jobs_.front().alone) {
    return std::nullopt;
  }
  const RunJob job = jobs_.front();
  jobs_.pop_front();
  return job;
}

void RunQueue::PutBackAlone(RunJob job) {
  job.alone = true;
  const std::lock_guard lock(mutex_);
  jobs_.push_front(job);
}

void RunQueue::Abort(std::exception_ptr failure) {
  const std::lock_guard lock(mutex_);
  if (!failure_) failure_ = std::move(failure);
}

bool RunQueue::aborted() const {
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr;
}

void RunQueue::Rethrow() const {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace bulletnav::bench
