// SPDX-License-Identifier: MIT
#include "agent/policy/stitch_policy.h"

#include <array>
#include <string>
#include <utility>

#include <Eigen/Cholesky>

#include "agent/models/semantic_model.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kRidge = 1e-4;  // of the mean variance
constexpr std::array kReaders = {"whole", "source_match", "goal_match"};

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const Matrix> MatrixOf(const torch::Tensor& tensor) {
  return {tensor.data_ptr<double>(), tensor.size(0), tensor.size(1)};
}

/// [n, kCodeSize], a row a patch.
torch::Tensor Patches(PolicyNet* policy, const torch::Tensor& pictures) {
  return policy->Encode(pictures)
      .narrow(1, 0, PolicyNet::kCodes)
      .reshape({-1, kCodeSize})
      .to(torch::kFloat64)
      .contiguous();
}

/// The function x -> x map + shift.
struct CodeMap {
  torch::Tensor map;    // [kCodeSize, kCodeSize]
  torch::Tensor shift;  // [kCodeSize]
  double explained = 0.0;
};

CodeMap Fit(const torch::Tensor& given, const torch::Tensor& wanted) {
  const torch::Tensor x = (given - given.mean(0)).contiguous();
  const torch::Tensor y = (wanted - wanted.mean(0)).contiguous();
  Matrix gram = MatrixOf(x).transpose() * MatrixOf(x);
  gram.diagonal().array() += kRidge * gram.trace() / kCodeSize;
  const Matrix solved = gram.ldlt().solve(MatrixOf(x).transpose() * MatrixOf(y));
  CodeMap result;
  result.map = torch::empty({kCodeSize, kCodeSize}, torch::kFloat64);
  Eigen::Map<Matrix>(result.map.data_ptr<double>(), kCodeSize, kCodeSize) = solved;
  result.shift = wanted.mean(0) - at::matmul(given.mean(0), result.map);
  const double left = (y - at::matmul(x, result.map)).square().sum().item<double>();
  result.explained = 1.0 - left / y.square().sum().item<double>();
  return result;
}

/// The layer reads wanted codes, and given ones from now on.
void PutBefore(const CodeMap& codes, torch::Tensor weight, torch::Tensor bias) {
  const torch::Tensor blocks = weight.to(torch::kFloat64).view({weight.size(0), -1, kCodeSize});
  bias.add_(at::matmul(blocks.sum(1), codes.shift));
  weight.copy_(at::matmul(blocks, codes.map.t()).reshape_as(weight));
}

}  // namespace

double StitchPolicy(const StitchPictures& pictures, std::shared_ptr<IntegerSight> other,
                    PolicyNet* policy) {
  if (pictures.of_policy.size(0) < kCodeSize) {
    throw sim::Error("too few pictures to stitch a policy by");
  }
  const torch::NoGradGuard no_grad;
  const torch::Tensor wanted = Patches(policy, pictures.of_policy);
  policy->SeeWith(std::move(other));
  const CodeMap codes = Fit(Patches(policy, pictures.of_other), wanted);
  const auto layers = policy->named_children();
  for (const std::string name : kReaders) {
    if (!layers.contains(name)) continue;
    auto numbers = layers[name]->named_parameters();
    PutBefore(codes, numbers["weight"], numbers["bias"]);
  }
  return codes.explained;
}

}  // namespace bulletnav::agent
