// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>

#include "agent/slam/pose_graph/loop_sets.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr int kWord = 64;

using Bits = std::vector<std::uint64_t>;

std::uint64_t BitOf(int i) {
  return std::uint64_t{1} << (i % kWord);
}

int Count(const Bits& bits) {
  return std::transform_reduce(bits.begin(), bits.end(), 0, std::plus<>(), [](std::uint64_t word) {
    return std::popcount(word);
  });
}

/// The first that is set, or -1.
int First(const Bits& bits) {
  for (std::size_t w = 0; w < bits.size(); ++w) {
    if (bits[w] != 0) return static_cast<int>(w) * kWord + std::countr_zero(bits[w]);
  }
  return -1;
}

void Keep(std::span<const std::uint64_t> row, Bits* bits) {
  for (std::size_t w = 0; w < bits->size(); ++w) (*bits)[w] &= row[w];
}

void Drop(std::span<const std::uint64_t> row, Bits* bits) {
  for (std::size_t w = 0; w < bits->size(); ++w) (*bits)[w] &= ~row[w];
}

void Clear(int i, Bits* bits) {
  (*bits)[static_cast<std::size_t>(i / kWord)] &= ~BitOf(i);
}

/// Things by falling number of others they agree with.
std::vector<int> ByDegree(const Agreement& agreement) {
  std::vector<int> degree;
  for (int i = 0; i < agreement.size(); ++i) {
    const auto row = agreement.Row(i);
    degree.push_back(Count(Bits(row.begin(), row.end())));
  }
  std::vector<int> order(degree.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return degree[static_cast<std::size_t>(a)] > degree[static_cast<std::size_t>(b)];
  });
  return order;
}

/// The same with other numbers: thing i is order[i].
Agreement Renumbered(const Agreement& agreement, const std::vector<int>& order) {
  Agreement renumbered(agreement.size());
  const auto thing = [&](int i) {
    return order[static_cast<std::size_t>(i)];
  };
  for (int i = 0; i < agreement.size(); ++i) {
    for (int j = 0; j < i; ++j) {
      if (agreement.Has(thing(i), thing(j))) renumbered.Set(i, j);
    }
  }
  return renumbered;
}

/// Works on numbers by falling degree, so that the first of a set is the one that promises most.
class Search {
 public:
  Search(const Agreement& agreement, const SearchLimits& limits)
      : agreement_(agreement), left_(limits) {}

  std::vector<int> Run() {
    for (int i = 0; i < agreement_.size(); ++i) Grow(i);
    Bits all(agreement_.size() > 0 ? agreement_.Row(0).size() : 0, 0);
    for (int i = 0; i < agreement_.size(); ++i)
      all[static_cast<std::size_t>(i / kWord)] |= BitOf(i);
    Expand(std::move(all));
    return best_;
  }
  bool is_within_limits() const { return left_.steps >= 0 && left_.words >= 0; }

 private:
  void Grow(int seed) {
    std::vector<int> members = {seed};
    const auto row = agreement_.Row(seed);
    Bits open(row.begin(), row.end());
    for (int next = First(open); next >= 0; next = First(open)) {
      members.push_back(next);
      Keep(agreement_.Row(next), &open);
    }
    if (members.size() > best_.size()) best_ = members;
  }

  /// Things of one colour disagree with each other, so that a set has at most one of each. Pairs of
  /// thing and number of colours up to it, by rising number.
  std::vector<std::pair<int, int>> Colours(Bits open) const {
    std::vector<std::pair<int, int>> colours;
    for (int colour = 1; First(open) >= 0; ++colour) {
      Bits free = open;
      for (int i = First(free); i >= 0; i = First(free)) {
        colours.emplace_back(i, colour);
        Clear(i, &open);
        Clear(i, &free);
        Drop(agreement_.Row(i), &free);
      }
    }
    return colours;
  }

  void Expand(Bits open) {
    --left_.steps;
    if (!is_within_limits()) return;
    const std::vector<std::pair<int, int>> colours = Colours(open);
    left_.words -= static_cast<std::int64_t>(colours.size() * open.size());
    for (auto it = colours.rbegin(); it != colours.rend() && is_within_limits(); ++it) {
      const auto [i, colour] = *it;
      if (current_.size() + static_cast<std::size_t>(colour) <= best_.size()) return;
      current_.push_back(i);
      Bits rest = open;
      Keep(agreement_.Row(i), &rest);
      if (current_.size() > best_.size()) best_ = current_;
      if (First(rest) >= 0) Expand(std::move(rest));
      current_.pop_back();
      Clear(i, &open);
    }
  }

  const Agreement& agreement_;
  SearchLimits left_;
  std::vector<int> current_;
  std::vector<int> best_;
};

}  // namespace

Agreement::Agreement(int size)
    : size_(size),
      words_(static_cast<std::size_t>((size + kWord - 1) / kWord)),
      bits_(words_ * static_cast<std::size_t>(size), 0) {}

void Agreement::Set(int a, int b) {
  BULLETNAV_CHECK(a >= 0 && a < size_ && b >= 0 && b < size_ && a != b);
  bits_[static_cast<std::size_t>(a) * words_ + static_cast<std::size_t>(b / kWord)] |= BitOf(b);
  bits_[static_cast<std::size_t>(b) * words_ + static_cast<std::size_t>(a / kWord)] |= BitOf(a);
}

bool Agreement::Has(int a, int b) const {
  return (Row(a)[static_cast<std::size_t>(b / kWord)] & BitOf(b)) != 0;
}

std::span<const std::uint64_t> Agreement::Row(int a) const {
  return std::span(bits_).subspan(static_cast<std::size_t>(a) * words_, words_);
}

ConsistentSet LargestAgreeing(const Agreement& agreement, const SearchLimits& limits) {
  const std::vector<int> order = ByDegree(agreement);
  const Agreement renumbered = Renumbered(agreement, order);
  Search search(renumbered, limits);
  ConsistentSet set;
  for (const int i : search.Run()) set.members.push_back(order[static_cast<std::size_t>(i)]);
  std::sort(set.members.begin(), set.members.end());
  set.is_largest = search.is_within_limits();
  return set;
}

}  // namespace bulletnav::agent
