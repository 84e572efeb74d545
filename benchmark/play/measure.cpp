// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// Filled before main by the registrations and only read after that.
std::vector<Measure>& Registered() {
  static std::vector<Measure> measures;
  return measures;
}

const Measure* Find(std::string_view name) {
  for (const Measure& measure : Registered()) {
    if (measure.name == name) return &measure;
  }
  return nullptr;
}

bool ComesBefore(const Measure& a, const Measure& b) {
  return std::tie(a.place, a.name) < std::tie(b.place, b.name);
}

}  // namespace

bool IsNear(double distance, const GoalRecord& record, const SuccessRule& rule) {
  return !record.failed && (record.stopped || rule.no_stop) && distance < rule.distance;
}

double Directness(const GoalRecord& record) {
  const double longer = std::max(record.start_distance, record.path_length);
  return longer > 0.0 ? record.start_distance / longer : 1.0;
}

std::span<const Measure> AllMeasures() {
  return Registered();
}

std::vector<Measure> MainMeasures() {
  std::vector<Measure> main;
  std::copy_if(Registered().begin(), Registered().end(), std::back_inserter(main),
               [](const Measure& measure) {
                 return measure.is_main();
               });
  return main;
}

const Measure& FindMeasure(std::string_view name) {
  if (const Measure* found = Find(name)) return *found;
  std::string known;
  for (const Measure& measure : Registered()) {
    known.append(known.empty() ? "" : ", ").append(measure.name);
  }
  throw sim::Error("unknown measure '" + std::string(name) + "'; known are: " + known);
}

MeasureRegistration::MeasureRegistration(const Measure& measure) {
  BULLETNAV_CHECK(!measure.name.empty() && measure.value != nullptr);
  if (Find(measure.name) != nullptr) {
    throw sim::Error("two measures are called '" + std::string(measure.name) + "'");
  }
  auto& all = Registered();
  all.insert(std::upper_bound(all.begin(), all.end(), measure, ComesBefore), measure);
}

}  // namespace bulletnav::bench
