// SPDX-License-Identifier: MIT
#pragma once
// Random numbers of pixels, for kernels: a picture draws its keys from an Rng, and a pixel's number
// is a function of the keys and its place, so that pixels may be reckoned side by side.
#include <cstdint>

namespace bulletnav::sim {
namespace {

/// 32 random bits. Source: the finaliser of MurmurHash3 (A. Appleby), keyed before and within.
inline std::uint32_t PixelBits(std::uint32_t place, const std::uint32_t* key) {
  std::uint32_t x = (place * 0x9E3779B9u) ^ key[0];
  x ^= x >> 16;
  x *= 0x85EBCA6Bu;
  x = (x ^ (x >> 13)) + key[1];
  x *= 0xC2B2AE35u;
  return x ^ (x >> 16);
}

/// The sum of four uniform bytes, scaled to mean 0 and variance 1: nearly normal, and never beyond
/// 3.5.
inline float PixelNormal(std::uint32_t bits) {
  const std::uint32_t pairs = (bits & 0x00FF00FFu) + ((bits >> 8) & 0x00FF00FFu);
  const auto sum = static_cast<float>(static_cast<std::int32_t>((pairs & 0xFFFFu) + (pairs >> 16)));
  return (sum - 510.0f) * 0.0067658751f;  // sqrt(12 / (4 (256^2 - 1)))
}

/// Of 0 to 2^22. The library's rounding is a call, and no loop with a call becomes vectors.
inline std::int32_t PixelRound(float a) {
  return static_cast<std::int32_t>(a + 0.5f);  // NOLINT(bugprone-incorrect-roundings)
}

inline float PixelMin(float a, float b) {
  return a < b ? a : b;
}

inline float PixelMax(float a, float b) {
  return a > b ? a : b;
}

}  // namespace
}  // namespace bulletnav::sim
