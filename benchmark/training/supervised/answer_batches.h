// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <type_traits>
#include <vector>

#include "agent/perception/one_thread.h"
#include "agent/perception/torch.h"
#include "benchmark/training/supervised/pair_batch.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {

/// What answer(&batch) gives for batches number 0 on, in their order. Nothing is learned; called
/// from the pool's threads, each of which works alone.
template <class Answer>
auto AnswerBatches(const BatchSource& batches, int count, sim::WorkerPool* pool,
                   const Answer& answer) {
  std::vector<std::invoke_result_t<Answer, PairBatch*>> answers(static_cast<std::size_t>(count));
  pool->ForEach(count, [&](int i, int) {
    const torch::NoGradGuard no_grad;
    agent::StayInThisThread();
    PairBatch batch = batches.Batch(static_cast<std::uint64_t>(i));
    batch.Check();
    answers[static_cast<std::size_t>(i)] = answer(&batch);
  });
  return answers;
}

}  // namespace bulletnav::bench
