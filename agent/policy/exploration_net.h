// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "agent/models/safetensors.h"
#include "agent/perception/layers.h"
#include "agent/perception/torch.h"
#include "agent/policy/exploration_config.h"
#include "agent/policy/exploration_policy.h"

namespace bulletnav::agent {

/// A convolution of 3 x 3 with a bias, in the type of its input.
class PlainConv : public torch::nn::Module {
 public:
  PlainConv(int in, int out, sim::Rng* rng);
  torch::Tensor forward(const torch::Tensor& x);

 private:
  torch::Tensor weight_;
  torch::Tensor bias_;
};

/// The global policy of Active Neural SLAM: five convolutions on its maps, two fully connected
/// layers, the first with the heading, and heads for the goal's means and the value of the state.
/// The deviations are a parameter that does not depend on what is seen. The same configuration and
/// seed give the same weights on every machine. Source: Chaplot et al., 2020, and the released
/// code's sizes.
class ExplorationNet : public torch::nn::Module {
 public:
  struct Output {
    torch::Tensor means;   // [..., 2]
    torch::Tensor values;  // [...]
  };

  ExplorationNet(const ExplorationConfig& config, std::uint64_t seed);

  const ExplorationConfig& config() const { return config_; }
  /// u8 [n, kExplorationBytes] of WriteExplorationView to [n, kExplorationCodes].
  torch::Tensor Encode(const torch::Tensor& views);
  /// Codes [..., kExplorationCodes] and headings [...].
  Output Answer(const torch::Tensor& codes, const torch::Tensor& headings);

  const torch::Tensor& log_deviation() const { return log_deviation_; }  // [2]

 private:
  ExplorationConfig config_;
  std::vector<std::shared_ptr<PlainConv>> convs_;
  torch::Tensor headings_;  // [kHeadings, heading_size]
  std::shared_ptr<Dense> first_;
  std::shared_ptr<Dense> second_;
  std::shared_ptr<Dense> mean_;
  std::shared_ptr<Dense> value_;
  torch::Tensor log_deviation_;
};

/// [n, kExplorationChannels, side, side] of zeros and ones.
torch::Tensor ExplorationInput(const torch::Tensor& views);

/// A policy that a net answers for; for one thread.
class LearnedExploration final : public ExplorationPolicy {
 public:
  explicit LearnedExploration(std::shared_ptr<ExplorationNet> net) : net_(std::move(net)) {}
  GoalDistribution Ask(std::span<const std::uint8_t> view, int heading) override;

 private:
  std::shared_ptr<ExplorationNet> net_;
};

/// A file of weights holds the configuration as YAML in its metadata under "exploration".
void SaveExploration(const ExplorationNet& net, std::map<std::string, std::string> notes,
                     StoredType type, const std::filesystem::path& file);
/// Throws FileError, also if the configuration is missing or bad.
std::shared_ptr<ExplorationNet> LoadExploration(const std::filesystem::path& file);

}  // namespace bulletnav::agent
