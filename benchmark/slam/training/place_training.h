// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "benchmark/slam/training/place_batches.h"
#include "benchmark/slam/training/place_config.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/core/training.h"

namespace bulletnav::bench {

/// The training of the descriptor of flat pictures, from views of places; see DescriptorNet,
/// MakePlaceViews and SimilarityLoss. The same bits on any number of threads.
class PlaceTraining final : public Training {
 public:
  static constexpr std::string_view kName = "place";
  using Config = PlaceTrainConfig;

  /// Makes the views that are not there yet, and loads all.
  PlaceTraining(const Config& config, const TrainContext& context);
  PlaceTraining(const Config& config, std::vector<PlaceViews> train,
                std::vector<PlaceViews> validation);
  ~PlaceTraining() override;
  PlaceTraining(const PlaceTraining&) = delete;
  PlaceTraining& operator=(const PlaceTraining&) = delete;
  PlaceTraining(PlaceTraining&&) = delete;
  PlaceTraining& operator=(PlaceTraining&&) = delete;

  torch::nn::Module& net() override;
  double Learn(const TrainStep& step) override;
  Measures Validate() override;
  std::int64_t FramesAfter(int steps) const override;
  std::string frames_are() const override { return "pictures"; }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override;
  std::optional<Measures> Quantise(const std::filesystem::path& file) override;
  std::string title() const override { return "The descriptor of flat pictures"; }
  std::string Describe(const Measures& measures) const override;
  std::vector<CurveLine> curves() const override;
  std::vector<std::pair<std::string, std::string>> CardRows() const override;
  std::string validated_on() const override;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace bulletnav::bench
