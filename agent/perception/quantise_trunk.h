// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <vector>

#include "agent/integer/quantised_layer.h"
#include "agent/perception/torch.h"

namespace bulletnav::agent {

/// Makes layers of a network in integers from those that were trained, and scales from what its
/// activations come to on some pictures (calibration). Weights get a scale an output; scales are
/// those with the least squared error, so that rare large values may be cut.
/// Source: Krishnamoorthi, "Quantizing deep convolutional networks for efficient inference", 2018,
/// sections 2 and 3; the least squares are ours.
class Quantiser {
 public:
  /// Of `net`, which must outlive it. `shape.halvings` and names as in Trunk.
  explicit Quantiser(const torch::nn::Module& net);

  /// A parameter or buffer by its name.
  const torch::Tensor& Weight(const std::string& name) const;

  /// What Trunk::Stages says of [n, channels, rows, cols] of PrepareInput, float32; layers and
  /// scales go to the result, after `prefix`.
  std::vector<torch::Tensor> Trunk(const std::string& prefix, const torch::Tensor& input);
  /// Likewise, of flat pictures, whose ends do not meet.
  std::vector<torch::Tensor> FlatTrunk(const std::string& prefix, const torch::Tensor& input,
                                       int halvings);

  /// The layer Dense of this name in 8 bits, or in 16 for inputs of the real value `in_step` a
  /// step, no larger than `largest` steps. `weight`: instead of the trained one's; shape [out, in]
  /// or [out, segments, in].
  void Dense8(const std::string& name, torch::Tensor weight = {});
  void Dense16(const std::string& name, double in_step, int largest, torch::Tensor weight = {});

  /// Notes the scale for values that are kept in `steps` steps, of all or of less than all. Returns
  /// what it noted.
  double FitScale(const std::string& name, const torch::Tensor& values, int steps);
  /// So that the largest is at 1 / margin.
  double RoomyScale(const std::string& name, const torch::Tensor& values, int steps, double margin);

  QuantisedNet* net() { return &result_; }

 private:
  struct Conv {
    int kernel;
    int stride;
  };
  /// `x` with `count` columns more at each end.
  torch::Tensor Widened(const torch::Tensor& x, int count) const;
  std::vector<torch::Tensor> Stages(const std::string& prefix, const torch::Tensor& input,
                                    int halvings);
  torch::Tensor Convolve(const std::string& name, const torch::Tensor& x, const Conv& conv);
  torch::Tensor Block(const std::string& prefix, const torch::Tensor& x, int stride);

  std::map<std::string, torch::Tensor> weights_;
  QuantisedNet result_;
  bool ends_meet_ = true;  // of the trunk that is in work
};

}  // namespace bulletnav::agent
