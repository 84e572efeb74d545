// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_play.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace bulletnav::bench {
namespace {

std::size_t WorkerCount(int workers) {
  if (workers > 0) return static_cast<std::size_t>(workers);
  return std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

}  // namespace

void PlayJobs(const RunPlan& plan, std::span<const RunJob> jobs, int workers, SceneCache* scenes,
              const TakeEpisode& finish) {
  for (const RunJob& job : jobs) {
    scenes->Expect(plan.episodes.scene_files.at(plan.KeyOf(job).scene));
  }
  scenes->DropOthers();
  RunShared shared{plan, RunQueue({jobs.begin(), jobs.end()}), *scenes, finish};
  std::vector<std::jthread> threads(std::min(WorkerCount(workers), jobs.size()));
  for (std::jthread& thread : threads) {
    thread = std::jthread([&shared] {
      RunWorker(&shared).Work();
    });
  }
  threads.clear();  // joins them
  shared.queue.Rethrow();
}

}  // namespace bulletnav::bench
