// SPDX-License-Identifier: MIT
#pragma once
// Vectors on the compiler's vector extension, so that one kernel source compiles for any
// instruction set: F8 and I8 for the eight children of a node, FW and IW as wide as the processor's
// registers for pixels. Only kernel files include this: each of them is compiled several times with
// different flags, so everything here is in an unnamed namespace and nothing from std is used.
#include <cstdint>
#include <cstring>
#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace bulletnav::sim {
namespace {

using F8 = float __attribute__((vector_size(32)));
using I8 = std::int32_t __attribute__((vector_size(32)));
#if defined(__AVX512F__)
constexpr int kWidth = 16;
#elif defined(__AVX2__)
constexpr int kWidth = 8;
#else
constexpr int kWidth = 4;
#endif
using FW = float __attribute__((vector_size(4 * kWidth)));
using IW = std::int32_t __attribute__((vector_size(4 * kWidth)));
using UW = std::uint32_t __attribute__((vector_size(4 * kWidth)));
using HalfW = std::uint16_t __attribute__((vector_size(4 * kWidth)));

template <class V, class T>
inline V Load(const T* from) {
  V v;
  std::memcpy(&v, from, sizeof(V));
  return v;
}

template <class V, class T>
inline void Store(T* to, V v) {
  std::memcpy(to, &v, sizeof(V));
}

template <class V>
inline V Min(V a, V b) {
  return a < b ? a : b;
}

template <class V>
inline V Max(V a, V b) {
  return a > b ? a : b;
}

template <class V, class S>
inline V Splat(S s) {
  return V{} + s;
}

inline F8 Abs(F8 v) {
  return reinterpret_cast<F8>(reinterpret_cast<I8>(v) & 0x7fffffff);
}

inline I8 ToInt(F8 v) {
  return __builtin_convertvector(v, I8);
}
inline F8 ToFloat(I8 v) {
  return __builtin_convertvector(v, F8);
}

/// A bit for each lane whose comparison result is true.
inline std::uint32_t Bits(I8 mask) {
#ifdef __AVX__
  return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#else
  std::uint32_t bits = 0;
  for (int i = 0; i < 8; ++i) bits |= static_cast<std::uint32_t>(mask[i] & 1) << i;
  return bits;
#endif
}

inline F8 Sqrt(F8 v) {
#ifdef __AVX__
  return reinterpret_cast<F8>(_mm256_sqrt_ps(reinterpret_cast<__m256>(v)));
#else
  for (int i = 0; i < 8; ++i) v[i] = __builtin_sqrtf(v[i]);
  return v;
#endif
}

/// table[index[i]] for each lane.
inline I8 Gather(const std::int32_t* table, I8 index) {
#ifdef __AVX2__
  return reinterpret_cast<I8>(_mm256_i32gather_epi32(table, reinterpret_cast<__m256i>(index), 4));
#else
  I8 v;
  for (int i = 0; i < 8; ++i) v[i] = table[index[i]];
  return v;
#endif
}

// With AVX2 alone, FW is F8 and the functions above serve; otherwise it needs its own.
#if defined(__AVX512F__) || !defined(__AVX2__)
inline IW ToInt(FW v) {
  return __builtin_convertvector(v, IW);
}
inline FW ToFloat(IW v) {
  return __builtin_convertvector(v, FW);
}
#endif

#if defined(__AVX512F__)
inline std::uint32_t Bits(IW mask) {
  return _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask));
}
inline FW Sqrt(FW v) {
  return reinterpret_cast<FW>(_mm512_maskz_sqrt_ps(0xffff, reinterpret_cast<__m512>(v)));
}
#elif !defined(__AVX2__)
inline std::uint32_t Bits(IW mask) {
  std::uint32_t bits = 0;
  for (int i = 0; i < kWidth; ++i) bits |= static_cast<std::uint32_t>(mask[i] & 1) << i;
  return bits;
}
inline FW Sqrt(FW v) {
  for (int i = 0; i < kWidth; ++i) v[i] = __builtin_sqrtf(v[i]);
  return v;
}
#endif

inline UW Gather(const std::uint32_t* table, IW index) {
#if defined(__AVX512F__)
  return reinterpret_cast<UW>(
      _mm512_mask_i32gather_epi32(__m512i{}, 0xffff, reinterpret_cast<__m512i>(index), table, 4));
#elif defined(__AVX2__)
  return reinterpret_cast<UW>(_mm256_i32gather_epi32(reinterpret_cast<const int*>(table),
                                                     reinterpret_cast<__m256i>(index), 4));
#else
  UW v;
  for (int i = 0; i < kWidth; ++i) v[i] = table[index[i]];
  return v;
#endif
}

/// The least of two vectors of half as many lanes, and so on.
inline float SmallestLane(F8 v) {
  v = Min(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
  v = Min(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
  return v[0] < v[1] ? v[0] : v[1];
}

#if defined(__AVX512F__)
inline float SmallestLane(FW v) {
  F8 half[2];
  std::memcpy(half, &v, sizeof(v));
  return SmallestLane(Min(half[0], half[1]));
}
#elif !defined(__AVX2__)
inline float SmallestLane(FW v) {
  float least = v[0];
  for (int i = 1; i < kWidth; ++i) least = v[i] < least ? v[i] : least;
  return least;
}
#endif

}  // namespace
}  // namespace bulletnav::sim
