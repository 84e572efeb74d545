// SPDX-License-Identifier: MIT
#include "agent/mapping/visual_compass.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Cholesky>

#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::agent {
namespace {

constexpr int kBands = 8;
constexpr double kTwoPi = 2.0 * sim::kPi;
constexpr double kLowest = -0.6;  // tangents of the elevations between which it looks
constexpr double kHighest = 0.6;
constexpr int kRounds = 4;                         // of each kind
constexpr double kSettled = 0.01;                  // columns: less is no change
constexpr double kOnTheSpot = 0.1;                 // metres; a step of more is no turn
constexpr double kLeastTurn = sim::DegToRad(2.0);  // less is a push against something
constexpr double kTurned = sim::DegToRad(1.0);     // how far the odometry of a turn may be off
constexpr double kMostOff = sim::DegToRad(4.0);
constexpr double kSeen = sim::DegToRad(0.25);  // how well it sees a turn
constexpr double kFirstTurns = 2.0;  // what odometry is believed before the first turn, in turns
constexpr double kFirstSquares = 4.0;
constexpr double kNearest = 1.0;     // metres: what slipping is seen by
constexpr double kSlip = 0.02;       // metres
constexpr double kAlike = 0.1;       // of neighbouring columns' noise, how much is their own
constexpr double kNearThings = 1.0;  // how soon what does not fit counts less, at first,
constexpr double kStrictly = 25.0;   // and in the end: what is left fits then

/// Whether not all columns are alike. [lines, cols]
bool HasDetail(const std::vector<double>& strip, std::size_t cols) {
  for (auto line = strip.begin(); line != strip.end(); line += static_cast<std::ptrdiff_t>(cols)) {
    const auto end = line + static_cast<std::ptrdiff_t>(cols);
    if (std::adjacent_find(line, end, std::not_equal_to<>()) != end) return true;
  }
  return false;
}

}  // namespace

bool VisualCompass::Serves(const Rig& rig) {
  return rig.has_color && rig.panorama.projection != sim::Projection::kCubeStrip;
}

VisualCompass::VisualCompass(const Rig& rig) : cols_(static_cast<std::size_t>(rig.panorama.cols)) {
  BULLETNAV_CHECK(Serves(rig));
  const sim::RayGrid rays(rig.panorama);
  std::vector<std::size_t> seen;
  const double flat = std::hypot(static_cast<double>(rays.x[0]), static_cast<double>(rays.z[0]));
  for (std::size_t r = 0; r < rays.y.size(); ++r) {
    const double tangent = static_cast<double>(rays.y[r]) / flat;
    if (tangent > kLowest && tangent < kHighest) seen.push_back(r);
  }
  const std::size_t bands = std::min<std::size_t>(kBands, seen.size());
  for (std::size_t b = 0; b <= bands; ++b) rows_.push_back(seen.front() + b * seen.size() / bands);
  for (std::size_t c = 0; c < cols_; ++c) {
    const double bearing =
        sim::kPi - kTwoPi * (static_cast<double>(c) + 0.5) / static_cast<double>(cols_);
    sine_.push_back(sim::Sin(bearing));
    cosine_.push_back(sim::Cos(bearing));
  }
}

std::vector<int> VisualCompass::SumOfBand(const Panorama& panorama, std::size_t band) const {
  std::vector<int> sums(3 * cols_);
  for (std::size_t r = rows_[band]; r < rows_[band + 1]; ++r) {
    const auto row = panorama.color.subspan(r * 3 * cols_, 3 * cols_);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += row[i];
  }
  return sums;
}

std::vector<double> VisualCompass::StripOf(const Panorama& panorama) const {
  BULLETNAV_CHECK(panorama.color.size() >= 3 * rows_.back() * cols_);
  const std::size_t bands = rows_.size() - 1;
  std::vector<double> strip(bands * 3 * cols_);
  double all = 0.0;
  for (std::size_t b = 0; b < bands; ++b) {
    const std::vector<int> sums = SumOfBand(panorama, b);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const std::size_t c = i / 3;
      const std::size_t k = i % 3;
      const int before = sums[3 * ((c + cols_ - 1) % cols_) + k];
      const int after = sums[3 * ((c + 1) % cols_) + k];
      double& value = strip[(b * 3 + k) * cols_ + c];
      value = static_cast<double>(before + 2 * sums[i] + after) /
              static_cast<double>(rows_[b + 1] - rows_[b]);
      all += value;
    }
  }
  // Exposure may have changed.
  const double scale = all > 0.0 ? static_cast<double>(strip.size()) / all : 0.0;
  for (double& value : strip) value *= scale;
  return strip;
}

bool VisualCompass::Improve(const std::vector<double>& now, const Search& search,
                            Eigen::Vector3d* moved) const {
  std::vector<std::size_t> left(cols_);
  std::vector<double> part(cols_);
  const auto cols = static_cast<double>(cols_);
  for (std::size_t c = 0; c < cols_; ++c) {
    double at =
        static_cast<double>(c) + (*moved)[0] + (*moved)[1] * sine_[c] + (*moved)[2] * cosine_[c];
    at -= std::floor(at / cols) * cols;
    left[c] = std::min(static_cast<std::size_t>(at), cols_ - 1);
    part[c] = at - static_cast<double>(left[c]);
  }
  std::vector<double> off(now.size());
  double square = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const std::size_t line = i / cols_ * cols_;
    const std::size_t c = i - line;
    const double a = now[line + left[c]];
    const double b = now[line + (left[c] + 1) % cols_];
    off[i] = a + part[c] * (b - a) - last_[i];
    square += off[i] * off[i];
  }
  square /= static_cast<double>(now.size());
  if (!(square > 0.0)) return false;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const std::size_t line = i / cols_ * cols_;
    const std::size_t c = i - line;
    const std::size_t k = left[c];
    const double here = now[line + (k + 1) % cols_] - now[line + (k + cols_ - 1) % cols_];
    const double next = now[line + (k + 2) % cols_] - now[line + k];
    const double slope = 0.5 * (here + part[c] * (next - here));
    const double weight = kAlike / (square + search.doubt * off[i] * off[i]);
    const Eigen::Vector3d by(slope, slope * sine_[c], slope * cosine_[c]);
    normal += weight * by * by.transpose();
    right -= weight * off[i] * by;
  }
  const double known = 1.0 / (search.spread * search.spread);
  const double per_metre = cols / kTwoPi / kNearest;
  const double slip = 1.0 / (kSlip * per_metre * kSlip * per_metre);
  normal(0, 0) += known;
  normal(1, 1) += slip;
  normal(2, 2) += slip;
  right[0] -= known * ((*moved)[0] - search.expected);
  right[1] -= slip * (*moved)[1];
  right[2] -= slip * (*moved)[2];
  const Eigen::Vector3d change = normal.ldlt().solve(right);
  *moved += change;
  return std::fabs(change[0]) > kSettled;
}

std::optional<double> VisualCompass::TurnedMore(const std::vector<double>& now,
                                                double turned) const {
  if (!HasDetail(now, cols_) || !HasDetail(last_, cols_)) return std::nullopt;
  const double per_radian = static_cast<double>(cols_) / kTwoPi;
  const double expected = turned * per_radian;
  Eigen::Vector3d moved(expected, 0.0, 0.0);
  for (const double doubt : {kNearThings, kStrictly}) {
    for (int i = 0; i < kRounds; ++i) {
      if (!Improve(now, {expected, kTurned * per_radian, doubt}, &moved)) break;
    }
  }
  const double more = (moved[0] - expected) / per_radian;
  if (std::fabs(more) > kMostOff) return std::nullopt;
  return more;
}

double VisualCompass::Habit::Correct(double more) {
  count += 1.0;
  const double off = more - mean;
  mean += off / (count + kFirstTurns);
  square += off * off;
  const double all = (square + kFirstSquares * kSeen * kSeen) / (count + kFirstSquares);
  const double gain = std::max(0.0, 1.0 - kSeen * kSeen / all);
  return mean + gain * (more - mean);
}

void VisualCompass::Reset() {
  last_.clear();
  left_ = {};
  right_ = {};
}

sim::PlanarPose VisualCompass::Match(const Panorama& panorama, const sim::PlanarPose& odometry) {
  if (panorama.color.empty()) {
    last_.clear();
    return odometry;
  }
  std::vector<double> now = StripOf(panorama);
  const bool is_turn =
      std::fabs(odometry.yaw) >= kLeastTurn && std::hypot(odometry.x, odometry.y) <= kOnTheSpot;
  double yaw = odometry.yaw;
  if (!last_.empty() && is_turn) {
    const std::optional<double> more = TurnedMore(now, odometry.yaw);
    if (more) yaw += (odometry.yaw > 0.0 ? left_ : right_).Correct(*more);
  }
  last_ = std::move(now);
  return {odometry.x, odometry.y, yaw};
}

}  // namespace bulletnav::agent
