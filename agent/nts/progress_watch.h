// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::agent {

/// Notices that something that is walked to does not come nearer.
class ProgressWatch {
 public:
  /// `patience`: steps; `least`: metres that count as coming nearer.
  ProgressWatch(int patience, double least) : patience_(patience), least_(least) {}

  /// Forgets what was walked to.
  void Reset() { is_on_ = false; }

  /// To be called every step with a number that tells apart what is walked to, and how far off it
  /// is. True if patience is at an end; then it begins anew.
  bool IsStuck(int target, double distance);

 private:
  int patience_;
  double least_;
  bool is_on_ = false;
  int target_ = 0;
  double best_ = 0.0;
  int steps_ = 0;
};

}  // namespace bulletnav::agent
