// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "benchmark/report/canvas.h"

namespace bulletnav::bench {

inline constexpr double kSideColumnWidth = 205.0;  // units of the canvas
inline constexpr double kSignWidth = 26.0;         // of a sign in a legend

/// What a sign in a picture means. `draw` gets the middle of the sign's place.
struct LegendEntry {
  std::string text;
  std::function<void(const Canvas::Point&, Canvas*)> draw;
};

/// The column of text, colour bar and legend beside a map, from the top down. Lines that are too
/// long are printed a little smaller or broken into lines.
class SideColumn {
 public:
  /// `corner`: the upper left one. The canvas must outlive the column.
  SideColumn(const Canvas::Point& corner, Canvas* canvas) : at_(corner), canvas_(canvas) {}

  void Title(const std::string& text);
  void Line(const std::string& text);
  void Gap() { at_.y() += 8.0; }
  /// The colours of time against steps.
  void TimeBar(int steps);
  void Entry(const LegendEntry& entry);
  double bottom() const { return at_.y(); }

 private:
  /// Broken where it would become too small.
  std::vector<std::string> Lines(const std::string& text, double size, bool bold) const;
  double FittingSize(const std::string& text, double size, bool bold) const;
  void TextAt(double x, const std::string& text);

  Canvas::Point at_;
  Canvas* canvas_;
};

}  // namespace bulletnav::bench
