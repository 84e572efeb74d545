// SPDX-License-Identifier: MIT
#include "sim/threads/worker_pool.h"

#include <algorithm>

namespace bulletnav::sim {

WorkerPool::WorkerPool(int workers)
    : workers_(workers >= 1 ? workers
                            : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {
  for (int worker = 1; worker < workers_; ++worker) {
    threads_.emplace_back([this, worker] {
      Loop(worker);
    });
  }
}

WorkerPool::~WorkerPool() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  start_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::ForEach(int count, const std::function<void(int, int)>& task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = &task;
    count_ = count;
    next_ = 0;
    busy_ = workers_;
    failure_ = nullptr;
    ++round_;
  }
  start_.notify_all();
  Work(0);
  std::unique_lock lock(mutex_);
  finished_.wait(lock, [this] {
    return busy_ == 0;
  });
  task_ = nullptr;
  if (failure_) std::rethrow_exception(failure_);
}

void WorkerPool::Loop(int worker) {
  unsigned seen = 0;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      start_.wait(lock, [&] {
        return closing_ || round_ != seen;
      });
      if (closing_) return;
      seen = round_;
    }
    Work(worker);
  }
}

void WorkerPool::Work(int worker) {
  std::unique_lock lock(mutex_);
  while (next_ < count_ && !failure_) {
    const int i = next_++;
    lock.unlock();
    std::exception_ptr failure;
    try {
      (*task_)(i, worker);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure && (!failure_ || i < failed_task_)) {
      failure_ = failure;
      failed_task_ = i;
    }
  }
  if (--busy_ == 0) finished_.notify_all();
}

}  // namespace bulletnav::sim
