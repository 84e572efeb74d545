// SPDX-License-Identifier: MIT
// One core: what a panorama costs to encode, to learn from, and a pair to compare.
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "agent/integer/integer_model.h"
#include "agent/perception/mapper_net.h"
#include "agent/perception/quantise.h"
#include "agent/perception/semantic_net.h"

namespace bulletnav::agent {
namespace {

ModelConfig Config(const benchmark::State& state) {
  ModelConfig config;
  config.width = static_cast<int>(state.range(0));
  config.rows = static_cast<int>(state.range(1));
  config.depth = static_cast<DepthFusion>(state.range(2));
  config.encoder = static_cast<EncoderForm>(state.range(3));
  return config;
}

torch::Tensor Color(int count) {
  return torch::randint(0, 256, {count, 128, 512, 3}, torch::kUInt8);
}
torch::Tensor Depth(int count) {
  return torch::rand({count, 128, 512}) * 10.0;
}

void Encode(benchmark::State& state) {
  const c10::InferenceMode inference;
  at::set_num_threads(1);
  const ModelConfig config = Config(state);
  SemanticNet net(config, 1);
  net.eval();
  net.Fold();
  const torch::Tensor color = Color(1);
  const torch::Tensor depth = Depth(1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(net.Describe(PrepareInput(config, color, depth)).source_sum);
  }
}

void Prepare(benchmark::State& state) {
  const ModelConfig config;
  const torch::Tensor color = Color(1);
  const torch::Tensor depth = Depth(1);
  for (auto _ : state) benchmark::DoNotOptimize(PrepareInput(config, color, depth));
}

void Compare(benchmark::State& state) {
  const c10::InferenceMode inference;
  at::set_num_threads(1);
  ModelConfig config;
  SemanticNet net(config, 1);
  net.eval();
  net.Fold();
  const PanoramaParts parts = net.Describe(PrepareInput(config, Color(1), Depth(1)));
  for (auto _ : state) benchmark::DoNotOptimize(net.Compare(parts, parts).scores);
}

/// The model as shipped, in integers, from panoramas as they come from a renderer.
struct Integers {
  std::vector<std::uint8_t> color = std::vector<std::uint8_t>(3 * 128 * 512);
  std::vector<float> depth = std::vector<float>(128 * 512);
  std::unique_ptr<IntegerModel> model;

  explicit Integers(benchmark::State* state) {
    at::set_num_threads(1);
    const auto kernels = SupportedIntegerKernels();
    const auto which = static_cast<std::size_t>(state->range(0));
    for (std::size_t i = 0; i < color.size(); ++i) color[i] = static_cast<std::uint8_t>(i * i >> 5);
    for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = static_cast<float>(i % 1000) * 0.01f;
    if (which >= kernels.size()) {
      state->SkipWithError("not on this processor");
      return;
    }
    SemanticNet net(ModelConfig{}, 1);
    net.eval();
    model = std::make_unique<IntegerModel>(
        Quantise(net, PrepareInput(ModelConfig{}, Color(2), Depth(2))), ModelConfig{}.rows, true);
    model->Use(*kernels[which]);
    state->SetLabel(kernels[which]->name);
  }
};

void EncodeIntegers(benchmark::State& state) {
  const Integers integers(&state);
  const std::vector<Panorama> panoramas(static_cast<std::size_t>(state.range(1)),
                                        Panorama{integers.color, integers.depth});
  if (!integers.model) return;
  for (auto _ : state) benchmark::DoNotOptimize(integers.model->Encode(panoramas).data());
  state.SetItemsProcessed(state.iterations() * state.range(1));
}

void CompareIntegers(benchmark::State& state) {
  const Integers integers(&state);
  if (!integers.model) return;
  const Panorama panorama = {integers.color, integers.depth};
  const PanoramaCode code = integers.model->Encode({&panorama, 1}).front();
  const std::vector<const PanoramaCode*> sources(static_cast<std::size_t>(state.range(1)), &code);
  for (auto _ : state) benchmark::DoNotOptimize(integers.model->Compare(sources, code).data());
  state.SetItemsProcessed(state.iterations() * state.range(1));
}

void IntegerCases(benchmark::internal::Benchmark* bench, int many) {
  bench->ArgNames({"kernels", "count"})->Unit(benchmark::kMillisecond)->MinTime(0.3);
  for (int kernels = 0; kernels < 4; ++kernels) {
    for (const int count : {1, many}) bench->Args({kernels, count});
  }
}

/// Forward and backward of 32 panoramas and 64 pairs.
void Learn(benchmark::State& state) {
  at::set_num_threads(1);
  const ModelConfig config = Config(state);
  SemanticNet net(config, 1);
  const torch::Tensor input = PrepareInput(config, Color(32), Depth(32));
  const torch::Tensor indices = torch::arange(64) % 32;
  for (auto _ : state) {
    const PanoramaParts parts = net.Describe(input, at::detail::createCPUGenerator(1));
    const PairOutputs pairs =
        net.Compare(parts.Select(indices), parts.Select((indices * 7 + 1) % 32));
    (parts.explorable.sum() + pairs.same_node.sum() + pairs.direction.sum() +
     pairs.distance_score.sum() + pairs.scores.sum())
        .backward();
    benchmark::DoNotOptimize(net.parameters()[0].grad());
    net.zero_grad();
  }
  state.SetItemsProcessed(32 * state.iterations());
}

MapperConfig MapperShape(const benchmark::State& state) {
  MapperConfig config;
  config.width = static_cast<int>(state.range(0));
  config.rows = static_cast<int>(state.range(1));
  return config;
}

void MapOne(benchmark::State& state) {
  const c10::InferenceMode inference;
  at::set_num_threads(1);
  const MapperConfig config = MapperShape(state);
  MapperNet net(config, 1);
  net.eval();
  net.Fold();
  const torch::Tensor color = Color(1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(net.forward(PrepareInput(config.seeing(), color, {})).sigmoid());
  }
}

/// Forward and backward of 32 panoramas.
void LearnToMap(benchmark::State& state) {
  at::set_num_threads(1);
  const MapperConfig config = MapperShape(state);
  MapperNet net(config, 1);
  const torch::Tensor input = PrepareInput(config.seeing(), Color(32), {});
  for (auto _ : state) {
    net.forward(input, at::detail::createCPUGenerator(1)).sum().backward();
    benchmark::DoNotOptimize(net.parameters()[0].grad());
    net.zero_grad();
  }
  state.SetItemsProcessed(32 * state.iterations());
}

void MapperCases(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"width", "rows"})->Unit(benchmark::kMillisecond)->MinTime(0.3);
  for (const int width : {16, 32}) {
    for (const int rows : {64, 128}) bench->Args({width, rows});
  }
}

// Width, rows, depth (0 none, 1 channel, 2 separate), form (0 panorama, 1 patches).
void Cases(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"width", "rows", "depth", "form"})->Unit(benchmark::kMillisecond);
  for (const int width : {16, 32, 64}) {
    for (const int rows : {64, 128}) {
      for (const int depth : {1, 2}) bench->Args({width, rows, depth, 0});
    }
  }
  bench->Args({32, 64, 0, 0});
  bench->Args({32, 64, 1, 1});
}

BENCHMARK(Prepare)->Unit(benchmark::kMillisecond);
BENCHMARK(Compare)->Unit(benchmark::kMillisecond);
BENCHMARK(Encode)->Apply(Cases)->MinTime(0.3);
BENCHMARK(EncodeIntegers)->Apply([](auto* bench) {
  IntegerCases(bench, 8);
});
BENCHMARK(CompareIntegers)->Apply([](auto* bench) {
  IntegerCases(bench, 64);
});
BENCHMARK(Learn)->Apply(Cases)->MinTime(0.3);
BENCHMARK(MapOne)->Apply(MapperCases);
BENCHMARK(LearnToMap)->Apply(MapperCases);

}  // namespace
}  // namespace bulletnav::agent

BENCHMARK_MAIN();
