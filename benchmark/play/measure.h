// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>
#include <vector>

namespace bulletnav::bench {

/// When an episode counts as a success.
struct SuccessRule {
  double distance = 1.0;  // metres; nearer than this
  /// The "no stop" condition: being near is enough, at any step, and a stop does nothing. Else the
  /// agent must stop there.
  bool no_stop = false;
};

/// What happened on the way to one goal: the facts that measures are made of.
struct GoalRecord {
  double start_distance = 0.0;      // d0: geodesic metres; finite and not negative (checked)
  double distance_to_goal = 0.0;    // d: geodesic metres at the end; infinite off the goal's island
  double euclidean_distance = 0.0;  // metres at the end
  double path_length = 0.0;         // L: metres really moved
  bool stopped = false;             // the agent said so, before the steps ran out
  int steps = 0;
  int collisions = 0;
  bool failed = false;  // the agent was taken off; such a goal is never reached
};

/// Whether the goal was reached, if `distance` was left: near enough, and stopped there.
bool IsNear(double distance, const GoalRecord& record, const SuccessRule& rule);
/// d0 / max(d0, L): how much of the way was needed; 1 where none was and none was gone.
double Directness(const GoalRecord& record);

/// How a measure's values look in files. kRealOrInfinite: infinity is written as null.
enum class MeasureKind { kYesNo, kWhole, kReal, kRealOrInfinite };
/// What an episode of several goals counts with. kMeanOfReached: an episode in which no goal was
/// reached does not count at all.
enum class OverGoals { kMean, kSum, kMeanOfReached };
/// The columns of files keep their places, so new ones come after those of the paper's figures.
enum class ColumnPlace { kBeforePaper, kAfterPaper };

/// Something measured of each goal of an episode. A measure is a file in benchmark/play/measures/
/// that ends with a MeasureRegistration; results, summaries, tables, charts and comparisons find it
/// by themselves. All texts must outlive the program's main, as literals do.
struct Measure {
  std::string_view name;  // key in episodes.jsonl; of letters, digits and underscores
  double (*value)(const GoalRecord& record, const SuccessRule& rule) = nullptr;
  MeasureKind kind = MeasureKind::kReal;
  int place = 1000;  // order in a line of results and among columns; equal ones by name
  OverGoals over_goals = OverGoals::kMean;
  std::string_view if_infinite = {};  // the measure that means take instead of an infinite value
  std::string_view column = {};       // in summary.json and table.csv: a mean; empty: none
  ColumnPlace column_place = ColumnPlace::kAfterPaper;
  /// A main measure, in [0, 1] (checked), has a 95% interval (Wilson's of shares of single goals,
  /// else bootstrapped over episodes), charts with this label and a line in comparisons. Empty: it
  /// is none.
  std::string_view label = {};
  std::string_view table_title = {};  // its columns in tables, one a difficulty; empty: none
  std::string_view table_head = {};  // if given: one column alone, of all episodes, under this head

  bool is_main() const { return !label.empty(); }
};

/// All measures, in the order of their places.
std::span<const Measure> AllMeasures();
std::vector<Measure> MainMeasures();
/// Throws sim::Error for an unknown name, with the known ones.
const Measure& FindMeasure(std::string_view name);

/// Makes a measure known. One constant of this type at the end of the measure's file does it.
/// Throws sim::Error if the name is taken.
class MeasureRegistration {
 public:
  explicit MeasureRegistration(const Measure& measure);
};

}  // namespace bulletnav::bench
