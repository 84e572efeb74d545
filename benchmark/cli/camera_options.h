// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <CLI/App.hpp>

#include "sim/render/projection.h"

namespace bulletnav::bench {

/// The options that say what camera draws: a panorama of some projection, or a pinhole.
class CameraOptions {
 public:
  void AddTo(CLI::App* command);
  /// Throws sim::Error for a size, field of view or pitch that cannot be drawn, and for options
  /// that do not go with the projection.
  sim::CameraSpec spec() const;

 private:
  sim::CameraSpec Pinhole() const;
  sim::CameraSpec Panorama() const;

  std::string projection_ = "cylindrical";
  std::string size_;
  double hfov_deg_ = sim::PinholeSpec().hfov_deg;
  double pitch_deg_ = 0.0;
  bool is_pinhole_wanted_ = false;  // some option speaks of one
};

}  // namespace bulletnav::bench
