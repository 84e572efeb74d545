// SPDX-License-Identifier: MIT
#pragma once
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace bulletnav::sim {

/// Threads that share out numbered tasks. Which thread does which task is left to chance; tasks
/// must not depend on it.
class WorkerPool {
 public:
  /// `workers` < 1: one per processor. One worker means the calling thread itself.
  explicit WorkerPool(int workers);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  WorkerPool(WorkerPool&&) = delete;
  WorkerPool& operator=(WorkerPool&&) = delete;

  int workers() const { return workers_; }

  /// Calls task(i, worker) once for each i in [0, count), worker in [0, workers()), and returns
  /// when all are done. After an exception no further task is begun, and the first, by task number,
  /// is thrown when those begun are done: the same one for any number of workers, for tasks are
  /// begun in order. Not to be called from a task.
  void ForEach(int count, const std::function<void(int task, int worker)>& task);

 private:
  void Loop(int worker);
  void Work(int worker);

  int workers_;
  std::mutex mutex_;
  std::condition_variable start_;
  std::condition_variable finished_;
  const std::function<void(int, int)>* task_ = nullptr;
  int count_ = 0;
  int next_ = 0;
  int busy_ = 0;
  unsigned round_ = 0;
  bool closing_ = false;
  int failed_task_ = 0;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace bulletnav::sim
