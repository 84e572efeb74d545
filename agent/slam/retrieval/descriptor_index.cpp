// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/descriptor_index.h"

#include <algorithm>

#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr int kLargestSize = 1024;  // see Cosine

struct Product {
  std::int32_t sum = 0;
  int number = 0;

  /// Whether it is to come first.
  bool operator<(const Product& other) const {
    return sum != other.sum ? sum > other.sum : number < other.number;
  }
};

/// Within 32 bits, see Cosine.
std::int32_t ProductOf(const std::int16_t* a, const std::int16_t* b, std::size_t size) {
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += std::int32_t{a[i]} * b[i];
  return sum;
}

}  // namespace

DescriptorIndex::DescriptorIndex(int size) : size_(static_cast<std::size_t>(size)) {
  BULLETNAV_CHECK(size >= 1 && size <= kLargestSize);
}

void DescriptorIndex::Add(std::span<const std::int16_t> descriptor) {
  BULLETNAV_CHECK_EQ(descriptor.size(), size_);
  numbers_.insert(numbers_.end(), descriptor.begin(), descriptor.end());
}

std::vector<LikeDescriptor> DescriptorIndex::MostLike(std::span<const std::int16_t> query, int most,
                                                      int among) const {
  BULLETNAV_CHECK_EQ(query.size(), size_);
  BULLETNAV_CHECK(among >= 0 && among <= count() && most >= 1);
  std::vector<Product> best;  // a heap, the least like first
  const auto wanted = static_cast<std::size_t>(most);
  best.reserve(wanted + 1);
  const std::int16_t* descriptor = numbers_.data();
  for (int i = 0; i < among; ++i, descriptor += size_) {
    const Product product = {ProductOf(query.data(), descriptor, size_), i};
    if (best.size() == wanted && !(product < best.front())) continue;
    best.push_back(product);
    std::push_heap(best.begin(), best.end());
    if (best.size() <= wanted) continue;
    std::pop_heap(best.begin(), best.end());
    best.pop_back();
  }
  std::sort_heap(best.begin(), best.end());
  std::vector<LikeDescriptor> found;
  found.reserve(best.size());
  for (const Product& one : best) {
    constexpr double kUnit = static_cast<double>(kDescriptorUnit) * kDescriptorUnit;
    found.push_back({one.number, static_cast<double>(one.sum) / kUnit});
  }
  return found;
}

}  // namespace bulletnav::agent
