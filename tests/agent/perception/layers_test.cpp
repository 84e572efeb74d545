// SPDX-License-Identifier: MIT
#include "agent/perception/layers.h"

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

torch::Tensor Noise(at::IntArrayRef shape, std::uint64_t seed) {
  return torch::rand(shape, at::detail::createCPUGenerator(seed))
      .contiguous(at::MemoryFormat::ChannelsLast);
}

/// Columns picked one by one, whose gradient is torch's own.
torch::Tensor PickedColumns(const torch::Tensor& x, int count) {
  const std::int64_t cols = x.size(3);
  const torch::Tensor columns = torch::arange(-count, cols + count, torch::kInt64).remainder(cols);
  return x.index_select(3, columns);
}

class WrappedColumns : public testing::TestWithParam<int> {};

TEST_P(WrappedColumns, GoOnFromTheOtherEnd) {
  const torch::Tensor x = Noise({2, 3, 4, 8}, 1);
  EXPECT_TRUE(at::equal(WrapColumns(x, GetParam()), PickedColumns(x, GetParam())));
}

TEST_P(WrappedColumns, HaveTheGradientOfPickedOnes) {
  const torch::Tensor weights = Noise({2, 3, 4, 8 + 2 * GetParam()}, 2);
  const auto gradient = [&](auto wrap) {
    const torch::Tensor x = Noise({2, 3, 4, 8}, 1).requires_grad_();
    // Twice, as a block's input goes to its convolution and its shortcut.
    (wrap(x, GetParam()) * weights + wrap(x, GetParam()).square()).sum().backward();
    return x.grad();
  };
  const torch::Tensor picked = gradient(PickedColumns);
  EXPECT_TRUE(at::allclose(gradient(WrapColumns), picked, 1e-6, 1e-6));
  EXPECT_GT(picked.abs().min().item<float>(), 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Widths, WrappedColumns, testing::Values(1, 3));

TEST(WrapColumns, ChangesNothingThatItIsGiven) {
  const torch::Tensor x = Noise({1, 2, 3, 4}, 1).requires_grad_();
  const torch::Tensor before = x.detach().clone();
  torch::Tensor wrapped = WrapColumns(x, 1);
  const torch::Tensor of_wrapped = Noise({1, 2, 3, 6}, 2);
  const torch::Tensor kept = of_wrapped.clone();
  wrapped.backward(of_wrapped);
  EXPECT_TRUE(at::equal(x.detach(), before));
  EXPECT_TRUE(at::equal(of_wrapped, kept));
}

}  // namespace
}  // namespace bulletnav::agent
