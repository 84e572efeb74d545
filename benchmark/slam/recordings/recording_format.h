// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <utility>

#include "sim/config/enum_names.h"

namespace bulletnav::bench {

enum class RecordingFormat { kTum, kKitti, kG2o };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::RecordingFormat> {
  static constexpr std::array kNames = {
      std::pair{"tum", bulletnav::bench::RecordingFormat::kTum},
      std::pair{"kitti", bulletnav::bench::RecordingFormat::kKitti},
      std::pair{"g2o", bulletnav::bench::RecordingFormat::kG2o}};
};
