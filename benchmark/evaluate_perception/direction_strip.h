// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "agent/models/semantic_model.h"
#include "benchmark/report/canvas.h"
#include "benchmark/report/palette.h"

namespace bulletnav::bench {

inline constexpr Paint kSaid = kBlue;    // what the model says, in all pictures
inline constexpr Paint kTruth = kGreen;  // what is true
inline constexpr Paint kPale = {0.80, 0.84, 0.88};

/// A panorama of ExampleScene and rows of bars beneath it, a twelfth of the width for each
/// direction.
class DirectionStrip {
 public:
  static constexpr int kCells = agent::kDirections;

  DirectionStrip(double left, double width, Canvas* canvas)
      : left_(left), width_(width), canvas_(canvas) {}

  double left() const { return left_; }
  double right() const { return left_ + width_; }
  double cell() const { return width_ / kCells; }
  double panorama_height() const { return 0.25 * width_; }
  /// Middle of a direction's cell.
  double At(int direction) const;
  /// Of any bearing, radians counter-clockwise from straight ahead.
  double AtBearing(double bearing) const;

  void Panorama(const sim::Image& image, double top) const;
  /// "ahead", "30°", ... under or over a panorama.
  void Bearings(double y) const;
  /// Lines at 0, 0.5 and 1 of bars in a row from `top` down, and what they mean, at the left.
  void Axis(const std::string& label, double top, double height) const;
  /// `side`: -1 left half of the cell, 1 right half, 0 all of it.
  void Bar(int direction, double value, double top, double height, int side,
           const Paint& paint) const;
  /// A box around a direction of a panorama.
  void Box(int direction, double top, double inset, const Stroke& stroke) const;

 private:
  double left_;
  double width_;
  Canvas* canvas_;
};

/// An arrowhead that points up, its tip at `tip`.
void DrawTip(const Canvas::Point& tip, double size, const Paint& paint, Canvas* canvas);
/// A line with a head at its end.
void DrawArrow(const Canvas::Point& from, const Canvas::Point& to, const Stroke& stroke,
               Canvas* canvas);

}  // namespace bulletnav::bench
