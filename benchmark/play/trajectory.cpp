// SPDX-License-Identifier: MIT
#include "benchmark/play/trajectory.h"

#include <cstdint>
#include <string_view>

#include <fmt/core.h>

#include "benchmark/base/scene_names.h"
#include "benchmark/play/belief_json.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

constexpr std::string_view kActionLetters = "SFLR";  // in the order of sim::Action

/// Fit to be a file's name, another one for each text: two results must not share a file.
std::string FileName(std::string_view text) {
  constexpr char kFirstPrinted = ' ';
  constexpr char kDeleted = '\x7f';
  std::string name;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_kept = byte >= kFirstPrinted && c != kDeleted && c != '/' && c != '%';
    name += is_kept ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return name;
}

Json ExactToJson(const sim::BodyPose& pose) {
  const Eigen::Vector3d& p = pose.position;
  return {p.x(), p.y(), p.z(), pose.yaw};
}

Json PoseToJson(const sim::BodyPose& pose) {
  const Eigen::Vector3d& p = pose.position;
  return {Rounded(p.x()), Rounded(p.y()), Rounded(p.z()), Rounded(pose.yaw)};
}

Eigen::Vector3d ReadPoint(const JsonCursor& json) {
  return {json.Item(0).Number(), json.Item(1).Number(), json.Item(2).Number()};
}

sim::BodyPose ReadPose(const JsonCursor& json) {
  json.ExpectList(4);
  return {ReadPoint(json), json.Item(3).Number()};
}

template <class T, class Read>
std::vector<T> ReadList(const JsonCursor& json, const Read& read) {
  std::vector<T> items;
  for (std::size_t i = 0; i < json.Size(); ++i) items.push_back(read(json.Item(i)));
  return items;
}

/// Writes the members that a struct shows its visitor.
struct BodyWriter {
  void operator()(const char* name, float value) { json[name] = Rounded(value); }
  void operator()(const char* name, bool value) { json[name] = value; }
  Json json = Json::object();
};

struct BodyReader {
  void operator()(const char* name, float& value) const {
    value = static_cast<float>(json.At(name).Number());
  }
  void operator()(const char* name, bool& value) const { value = json.At(name).Truth(); }
  const JsonCursor& json;
};

/// A text with one letter a step.
std::string ReadLetters(const JsonCursor& json, std::size_t steps, std::string_view letters) {
  std::string text = json.Text();
  if (text.size() != steps || text.find_first_not_of(letters) != std::string::npos) {
    json.Fail(fmt::format("expected {} letters out of {}", steps, letters));
  }
  return text;
}

std::vector<TrajectoryStep> ReadSteps(const JsonCursor& json) {
  const auto poses = ReadList<sim::BodyPose>(json.At("poses"), ReadPose);
  const auto odometry = ReadList<sim::PlanarPose>(json.At("odometry"), ReadPlanarPose);
  if (odometry.size() != poses.size()) json.At("odometry").Fail("is not as long as poses");
  const std::string actions = ReadLetters(json.At("actions"), poses.size(), kActionLetters);
  const std::string collided = ReadLetters(json.At("collided"), poses.size(), "01");
  std::vector<TrajectoryStep> steps;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    steps.push_back({static_cast<sim::Action>(kActionLetters.find(actions[i])), poses[i],
                     odometry[i], collided[i] == '1'});
  }
  return steps;
}

void WriteSteps(const std::vector<TrajectoryStep>& steps, Json* json) {
  std::string actions;
  std::string collided;
  Json poses = Json::array();
  Json odometry = Json::array();
  for (const TrajectoryStep& step : steps) {
    actions += kActionLetters[static_cast<std::size_t>(step.action)];
    collided += step.collided ? '1' : '0';
    poses.push_back(PoseToJson(step.pose));
    odometry.push_back(ToJson(step.odometry));
  }
  (*json)["actions"] = actions;
  (*json)["collided"] = collided;
  (*json)["poses"] = std::move(poses);
  (*json)["odometry"] = std::move(odometry);
}

}  // namespace

std::filesystem::path TrajectoryPath(const std::filesystem::path& run_folder,
                                     const ResultKey& key) {
  const std::string row =
      fmt::format("{}-{}-{}-{}", key.agent, key.setting, key.condition, key.seed);
  const std::string stem = std::filesystem::path(key.scene).stem().string();
  // Scans are all called alike, and their episodes 0, 1, 2.
  const std::string scene = NamesScene(key.scene, key.episode) ? stem : LongSceneName(key.scene);
  const std::string episode = fmt::format("{}-{}.json", scene, key.episode);
  return run_folder / "trajectories" / FileName(row) / FileName(episode);
}

std::string ToJson(const EpisodeTrajectory& trajectory) {
  Json json;
  json["result"] = Json::parse(ToJsonLine(trajectory.result));
  json["scene_file"] = trajectory.scene_file.string();
  json["run_seed"] = trajectory.key.run_seed;
  json["episode_number"] = trajectory.key.episode;
  json["noise"] = sim::NameOf(trajectory.noise);
  BodyWriter body;
  sim::BodySpec(trajectory.body).Visit(body);
  json["body"] = std::move(body.json);
  json["start"] = ExactToJson(trajectory.start);
  json["goals"] = Json::array();
  for (const sim::BodyPose& goal : trajectory.goals) json["goals"].push_back(ExactToJson(goal));
  json["shortest_path"] = Json::array();
  for (const Eigen::Vector3d& p : trajectory.shortest_path) {
    json["shortest_path"].push_back({Rounded(p.x()), Rounded(p.y()), Rounded(p.z())});
  }
  WriteSteps(trajectory.steps, &json);
  json["belief"] = ToJson(trajectory.belief);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

EpisodeTrajectory ReadTrajectory(const std::filesystem::path& file) {
  const Json document = ParseJson(sim::ReadTextFile(file), file);
  const JsonCursor json(document, file, "");
  EpisodeTrajectory trajectory;
  trajectory.result = FromJsonLine(json.At("result").value().dump(), file, 1);
  trajectory.scene_file = json.At("scene_file").Text();
  trajectory.key = {json.At("run_seed").Whole(), json.At("episode_number").Whole()};
  trajectory.noise = json.At("noise").Enum<sim::NoiseMode>();
  const JsonCursor body = json.At("body");
  BodyReader reader{body};
  trajectory.body.Visit(reader);
  trajectory.start = ReadPose(json.At("start"));
  trajectory.goals = ReadList<sim::BodyPose>(json.At("goals"), ReadPose);
  trajectory.shortest_path =
      ReadList<Eigen::Vector3d>(json.At("shortest_path"), [](const JsonCursor& point) {
        point.ExpectList(3);
        return ReadPoint(point);
      });
  trajectory.steps = ReadSteps(json);
  trajectory.belief = ReadBelief(json.At("belief"));
  return trajectory;
}

}  // namespace bulletnav::bench
