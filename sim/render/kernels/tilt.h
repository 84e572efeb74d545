// SPDX-License-Identifier: MIT
#pragma once
// A pitched camera is drawn as a level one, with the scene turned the other way around it.
#include "sim/render/kernels/kernels.h"
#include "sim/render/kernels/simd.h"

namespace bulletnav::sim {
namespace {

/// An offset from the camera becomes one in the level frame.
inline void MakeLevel(const KernelFrame& frame, F8 (&v)[3]) {
  if (frame.is_level) return;
  const F8 world[3] = {v[0], v[1], v[2]};
  for (int i = 0; i < 3; ++i) {
    const float(&t)[3] = frame.tilt[i];
    v[i] = world[0] * t[0] + world[1] * t[1] + world[2] * t[2];
  }
}

/// A box becomes one around it that is upright in the level frame.
inline void MakeBoxLevel(const KernelFrame& frame, F8 (&low)[3], F8 (&high)[3]) {
  if (frame.is_level) return;
  constexpr float kRounding = 1e-6f;
  F8 centre[3];
  F8 half[3];
  F8 size = F8{};
  for (int i = 0; i < 3; ++i) {
    centre[i] = 0.5f * (low[i] + high[i]);
    half[i] = 0.5f * (high[i] - low[i]);
    size += Abs(centre[i]) + half[i];
  }
  MakeLevel(frame, centre);
  for (int i = 0; i < 3; ++i) {
    F8 reach = kRounding * size;
    for (int k = 0; k < 3; ++k) {
      const float t = frame.tilt[i][k];
      reach += half[k] * (t < 0.0f ? -t : t);
    }
    low[i] = centre[i] - reach;
    high[i] = centre[i] + reach;
  }
}

/// A pixel's ray becomes one in the world.
inline void MakeWorld(const KernelFrame& frame, FW (&ray)[3]) {
  if (frame.is_level) return;
  const FW level[3] = {ray[0], ray[1], ray[2]};
  for (int i = 0; i < 3; ++i) {
    ray[i] =
        level[0] * frame.tilt[0][i] + level[1] * frame.tilt[1][i] + level[2] * frame.tilt[2][i];
  }
}

}  // namespace
}  // namespace bulletnav::sim
