// SPDX-License-Identifier: MIT
#include "benchmark/perf/network_figures.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "agent/integer/kernels/kernels.h"
#include "agent/models/model_registry.h"
#include "agent/models/semantic_model.h"
#include "benchmark/runs/agent_models.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kWeights = "assets/weights/nts_rgbd.safetensors";
constexpr int kTogether = 8;
constexpr int kPlaces = 64;

/// Noise: what is seen does not matter to the time.
class Noise {
 public:
  explicit Noise(const sim::PanoramaSpec& spec)
      : pixels_(spec.pixels()), color_(3 * pixels_ * kTogether), depth_(pixels_ * kTogether) {
    sim::Rng rng(0, "bench");
    for (std::uint8_t& value : color_) value = static_cast<std::uint8_t>(rng.Below(256));
    for (float& value : depth_) value = static_cast<float>(rng.Uniform(0.0, 10.0));
    for (std::size_t i = 0; i < kTogether; ++i) {
      panoramas_.push_back({std::span(color_).subspan(3 * pixels_ * i, 3 * pixels_),
                            std::span(depth_).subspan(pixels_ * i, pixels_)});
    }
  }

  std::span<const agent::Panorama> panoramas() const { return panoramas_; }

 private:
  std::size_t pixels_;
  std::vector<std::uint8_t> color_;
  std::vector<float> depth_;
  std::vector<agent::Panorama> panoramas_;
};

}  // namespace

void MeasureNetworks(const std::function<void(const BenchFigure&)>& tell) {
  const std::filesystem::path file = FindWeights(kWeights);
  const agent::Rig rig;
  const auto model = std::dynamic_pointer_cast<agent::SemanticModel>(agent::LoadModel(file, rig));
  if (!model) throw sim::FileError(file, "", "holds no semantic model");
  const Noise noise(rig.panorama);
  const auto ms = [](const std::function<void()>& work, int units) {
    return 1e3 / MedianRate(work, units);
  };
  const std::string name = file.filename().string();
  const auto tell_ms = [&](const std::string& figure, double value, const std::string& unit) {
    tell({figure, value, unit, name, "", 1, agent::SupportedIntegerKernels().front()->name});
  };
  const std::span<const agent::Panorama> all = noise.panoramas();
  tell_ms("encode",
          ms(
              [&] {
                model->Encode(all.first(1));
              },
              1),
          "ms");
  tell_ms("encode_of_8",
          ms(
              [&] {
                model->Encode(all);
              },
              kTogether),
          "ms/panorama");
  const std::vector<agent::PanoramaCode> codes = model->Encode(all);
  std::vector<const agent::PanoramaCode*> places;
  for (std::size_t i = 0; i < kPlaces; ++i) places.push_back(&codes[i % kTogether]);
  const std::span<const agent::PanoramaCode* const> sources = places;
  tell_ms("compare",
          ms(
              [&] {
                model->Compare(sources.first(1), codes.back());
              },
              1),
          "ms");
  tell_ms("compare_64",
          ms(
              [&] {
                model->Compare(sources, codes.back());
              },
              1),
          "ms");
}

}  // namespace bulletnav::bench
