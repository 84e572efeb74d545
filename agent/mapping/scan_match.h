// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "agent/observation.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// Mends the odometry of each step by what depth sees at the height of the eye: what was seen from
/// the last place must be seen from this one too. Errors of a step no longer add up until they have
/// turned the map; along walls that show no end the odometry alone counts.
/// Source: Active Neural SLAM corrects its pose from two views as well, by a network; this is
/// matching of points to lines as scans of lasers are matched, with the odometry as a prior
/// (Censi, "An ICP variant using a point-to-line metric", 2008).
/// Cost: some 0.3 ms for 512 columns.
class ScanMatch {
 public:
  /// Expects: a rig with depth.
  explicit ScanMatch(const Rig& rig);

  void Reset() { last_.clear(); }

  /// The motion since the last panorama, in the frame before it. `odometry`: what it is believed
  /// to be, returned as it is where too little is seen or nothing fits.
  sim::PlanarPose Match(const Panorama& panorama, const sim::PlanarPose& odometry);

 private:
  struct Seen {
    double x = 0.0;  // metres in the body's frame
    double y = 0.0;
    double range = 0.0;  // 0: nothing
  };
  struct Line {
    double x = 0.0;  // unit normal
    double y = 0.0;
    double off = 0.0;  // metres of a point from the line, along the normal
  };

  std::vector<Seen> Scan(std::span<const float> depth) const;
  std::size_t ColumnAt(double bearing) const;
  /// The line through what was last seen in the direction of a point; false if it shows none.
  bool FindLine(const Seen& point, double gate, Line* line) const;
  /// One step of Gauss and Newton. False if too little fits.
  bool Improve(const std::vector<Seen>& now, const sim::PlanarPose& odometry, double gate,
               sim::PlanarPose* motion) const;

  std::size_t row_ = 0;          // nearest to the horizon
  std::vector<double> bearing_;  // [cols], falling
  std::vector<double> level_;    // [cols] level part of a ray of length 1
  std::vector<Seen> last_;       // [cols]; empty before the first
};

}  // namespace bulletnav::agent
