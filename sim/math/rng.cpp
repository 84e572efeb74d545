// SPDX-License-Identifier: MIT
#include "sim/math/rng.h"

#include <cmath>
#include <string>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

struct Product {
  std::uint32_t high;
  std::uint32_t low;
};

Product Multiply(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t p = static_cast<std::uint64_t>(a) * b;
  return {static_cast<std::uint32_t>(p >> 32), static_cast<std::uint32_t>(p)};
}

std::array<std::uint32_t, 2> Split(std::uint64_t word) {
  return {static_cast<std::uint32_t>(word), static_cast<std::uint32_t>(word >> 32)};
}

std::uint64_t Join(const std::array<std::uint32_t, 2>& words) {
  return words[0] | (static_cast<std::uint64_t>(words[1]) << 32);
}

}  // namespace

std::array<std::uint32_t, 4> Philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const Product a = Multiply(0xD2511F53u, counter[0]);
    const Product b = Multiply(0xCD9E8D57u, counter[2]);
    counter = {b.high ^ counter[1] ^ key[0], b.low, a.high ^ counter[3] ^ key[1], a.low};
    key[0] += 0x9E3779B9u;
    key[1] += 0xBB67AE85u;
  }
  return counter;
}

std::uint64_t MixSeed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = a * 0x9E3779B97F4A7C15ULL + b + 0x632BE59BD9B4E019ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

Rng::Rng(const RngKey& key)
    : key_(Split(MixSeed(MixSeed(key.run_seed, key.scene), key.episode))),
      counter_{0, 0, key.step, static_cast<std::uint32_t>(key.stream)} {}

Rng::Rng(std::uint64_t seed, std::string_view name)
    : key_(Split(MixSeed(seed, Hash64(name)))),
      counter_{0, 0, 0, static_cast<std::uint32_t>(Stream::kHouse)} {}

Rng Rng::Fork(std::string_view name, std::uint64_t index) const {
  const std::uint64_t self =
      MixSeed(Join(key_), (static_cast<std::uint64_t>(counter_[2]) << 32) | counter_[3]);
  return {MixSeed(self, index), name};
}

void Rng::Refill() {
  block_ = Philox4x32(counter_, key_);
  used_ = 0;
  if (++counter_[0] == 0) ++counter_[1];
}

std::uint32_t Rng::Next() {
  if (used_ == 4) Refill();
  return block_[static_cast<std::size_t>(used_++)];
}

double Rng::Uniform() {
  const std::uint64_t high = Next() >> 5;
  const std::uint64_t low = Next() >> 6;
  return static_cast<double>((high << 26) | low) * 0x1.0p-53;
}

double Rng::Uniform(double low, double high) {
  return low + (high - low) * Uniform();
}

int Rng::Below(int n) {
  if (n <= 0) throw Error("Rng::Below takes a positive number, not " + std::to_string(n));
  const auto range = static_cast<std::uint32_t>(n);
  const std::uint32_t first_fair = (0u - range) % range;  // 2^32 mod n
  while (true) {
    const Product p = Multiply(Next(), range);
    if (p.low >= first_fair) return static_cast<int>(p.high);
  }
}

int Rng::Between(int low, int high) {
  if (low > high) {
    throw Error("Rng::Between: " + std::to_string(low) + " is above " + std::to_string(high));
  }
  return low + Below(high - low + 1);
}

bool Rng::Chance(double p) {
  return Uniform() < p;
}

double Rng::Normal() {
  if (has_spare_normal_) {
    has_spare_normal_ = false;
    return spare_normal_;
  }
  // Box-Muller; 1 - U lies in (0, 1], where the logarithm is finite.
  const double radius = std::sqrt(-2.0 * Log(1.0 - Uniform()));
  const double angle = 2.0 * kPi * Uniform();
  spare_normal_ = radius * Sin(angle);
  has_spare_normal_ = true;
  return radius * Cos(angle);
}

std::size_t Rng::Weighted(std::span<const double> weights) {
  double total = 0.0;
  for (const double w : weights) total += w;
  if (!(total > 0.0)) throw Error("Rng::Weighted takes weights with a positive sum");
  double left = Uniform() * total;
  std::size_t last_positive = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    last_positive = i;
    left -= weights[i];
    if (left < 0.0) return i;
  }
  return last_positive;
}

}  // namespace bulletnav::sim
