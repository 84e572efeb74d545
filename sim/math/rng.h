// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace bulletnav::sim {

/// Names of independent random streams inside one step of one episode.
enum class Stream : std::uint32_t { kActuation, kOdometry, kAgent, kSampling, kHouse, kSensors };

/// What a random draw depends on, and nothing else: not the thread, not the draws made elsewhere.
struct RngKey {
  std::uint64_t run_seed = 0;
  std::uint64_t scene = 0;
  std::uint64_t episode = 0;
  std::uint32_t step = 0;
  Stream stream = Stream::kSampling;
};

/// Counter-based generator Philox4x32-10: the n-th number of a key is a function of (key, n).
/// Copying copies the position. Cheap to make: one per (step, stream).
/// Source: Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011.
class Rng {
 public:
  explicit Rng(const RngKey& key);
  /// A generator for things that have one seed and a name, such as the parts of a house.
  Rng(std::uint64_t seed, std::string_view name);

  /// A generator independent of this one and of every Fork with another name or index; does not
  /// move this one.
  Rng Fork(std::string_view name, std::uint64_t index = 0) const;

  std::uint32_t Next();
  /// Uniform in [0, 1), 53 bits.
  double Uniform();
  /// Uniform in [low, high).
  double Uniform(double low, double high);
  /// Uniform in {0, ..., n - 1} without bias. Expects: n > 0 (checked).
  int Below(int n);
  /// Uniform in {low, ..., high}. Expects: low <= high (checked).
  int Between(int low, int high);
  /// True with probability p.
  bool Chance(double p);
  /// Standard normal.
  double Normal();
  /// Index i with probability weights[i] / sum. Expects: a positive sum (checked).
  std::size_t Weighted(std::span<const double> weights);

  template <class T>
  const T& Pick(std::span<const T> items) {
    return items[static_cast<std::size_t>(Below(static_cast<int>(items.size())))];
  }
  template <class Container>
  const auto& Pick(const Container& items) {
    return items[static_cast<std::size_t>(Below(static_cast<int>(items.size())))];
  }
  template <class Container>
  void Shuffle(Container& items) {
    for (int i = static_cast<int>(items.size()) - 1; i > 0; --i) {
      std::swap(items[static_cast<std::size_t>(i)], items[static_cast<std::size_t>(Below(i + 1))]);
    }
  }

 private:
  void Refill();

  std::array<std::uint32_t, 2> key_{};
  std::array<std::uint32_t, 4> counter_{};
  std::array<std::uint32_t, 4> block_{};
  int used_ = 4;
  bool has_spare_normal_ = false;
  double spare_normal_ = 0.0;
};

/// The Philox4x32-10 bijection itself, for tests against published vectors.
std::array<std::uint32_t, 4> Philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

/// Mixes 64-bit words into one (SplitMix64 finaliser over a running sum).
std::uint64_t MixSeed(std::uint64_t a, std::uint64_t b);

}  // namespace bulletnav::sim
