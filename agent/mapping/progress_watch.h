// SPDX-License-Identifier: MIT
#pragma once
#include <map>

namespace bulletnav::agent {

/// Notices that something that is walked to does not come nearer. Targets are told apart by number
/// and remembered when another is walked to for a while, so that wavering is noticed too; the way
/// back counts as coming nearer, and so does floor that is seen for the first time: a way round
/// something long comes no nearer for a while, but it shows what is there.
class ProgressWatch {
 public:
  /// `patience`: steps; `least`: metres that count as coming nearer.
  ProgressWatch(int patience, double least) : patience_(patience), least_(least) {}

  void Reset() { targets_.clear(); }
  void Forget(int target);

  /// To be called every step with what is walked to and how far off it is; `seen`: m2 of floor seen
  /// so far, which only grows. True if patience with it is at an end; then it begins anew.
  bool IsStuck(int target, double distance, double seen = 0.0);

 private:
  struct Target {
    double nearest = 0.0;
    double seen = 0.0;
    int steps = 0;  // since then
  };

  int patience_;
  double least_;
  std::map<int, Target> targets_;
  int last_ = 0;
};

}  // namespace bulletnav::agent
