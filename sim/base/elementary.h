// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::sim {

/// Elementary functions with the same bits on every x86-64 processor. The C library has several
/// versions of its own and takes one by the processor: with and without fused multiply-add, their
/// last bits differ, and an episode soon with them. These are made of additions, multiplications,
/// divisions and square roots in double precision, which IEEE 754 rounds in one way only. Use them
/// in all that decides or is stored; std::hypot, std::cbrt, std::exp2, std::remainder and rounding
/// have one version.
///
/// Errors: below 1.5 units in the last place for Sin, Cos, Exp, Log, below 3 for Tan, Atan, Atan2,
/// Asin, Acos; Pow's relative error is below 2 + 2 |y log x| units.

/// Radians; exact reduction up to |x| = 500,000, and of less use beyond. NaN of infinities.
double Sin(double x);
double Cos(double x);
double Tan(double x);

/// Radians, signs and special values as in C's atan2, but for infinities, which give NaN.
double Atan(double x);
double Atan2(double y, double x);
/// Radians; NaN outside of [-1, 1].
double Asin(double x);
double Acos(double x);

/// 0 below -745, infinity above 709.8.
double Exp(double x);
/// -infinity of 0, NaN of less.
double Log(double x);
/// x^y for x >= 0; NaN for less.
double Pow(double x, double y);

/// In double precision, rounded once.
inline float Sin(float x) {
  return static_cast<float>(Sin(double{x}));
}
inline float Cos(float x) {
  return static_cast<float>(Cos(double{x}));
}
inline float Tan(float x) {
  return static_cast<float>(Tan(double{x}));
}
inline float Atan2(float y, float x) {
  return static_cast<float>(Atan2(double{y}, double{x}));
}
inline float Asin(float x) {
  return static_cast<float>(Asin(double{x}));
}
inline float Exp(float x) {
  return static_cast<float>(Exp(double{x}));
}
inline float Log(float x) {
  return static_cast<float>(Log(double{x}));
}
inline float Pow(float x, float y) {
  return static_cast<float>(Pow(double{x}, double{y}));
}

}  // namespace bulletnav::sim
