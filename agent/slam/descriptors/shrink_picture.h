// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace bulletnav::agent {

/// Means over areas of an RGB picture [height, width, 3] of any size at least as large as the
/// result, [rows, cols, 3]; pixels that lie across an edge count in part. Values 0 to 254, 127 is
/// half, as IntegerInput has them; rounds to the nearest, in whole numbers. Another shape of
/// picture is squeezed. Throws sim::Error for a picture that is smaller, or of another number of
/// bytes.
std::vector<std::uint8_t> ShrinkPicture(std::span<const std::uint8_t> rgb, int width_px,
                                        int height_px, int rows, int cols);

}  // namespace bulletnav::agent
