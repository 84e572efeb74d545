// SPDX-License-Identifier: MIT
#include "benchmark/training/curves.h"

#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

#include <fmt/core.h>

#include "benchmark/report/chart.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

std::string Join(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) {
    if (!line.empty()) line += ',';
    line += field;
  }
  line += '\n';
  return line;
}

struct NameWriter {
  std::vector<std::string> fields;
  void operator()(std::string_view name, double) { fields.emplace_back(name); }
};

struct ValueWriter {
  std::vector<std::string> fields;
  void operator()(std::string_view, int value) { fields.push_back(std::to_string(value)); }
  void operator()(std::string_view, double value) {
    fields.push_back(fmt::format("{:.6g}", value));
  }
};

/// Takes the fields of a line one after the other.
struct ValueReader {
  std::string_view rest;
  bool ok = true;

  template <class T>
  void operator()(std::string_view, T& value) {
    const std::size_t length = std::min(rest.find(','), rest.size());
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + length, value);
    ok = ok && error == std::errc() && end == rest.data() + length;
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
};

std::string NameLine() {
  NameWriter names;
  CurvePoint().Visit(names);
  return Join(names.fields);
}

/// Steps a unit of the axis: 1, 10, 100... so that at most twenty are left.
int UnitFor(int last_step) {
  int unit = 1;
  while (last_step / unit > 20) unit *= 10;
  return unit;
}

}  // namespace

Curves::Curves(std::filesystem::path file, int last_step) : file_(std::move(file)) {
  if (last_step == 0 || !std::filesystem::exists(file_)) return;
  std::istringstream text(sim::ReadTextFile(file_));
  std::string line;
  std::getline(text, line);
  if (line + "\n" != NameLine()) {
    throw sim::FileError(file_, "1", "has not the columns that this program writes; remove it");
  }
  for (int number = 2; std::getline(text, line); ++number) {
    CurvePoint point;
    ValueReader reader{line};
    point.Visit(reader);
    if (!reader.ok || !reader.rest.empty()) {
      throw sim::FileError(file_, std::to_string(number), "is not a line of numbers; remove it");
    }
    if (point.step <= last_step) points_.push_back(point);
  }
}

void Curves::Append(const CurvePoint& point) {
  points_.push_back(point);
  std::string text = NameLine();
  for (CurvePoint& each : points_) {
    ValueWriter values;
    each.Visit(values);
    text += Join(values.fields);
  }
  sim::WriteFileAtomically(file_, text);
}

Figure CurvesFigure(const std::vector<CurvePoint>& points) {
  const int unit = UnitFor(points.empty() ? 0 : points.back().step);
  Chart chart;
  chart.x_label = unit == 1 ? "steps" : fmt::format("steps / {}", unit);
  chart.y_label = "share right, validation";
  const auto add = [&](const std::string& name, double NtsMetrics::*metric) {
    Chart::Series series{name, {}};
    for (const CurvePoint& point : points) {
      const double y = point.validation.*metric;
      series.values.push_back({static_cast<double>(point.step) / unit, y, {y, y}});
    }
    chart.series.push_back(series);
  };
  add("same node (guessing: 0.5)", &NtsMetrics::connection);
  add("goal's twelfth (guessing: 0.08)", &NtsMetrics::direction);
  add("explorable (guessing: 0.5)", &NtsMetrics::explorable);
  add("best way within 1 m", &NtsMetrics::score_choice);
  return ChartFigure({&chart, 1});
}

}  // namespace bulletnav::bench
