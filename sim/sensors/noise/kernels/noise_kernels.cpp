// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, with BULLETNAV_KERNELS naming the table to define and
// BULLETNAV_KERNELS_NAME what to call it; see CMakeLists.txt.
#include "sim/sensors/noise/kernels/noise_kernels.h"

#include "sim/sensors/noise/kernels/color_noise.h"
#include "sim/sensors/noise/kernels/depth_noise.h"

namespace bulletnav::sim {
namespace {

void ColorPicture(const ColorNoiseFrame& frame) {
  ColorRows(frame).Run();
}

void DepthPicture(const DepthNoiseFrame& frame) {
  DepthRows(frame).Run();
}

}  // namespace

const NoiseKernels BULLETNAV_KERNELS = {BULLETNAV_KERNELS_NAME, ColorPicture, DepthPicture};

}  // namespace bulletnav::sim
