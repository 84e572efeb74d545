// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "agent/observation.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// Mends the turns that odometry reads by what colour sees all around: a body that turns on the
/// spot sees the same panorama moved sideways. An error of some tenths of a degree in each turn,
/// always to the same side, otherwise turns the map upside down within a thousand turns.
/// Two panoramas are brought over each other by least squares, with odometry as a prior; how near
/// things move when the body slips aside are two more unknowns, and what does not fit counts less
/// and less. A single turn is seen to within .25 degrees. Odometry is more exact than that, but for
/// what it always adds to a turn: this is learned, for each side, and taken off. Steps forward keep
/// the yaw of the odometry: near things then move too far.
/// Source: Labrosse, "The visual compass: performance and limitations of an appearance-based
/// method", Journal of Field Robotics 2006; the search is that of Lucas and Kanade, IJCAI 1981, the
/// weights those of Geman and McClure.
/// Cost: some 1 ms a turn for 512 columns.
class VisualCompass {
 public:
  /// Whether a rig has what it needs: colour, and columns of equal angles.
  static bool Serves(const Rig& rig);

  /// Expects: a rig that it serves (checked).
  explicit VisualCompass(const Rig& rig);

  /// Forgets what it has learned.
  void Reset();

  /// The motion since the last panorama, in the frame before it. `odometry`: what it is believed to
  /// be, returned as it is for a step that is no turn, or where the panoramas do not fit or show
  /// nothing.
  sim::PlanarPose Match(const Panorama& panorama, const sim::PlanarPose& odometry);

 private:
  /// [cols, 3]: colours summed over the band's rows.
  std::vector<int> SumOfBand(const Panorama& panorama, std::size_t band) const;
  /// [bands, 3, cols]: means of neighbouring columns, 1 on average.
  std::vector<double> StripOf(const Panorama& panorama) const;
  /// What odometry's errors have in common. A turn is seen less exactly than odometry counts it but
  /// for that; what is seen of a single turn counts as much as odometry's errors differ.
  struct Habit {
    double count = 0.0;   // turns seen
    double mean = 0.0;    // radians that odometry lacks
    double square = 0.0;  // sum of the squares of what was seen off the mean

    /// Learns from a turn that was seen to be larger by `more`. Returns what odometry lacks.
    double Correct(double more);
  };
  struct Search {
    double expected = 0.0;  // columns by which all things moved, by the odometry
    double spread = 0.0;    // columns that this may be off
    double doubt = 1.0;     // the larger, the less counts what does not fit
  };
  /// By how much the body turned farther than it believes; absent if nothing fits.
  std::optional<double> TurnedMore(const std::vector<double>& now, double turned) const;
  /// One step of Gauss and Newton. `moved`: columns by which all things moved, and by which those
  /// to the left and those ahead did in addition because the body slipped. Returns whether another
  /// step would change anything.
  bool Improve(const std::vector<double>& now, const Search& search, Eigen::Vector3d* moved) const;

  std::size_t cols_;
  std::vector<std::size_t> rows_;  // where each band begins; its end is the next one's beginning
  std::vector<double> sine_;       // [cols] of a column's bearing
  std::vector<double> cosine_;
  Habit left_;
  Habit right_;
  std::vector<double> last_;  // [bands, 3, cols]; empty before the first
};

}  // namespace bulletnav::agent
