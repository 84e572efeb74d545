// SPDX-License-Identifier: MIT
// One core: what networks in integers cost on each instruction set.
#include "random_trunk.h"

#include <benchmark/benchmark.h>

#include "agent/integer/integer_trunk.h"

namespace bulletnav::agent {
namespace {

/// The shipped trunk: width 32, 64 rows. Arguments: which kernels, how many panoramas.
void Trunk(benchmark::State& state) {
  const auto kernels = SupportedIntegerKernels();
  const auto which = static_cast<std::size_t>(state.range(0));
  if (which >= kernels.size()) {
    state.SkipWithError("not on this processor");
    return;
  }
  IntegerTrunk trunk(RandomTrunk(64, 32, 2, 1));
  trunk.Use(*kernels[which]);
  state.SetLabel(kernels[which]->name);
  for (auto _ : state) {
    trunk.Run(static_cast<int>(state.range(1)));
    benchmark::DoNotOptimize(trunk.fine(3).data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(1));
}

void Cases(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"kernels", "batch"})->Unit(benchmark::kMillisecond)->MinTime(0.3);
  for (int kernels = 0; kernels < 5; ++kernels) {
    for (const int batch : {1, 4}) bench->Args({kernels, batch});
  }
}

BENCHMARK(Trunk)->Apply(Cases);

}  // namespace
}  // namespace bulletnav::agent

BENCHMARK_MAIN();
