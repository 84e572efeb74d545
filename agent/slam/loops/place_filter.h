// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace bulletnav::agent {

struct PlaceFilterSpec {
  double new_after_new = 0.9;  // that a new place follows on a new place
  double new_after_old = 0.1;  // that a new place follows on a known one
  /// That the body is 0, 1, ... places further on or back; as shares of what is left, in the
  /// proportions given.
  std::vector<double> moves = {0.36,    0.30,    0.16,   0.062,  0.0151,
                               0.00255, 3.24e-4, 2.5e-5, 1.3e-6, 4.8e-8};

  template <class V>
  void Visit(V& v) {
    v("new_after_new", new_after_new);
    v("new_after_old", new_after_old);
    v("moves", moves);
  }
  void Validate() const;
};

/// How likely each of the places so far, and a new one, are where the body is: a Bayes filter over
/// frames, with a virtual place that stands for all that is new.
/// Source: Labbe and Michaud, "Appearance-based loop closure detection for online large-scale and
/// long-term operation", T-RO 2013, section III-B; settings of RTAB-Map.
class PlaceFilter {
 public:
  /// Throws sim::Error if the spec is bad.
  explicit PlaceFilter(const PlaceFilterSpec& spec);

  /// Moves on by a frame and weighs by how like it each place is, at least 0; places follow on each
  /// other in time. There may be more places than before, not fewer (checked).
  void Update(std::span<const double> likeness);

  double new_place() const { return new_place_; }
  std::span<const double> places() const { return places_; }

 private:
  void Predict(std::size_t places);

  PlaceFilterSpec spec_;
  double new_place_ = 1.0;
  std::vector<double> places_;
};

}  // namespace bulletnav::agent
