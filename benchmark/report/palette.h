// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "benchmark/report/canvas.h"

namespace bulletnav::bench {

/// Colours that people with any kind of colour vision can tell apart. Source: Okabe and Ito,
/// "Color universal design", 2008.
inline constexpr Paint kBlack = {0.0, 0.0, 0.0};
inline constexpr Paint kOrange = {0.902, 0.624, 0.0};
inline constexpr Paint kSkyBlue = {0.337, 0.706, 0.914};
inline constexpr Paint kGreen = {0.0, 0.620, 0.451};
inline constexpr Paint kBlue = {0.0, 0.447, 0.698};
inline constexpr Paint kVermillion = {0.835, 0.369, 0.0};
inline constexpr Paint kPurple = {0.800, 0.475, 0.655};
/// In the order in which the lines of a chart take them.
inline constexpr std::array kLineColors = {kBlue,    kVermillion, kGreen, kOrange,
                                           kSkyBlue, kPurple,     kBlack};
inline constexpr Paint kInk = {0.15, 0.15, 0.17};  // of text and axes

/// Dark blue over green to yellow, evenly bright steps, for t in [0, 1]; the lightest end, which
/// white paper swallows, is left out. Source: viridis, Smith and van der Walt, 2015.
Paint TimeColor(double t);

/// A colour for each of many kinds, next ones far apart: hues by the golden angle, every third
/// dark, every third light. Neighbours can be told apart up to some 20.
Paint KindColor(int kind);

}  // namespace bulletnav::bench
