// SPDX-License-Identifier: MIT
#pragma once
// Vectors of 32-bit lanes with what networks in integers need. Only kernel files include this: each
// of them is compiled several times with different flags, so everything here is in an unnamed
// namespace and nothing from std is used.
#include <cstdint>
#include <cstring>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "agent/integer/kernels/kernels.h"

// Loops over registers, which must not be loops any more; and longer ones.
#ifdef __clang__
#define BULLETNAV_UNROLL_ALL _Pragma("clang loop unroll(full)")
#define BULLETNAV_UNROLL_SOME _Pragma("clang loop unroll_count(4)")
#else
#define BULLETNAV_UNROLL_ALL _Pragma("GCC unroll 16")
#define BULLETNAV_UNROLL_SOME _Pragma("GCC unroll 4")
#endif

namespace bulletnav::agent {
namespace {

#if defined(__AVX512BW__)

constexpr int kLanes = 16;
using Lanes = __m512i;

inline Lanes Splat(std::int32_t v) {
  return _mm512_set1_epi32(v);
}
inline Lanes Load(const std::int32_t* p) {
  return _mm512_loadu_si512(p);
}
inline void Store(std::int32_t* p, Lanes v) {
  _mm512_storeu_si512(p, v);
}
inline Lanes Load16(const std::int16_t* p) {
  return _mm512_cvtepi16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)));
}
inline void Store16(std::int16_t* p, Lanes v) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), _mm512_cvtepi32_epi16(v));
}
inline void Store8(std::uint8_t* p, Lanes v) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(p), _mm512_cvtepi32_epi8(v));
}
inline Lanes Add(Lanes a, Lanes b) {
  return _mm512_add_epi32(a, b);
}
inline Lanes Min(Lanes a, Lanes b) {
  return _mm512_min_epi32(a, b);
}
inline Lanes Max(Lanes a, Lanes b) {
  return _mm512_max_epi32(a, b);
}
template <int bits>
inline Lanes ShiftRight(Lanes v) {
  return _mm512_srai_epi32(v, bits);
}
#ifdef __AVX512VNNI__
inline Lanes AddDot8(Lanes sum, Lanes in, Lanes weights) {
  return _mm512_dpbusd_epi32(sum, in, weights);
}
inline Lanes AddDot16(Lanes sum, Lanes in, Lanes weights) {
  return _mm512_dpwssd_epi32(sum, in, weights);
}
#else
inline Lanes AddDot8(Lanes sum, Lanes in, Lanes weights) {
  const Lanes pairs = _mm512_maddubs_epi16(in, weights);
  return Add(sum, _mm512_madd_epi16(pairs, _mm512_set1_epi16(1)));
}
inline Lanes AddDot16(Lanes sum, Lanes in, Lanes weights) {
  return Add(sum, _mm512_madd_epi16(in, weights));
}
#endif
using Wide = __m512i;
inline Wide SplatWide(std::int64_t v) {
  return _mm512_set1_epi64(v);
}
inline Wide AddWide(Wide a, Wide b) {
  return _mm512_add_epi64(a, b);
}
/// Products of even lanes.
inline Wide Multiply(Lanes a, Lanes b) {
  return _mm512_mul_epi32(a, b);
}
inline Lanes OddToEven(Lanes v) {
  return _mm512_srli_epi64(v, 32);
}
/// Low words of both, shifted right by `shift` of at most 32.
inline Lanes Interleave(Wide even, Wide odd, int shift) {
  return _mm512_mask_blend_epi32(0xAAAA, _mm512_srl_epi64(even, _mm_cvtsi32_si128(shift)),
                                 _mm512_sll_epi64(odd, _mm_cvtsi32_si128(32 - shift)));
}

#elif defined(__AVX2__)

constexpr int kLanes = 8;
using Lanes = __m256i;

inline Lanes Splat(std::int32_t v) {
  return _mm256_set1_epi32(v);
}
inline Lanes Load(const std::int32_t* p) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
}
inline void Store(std::int32_t* p, Lanes v) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), v);
}
inline Lanes Load16(const std::int16_t* p) {
  return _mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)));
}
inline __m128i Narrow16(Lanes v) {
  return _mm_packs_epi32(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1));
}
inline void Store16(std::int16_t* p, Lanes v) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(p), Narrow16(v));
}
inline void Store8(std::uint8_t* p, Lanes v) {
  const __m128i half = Narrow16(v);
  _mm_storel_epi64(reinterpret_cast<__m128i*>(p), _mm_packus_epi16(half, half));
}
inline Lanes Add(Lanes a, Lanes b) {
  return _mm256_add_epi32(a, b);
}
inline Lanes Min(Lanes a, Lanes b) {
  return _mm256_min_epi32(a, b);
}
inline Lanes Max(Lanes a, Lanes b) {
  return _mm256_max_epi32(a, b);
}
template <int bits>
inline Lanes ShiftRight(Lanes v) {
  return _mm256_srai_epi32(v, bits);
}
inline Lanes AddDot8(Lanes sum, Lanes in, Lanes weights) {
  const Lanes pairs = _mm256_maddubs_epi16(in, weights);
  return Add(sum, _mm256_madd_epi16(pairs, _mm256_set1_epi16(1)));
}
inline Lanes AddDot16(Lanes sum, Lanes in, Lanes weights) {
  return Add(sum, _mm256_madd_epi16(in, weights));
}
using Wide = __m256i;
inline Wide SplatWide(std::int64_t v) {
  return _mm256_set1_epi64x(v);
}
inline Wide AddWide(Wide a, Wide b) {
  return _mm256_add_epi64(a, b);
}
inline Wide Multiply(Lanes a, Lanes b) {
  return _mm256_mul_epi32(a, b);
}
inline Lanes OddToEven(Lanes v) {
  return _mm256_srli_epi64(v, 32);
}
inline Lanes Interleave(Wide even, Wide odd, int shift) {
  return _mm256_blend_epi32(_mm256_srl_epi64(even, _mm_cvtsi32_si128(shift)),
                            _mm256_sll_epi64(odd, _mm_cvtsi32_si128(32 - shift)), 0xAA);
}

#elif defined(__SSE4_1__)

constexpr int kLanes = 4;
using Lanes = __m128i;

inline Lanes Splat(std::int32_t v) {
  return _mm_set1_epi32(v);
}
inline Lanes Load(const std::int32_t* p) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
}
inline void Store(std::int32_t* p, Lanes v) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(p), v);
}
inline Lanes Load16(const std::int16_t* p) {
  return _mm_cvtepi16_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)));
}
inline void Store16(std::int16_t* p, Lanes v) {
  _mm_storel_epi64(reinterpret_cast<__m128i*>(p), _mm_packs_epi32(v, v));
}
inline void Store8(std::uint8_t* p, Lanes v) {
  const __m128i half = _mm_packs_epi32(v, v);
  const std::int32_t word = _mm_cvtsi128_si32(_mm_packus_epi16(half, half));
  std::memcpy(p, &word, sizeof(word));
}
inline Lanes Add(Lanes a, Lanes b) {
  return _mm_add_epi32(a, b);
}
inline Lanes Min(Lanes a, Lanes b) {
  return _mm_min_epi32(a, b);
}
inline Lanes Max(Lanes a, Lanes b) {
  return _mm_max_epi32(a, b);
}
template <int bits>
inline Lanes ShiftRight(Lanes v) {
  return _mm_srai_epi32(v, bits);
}
inline Lanes AddDot8(Lanes sum, Lanes in, Lanes weights) {
  return Add(sum, _mm_madd_epi16(_mm_maddubs_epi16(in, weights), _mm_set1_epi16(1)));
}
inline Lanes AddDot16(Lanes sum, Lanes in, Lanes weights) {
  return Add(sum, _mm_madd_epi16(in, weights));
}
using Wide = __m128i;
inline Wide SplatWide(std::int64_t v) {
  return _mm_set1_epi64x(v);
}
inline Wide AddWide(Wide a, Wide b) {
  return _mm_add_epi64(a, b);
}
inline Wide Multiply(Lanes a, Lanes b) {
  return _mm_mul_epi32(a, b);
}
inline Lanes OddToEven(Lanes v) {
  return _mm_srli_epi64(v, 32);
}
inline Lanes Interleave(Wide even, Wide odd, int shift) {
  return _mm_blend_epi16(_mm_srl_epi64(even, _mm_cvtsi32_si128(shift)),
                         _mm_sll_epi64(odd, _mm_cvtsi32_si128(32 - shift)), 0xCC);
}

#else

/// One lane: for processors that none of the above is for.
constexpr int kLanes = 1;
using Lanes = std::int32_t;

inline Lanes Splat(std::int32_t v) {
  return v;
}
inline Lanes Load(const std::int32_t* p) {
  return *p;
}
inline void Store(std::int32_t* p, Lanes v) {
  *p = v;
}
inline Lanes Load16(const std::int16_t* p) {
  return *p;
}
inline void Store16(std::int16_t* p, Lanes v) {
  *p = static_cast<std::int16_t>(v);
}
inline void Store8(std::uint8_t* p, Lanes v) {
  *p = static_cast<std::uint8_t>(v);
}
inline Lanes Add(Lanes a, Lanes b) {
  return static_cast<Lanes>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
inline Lanes Min(Lanes a, Lanes b) {
  return a < b ? a : b;
}
inline Lanes Max(Lanes a, Lanes b) {
  return a > b ? a : b;
}
template <int bits>
inline Lanes ShiftRight(Lanes v) {
  return v >> bits;
}
inline Lanes AddDot8(Lanes sum, Lanes in, Lanes weights) {
  for (int i = 0; i < 4; ++i) {
    const auto value = static_cast<std::uint8_t>(static_cast<std::uint32_t>(in) >> (8 * i));
    const auto weight = static_cast<std::int8_t>(static_cast<std::uint32_t>(weights) >> (8 * i));
    sum = Add(sum, value * weight);
  }
  return sum;
}
inline Lanes AddDot16(Lanes sum, Lanes in, Lanes weights) {
  for (int i = 0; i < 2; ++i) {
    const auto value = static_cast<std::int16_t>(static_cast<std::uint32_t>(in) >> (16 * i));
    const auto weight = static_cast<std::int16_t>(static_cast<std::uint32_t>(weights) >> (16 * i));
    sum = Add(sum, value * weight);
  }
  return sum;
}
using Wide = std::int64_t;
inline Wide SplatWide(std::int64_t v) {
  return v;
}
inline Wide AddWide(Wide a, Wide b) {
  return a + b;
}
inline Wide Multiply(Lanes a, Lanes b) {
  return std::int64_t{a} * b;
}
inline Lanes OddToEven(Lanes) {
  return 0;
}
inline Lanes Interleave(Wide even, Wide, int shift) {
  return static_cast<Lanes>(even >> shift);
}

#endif

}  // namespace
}  // namespace bulletnav::agent
