// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "sim/base/elementary.h"

namespace bulletnav::sim::materials {

inline constexpr float kPi = std::numbers::pi_v<float>;

/// Place in a picture, in fractions of its side: x right, y down.
struct Point {
  float x = 0.0f;
  float y = 0.0f;
};

constexpr Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
constexpr Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
constexpr Point operator*(Point a, float k) {
  return {a.x * k, a.y * k};
}
constexpr float Dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
inline float Length(Point a) {
  return std::sqrt(Dot(a, a));
}
/// The coordinates of p along a unit vector and across it.
constexpr Point AlongAxis(Point p, Point axis) {
  return {p.x * axis.x + p.y * axis.y, p.y * axis.x - p.x * axis.y};
}
/// Turned clockwise as seen (y is down), radians.
inline Point Turned(Point p, float angle) {
  const float c = Cos(angle);
  const float s = Sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// Display (sRGB-encoded) values, 0 to 255; may leave that range until the picture is finished.
struct Color {
  float r = 0.0f;
  float g = 0.0f;
  float b = 0.0f;
};

constexpr Color operator+(Color a, Color b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Color operator-(Color a, Color b) {
  return {a.r - b.r, a.g - b.g, a.b - b.b};
}
constexpr Color operator*(Color a, float k) {
  return {a.r * k, a.g * k, a.b * k};
}
constexpr Color operator*(Color a, Color b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}

/// 0xRRGGBB.
constexpr Color Hex(std::uint32_t rgb) {
  return {static_cast<float>(rgb >> 16 & 255), static_cast<float>(rgb >> 8 & 255),
          static_cast<float>(rgb & 255)};
}
constexpr Color Grey(float v) {
  return {v, v, v};
}

constexpr float Mix(float a, float b, float t) {
  return a + (b - a) * t;
}
constexpr Color Mix(Color a, Color b, float t) {
  return a + (b - a) * t;
}

constexpr float Clamp01(float t) {
  return std::clamp(t, 0.0f, 1.0f);
}
/// 0 below `low`, 1 above `high`, smooth between; low > high turns it round.
constexpr float Smooth(float low, float high, float x) {
  const float t = Clamp01((x - low) / (high - low));
  return t * t * (3.0f - 2.0f * t);
}
/// Largest whole number not above x; much faster than std::floor where that is a call.
constexpr int Floor(float x) {
  const int towards_zero = static_cast<int>(x);
  return towards_zero - (x < static_cast<float>(towards_zero) ? 1 : 0);
}
/// The nearest whole number.
constexpr int Round(float x) {
  return Floor(x + 0.5f);
}
/// The part after the point, for negative numbers too: in [0, 1).
constexpr float Fraction(float x) {
  return x - static_cast<float>(Floor(x));
}
/// A wave of period 1 between 0 and 1, 0 at whole numbers: within 1% of a cosine.
constexpr float Wave(float x) {
  const float t = 2.0f * Fraction(x);
  const float rise = t < 1.0f ? t : 2.0f - t;
  return rise * rise * (3.0f - 2.0f * rise);
}
/// Column and row of the i-th cell of a table.
constexpr Point CellOf(int i, int columns) {
  const int row = i / columns;
  return {static_cast<float>(i - row * columns), static_cast<float>(row)};
}
constexpr int Modulo(int a, int n) {
  const int r = a % n;
  return r < 0 ? r + n : r;
}

}  // namespace bulletnav::sim::materials
