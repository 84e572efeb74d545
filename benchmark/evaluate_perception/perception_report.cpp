// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_report.h"

#include <cmath>

#include <fmt/core.h>

#include "benchmark/base/json_visitor.h"

namespace bulletnav::bench {
namespace {

using Json = JsonVisitor::Json;

Json DataJson(const DataConfig& data) {
  Json json = {{"scenes", data.scenes}};
  if (data.houses) json["houses"] = {{"index", data.houses->index}, {"split", data.houses->split}};
  json["points"] = data.points;
  json["seed"] = data.seed;
  return json;
}

std::string Number(double value, int digits = 3) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

std::string WithInterval(const MeanFigure& figure, int digits = 3) {
  if (!std::isfinite(figure.interval.low)) return Number(figure.value, digits);
  return fmt::format("{} ({} to {})", Number(figure.value, digits),
                     Number(figure.interval.low, digits), Number(figure.interval.high, digits));
}

std::string Line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string Heads(const std::vector<std::string>& heads) {
  std::string text = Line(heads) + "|---|";
  for (std::size_t i = 1; i < heads.size(); ++i) text += "---:|";
  return "\n" + text + "\n";
}

std::string ConnectionText(const ConnectionFigures& f) {
  std::string text = fmt::format("\n## Connection: {} ordered pairs\n", f.pairs);
  text += Heads({"Figure", "Value", "Guessing"});
  text += Line({"average precision", Number(f.average_precision), Number(f.prevalence)});
  text += Line({"balanced accuracy", Number(f.at.balanced_accuracy), "0.500"});
  text += Line({"accuracy", Number(f.at.accuracy), Number(1.0 - f.prevalence)});
  text += Line({fmt::format("precision from probability {}", f.at.threshold),
                Number(f.at.precision), Number(f.prevalence)});
  text += Line({"recall", Number(f.at.recall), ""});
  return text;
}

std::string BinsText(const char* head, const std::vector<ConnectionBin>& bins) {
  std::string text = Heads({head, "Pairs", "Of one node", "Accuracy", "Recall", "False positives"});
  for (const ConnectionBin& bin : bins) {
    text += Line({bin.bin, std::to_string(bin.accuracy.count), std::to_string(bin.recall.count),
                  WithInterval(bin.accuracy), WithInterval(bin.recall),
                  WithInterval(bin.false_positive_rate)});
  }
  return text;
}

std::string ThresholdsText(const std::vector<YesNoFigures>& rows) {
  std::string text = Heads({"Yes from", "Precision", "Recall", "False positives", "F1"});
  for (const YesNoFigures& row : rows) {
    text += Line({Number(row.threshold, 2), Number(row.precision), Number(row.recall),
                  Number(row.false_positive_rate, 4), Number(row.f1)});
  }
  return text;
}

std::string ExplorableText(const ExplorableFigures& f) {
  std::string text = fmt::format("\n## Explorable directions: {}\n", f.directions);
  text += Heads({"Figure", "Value", "Guessing"});
  text += Line({"F1", Number(f.at.f1), Number(f.f1_of_yes) + " (always yes)"});
  text += Line({"precision", Number(f.at.precision), Number(f.prevalence)});
  text += Line({"recall", Number(f.at.recall), ""});
  text += Line({"average precision", Number(f.average_precision), Number(f.prevalence)});
  return text + ThresholdsText(f.thresholds);
}

std::string RelativePoseText(const RelativePoseFigures& f) {
  const auto& all = f.all;
  std::string text =
      fmt::format("\n## Relative pose: {} pairs of one node\n", all.direction_exact.count);
  text += Heads({"Figure", "Value", "Guessing"});
  text += Line({"direction exact", WithInterval(all.direction_exact), Number(1.0 / 12.0)});
  text += Line({"direction within one", WithInterval(all.direction_near), Number(3.0 / 12.0)});
  text += Line({"bearing error, degrees", WithInterval(all.bearing_error, 1), "90.0"});
  text += Line({"distance error, m", WithInterval(all.distance_error),
                Number(f.distance_error_of_median) + " (median)"});
  text += Line({"error of the place, m", WithInterval(all.place_error), ""});
  text += Heads({"Distance, m", "Pairs", "Exact", "Within one", "Distance error, m"});
  for (const auto& bin : f.by_distance) {
    text += Line({bin.bin, std::to_string(bin.means.direction_exact.count),
                  WithInterval(bin.means.direction_exact), WithInterval(bin.means.direction_near),
                  WithInterval(bin.means.distance_error)});
  }
  return text;
}

std::string ChoiceLine(const char* name, const ChoiceFigures& f) {
  return Line({name, WithInterval(f.best), WithInterval(f.within_1m), WithInterval(f.extra_m, 2)});
}

std::string ScoreText(const ScoreFigures& f) {
  std::string text = fmt::format("\n## Scores: {} pairs of two nodes\n", f.pairs);
  text += Heads({"Figure", "Value", "Guessing"});
  text += Line({"error, all directions", WithInterval(f.error), ""});
  text += Line({"error, explorable directions", WithInterval(f.error_explorable),
                Number(f.error_of_mean.value) + " (mean)"});
  text += Line({"rank correlation in a place", WithInterval(f.rank_in_place), "0.000"});
  text += Line({"rank correlation for a goal", WithInterval(f.rank_for_goal), "0.000"});
  text += Line({"rank correlation overall", Number(f.rank_overall), "0.000"});
  text += fmt::format("\nChoice among explorable directions, {} times:\n", f.model.best.count);
  text += Heads({"Chosen by", "Best", "Within 1 m of the best", "Metres lost"});
  text += ChoiceLine("model", f.model);
  text += ChoiceLine("chance", f.chance);
  text += ChoiceLine("farthest floor in sight", f.reach);
  text += ChoiceLine("straight line to the goal, which the model does not know", f.straight);
  return text;
}

std::string ScenesText(const std::vector<PerceptionFigures::Scene>& scenes) {
  std::string text =
      "\n## Scenes\n" + Heads({"Scene", "Connection AP", "False positives 3-5 m", "Explorable F1",
                               "Direction within one", "Distance error, m", "Choice within 1 m"});
  for (const auto& s : scenes) {
    text += Line({s.scene, Number(s.connection_ap), Number(s.false_positives_3_to_5m),
                  Number(s.explorable_f1), Number(s.direction_near), Number(s.distance_error),
                  Number(s.choice_within_1m)});
  }
  return text;
}

}  // namespace

std::string ToJson(const PerceptionFigures& figures, const PerceptionConfig& config,
                   const PerceptionSource& source) {
  Json json = {{"weights", source.weights},
               {"weights_hash", source.weights_hash},
               {"program", source.program},
               {"data", DataJson(config.data)}};
  PerceptionFigures copy = figures;  // structs list their members to be changed
  json.update(JsonVisitor::ToJson(copy));
  return json.dump(1) + "\n";
}

std::string ToMarkdown(const PerceptionFigures& figures, const PerceptionConfig& config,
                       const PerceptionSource& source) {
  std::string text = "# What the learned functions know\n\n";
  text += fmt::format("Weights `{}` ({}), {} scenes, {} places, seed {}.\n", source.weights,
                      source.weights_hash, figures.scenes.size(), figures.places, config.data.seed);
  text += "In brackets: 95% confidence, over scenes.\n";
  text += ConnectionText(figures.connection);
  text += BinsText("Distance, m", figures.connection.by_distance);
  text += BinsText("Walls between", figures.connection.by_walls);
  text += BinsText("Walls between, within 3 m", figures.connection.by_walls_near);
  text += ThresholdsText(figures.connection.thresholds);
  text += ExplorableText(figures.explorable);
  text += RelativePoseText(figures.relative_pose);
  text += ScoreText(figures.score);
  return text + ScenesText(figures.scenes);
}

}  // namespace bulletnav::bench
