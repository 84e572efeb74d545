// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "agent/integer/dot_layer.h"
#include "agent/integer/pictures.h"
#include "agent/policy/exploration_config.h"
#include "agent/policy/exploration_policy.h"

namespace bulletnav::agent {

/// How the numbers of an exploration policy in integers are kept. Layers are named as those of
/// ExplorationNet; the first fully connected one takes the codes and then a heading, as one of
/// kHeadings numbers that is kExplorationLargest.
inline constexpr int kExplorationLargest = 4095;
inline constexpr double kMeanStep = 1.0 / 1024;  // of means, within 32
/// Where weights keep the logarithms of the two deviations.
inline constexpr const char* kLogDeviation = "log_deviation";

/// An exploration policy in integers: what ExplorationNet says, the same on every processor. Not
/// for several threads at once. Cost: 190 million products.
class IntegerExploration final : public ExplorationPolicy {
 public:
  /// `log_deviation`: of both numbers. Throws Error if layers or scales are missing or do not fit
  /// the configuration.
  IntegerExploration(const ExplorationConfig& config, const QuantisedNet& net,
                     std::span<const float> log_deviation);

  GoalDistribution Ask(std::span<const std::uint8_t> view, int heading) override;

  /// Instead of the fastest kernels, for tests.
  void Use(const IntegerKernels& kernels);

 private:
  using Values = std::vector<std::int16_t>;

  /// A convolution with the pictures that it reads and writes.
  struct Convolution {
    DotLayer layer;
    std::vector<std::int32_t> in_offsets;
    Pictures out;
    std::vector<std::int32_t> out_offsets;
  };
  static Convolution MakeConvolution(const QuantisedLayer& layer, const Pictures& in,
                                     double in_step, double out_step);
  void Convolve(const Pictures& in, Convolution* convolution);

  Pictures input_;
  std::vector<Convolution> convolutions_;
  std::vector<Pictures> pooled_;  // after each of the first convolutions
  DotLayer first_;
  DotLayer second_;
  DotLayer mean_;
  Values codes_;
  Values inside_;
  std::array<double, 2> deviation_ = {};
};

}  // namespace bulletnav::agent
