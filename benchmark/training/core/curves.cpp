// SPDX-License-Identifier: MIT
#include "benchmark/training/core/curves.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "benchmark/report/chart.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

constexpr std::array<const char*, 3> kFirstNames = {"step", "rate", "train_loss"};

std::vector<std::string> Split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

template <class T>
bool ToNumber(const std::string& field, T* value) {
  const char* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, *value);
  return error == std::errc() && stop == end;
}

std::string NameLine(const CurvePoint& point) {
  std::string line = fmt::format("{}", fmt::join(kFirstNames, ","));
  for (const Measures::Item& item : point.validation.items()) line += "," + item.name;
  return line + "\n";
}

std::string ValueLine(const CurvePoint& point) {
  std::string line = fmt::format("{},{:.6g},{:.6g}", point.step, point.rate, point.train_loss);
  for (const Measures::Item& item : point.validation.items()) {
    line += fmt::format(",{:.6g}", item.value);
  }
  return line + "\n";
}

/// Absent if the line is not one of numbers with these names.
std::optional<CurvePoint> PointOf(const std::vector<std::string>& names, const std::string& line) {
  const std::vector<std::string> fields = Split(line);
  CurvePoint point;
  if (fields.size() != names.size() || fields.size() < kFirstNames.size()) return std::nullopt;
  bool ok = ToNumber(fields[0], &point.step) && ToNumber(fields[1], &point.rate) &&
            ToNumber(fields[2], &point.train_loss);
  for (std::size_t i = kFirstNames.size(); i < fields.size(); ++i) {
    double value = 0.0;
    ok = ok && ToNumber(fields[i], &value);
    point.validation(names[i], value);
  }
  return ok ? std::optional(point) : std::nullopt;
}

}  // namespace

Curves::Curves(std::filesystem::path file, int last_step) : file_(std::move(file)) {
  if (last_step == 0 || !std::filesystem::exists(file_)) return;
  std::istringstream text(sim::ReadTextFile(file_));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string> names = Split(line);
  for (int number = 2; std::getline(text, line); ++number) {
    const std::optional<CurvePoint> point = PointOf(names, line);
    if (!point) {
      throw sim::FileError(file_, std::to_string(number), "is not a line of numbers; remove it");
    }
    if (point->step <= last_step) points_.push_back(*point);
  }
}

void Curves::Append(const CurvePoint& point) {
  const std::string names = NameLine(point);
  if (!points_.empty() && NameLine(points_.front()) != names) {
    throw sim::FileError(file_, "1", "has not the columns that this program writes; remove it");
  }
  points_.push_back(point);
  std::string text = names;
  for (const CurvePoint& each : points_) text += ValueLine(each);
  sim::WriteFileAtomically(file_, text);
}

Figure CurvesFigure(const std::vector<CurvePoint>& points, const std::vector<CurveLine>& lines,
                    const std::string& label) {
  Chart chart;
  chart.x_label = "steps";
  chart.y_label = label;
  for (const CurveLine& line : lines) {
    Chart::Series series{line.title, {}};
    for (const CurvePoint& point : points) {
      const double y = point.validation.at(line.measure);
      chart.top = std::max(chart.top, RoundTop(y));
      series.values.push_back({static_cast<double>(point.step), y, {y, y}});
    }
    chart.series.push_back(series);
  }
  return ChartFigure({&chart, 1});
}

}  // namespace bulletnav::bench
