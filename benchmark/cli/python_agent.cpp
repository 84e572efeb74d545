// SPDX-License-Identifier: MIT
// {agent: python, parameters: {module: mine:MyAgent}} in a run config. Python is in a library of
// its own, which is loaded when it is asked for.
#include "python/agent/make_agent.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "agent/foreign_agent.h"
#include "agent/registry.h"
#include "benchmark/cli/library.h"

namespace bulletnav::bench {
namespace {

// Extension modules of Python look for libpython among what everybody sees.
constexpr ProgramLibrary kLibrary = {python::kPythonLibrary, "agents in Python", "BULLETNAV_PYTHON",
                                     "run", RTLD_GLOBAL};

nlohmann::json ToJson(const YAML::Node& node) {
  if (node.IsMap()) {
    nlohmann::json map = nlohmann::json::object();
    for (const auto& item : node) map[item.first.as<std::string>()] = ToJson(item.second);
    return map;
  }
  if (node.IsSequence()) {
    nlohmann::json list = nlohmann::json::array();
    for (const YAML::Node& item : node) list.push_back(ToJson(item));
    return list;
  }
  if (!node.IsScalar()) return nullptr;
  const auto text = node.as<std::string>();
  if (node.Tag() == "!") return text;  // in quotes
  if (bool truth = false; YAML::convert<bool>::decode(node, truth)) return truth;
  const auto value = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  return value.is_number() ? value : nlohmann::json(text);
}

/// Agents that the user has written in Python, one a lane; see python/agent/make_agent.h.
class PythonAgent final : public agent::BatchAgent, public agent::ForeignAgent {
 public:
  static constexpr std::string_view kName = "python";

  struct Config {
    std::string module;                    // "mine:MyAgent"
    std::optional<sim::YamlNode> options;  // what its class is built with
    double time_limit_s = 60.0;            // for an answer; see agent::ForeignAgent
    template <class V>
    void Visit(V& v) {
      v.Required("module", module);
      v("options", options);
      v("time_limit_s", time_limit_s);
    }
    void Validate() const {
      if (time_limit_s >= 0.1) return;
      throw sim::Error("time_limit_s must be 0.1 or more");
    }
  };

  PythonAgent(const Config& config, std::span<const agent::AgentContext> contexts)
      : time_limit_s_(config.time_limit_s) {
    static python::MakePythonAgent* const make = FindFunction<python::MakePythonAgent>(
        kLibrary, OpenLibrary(kLibrary), python::kMakePythonAgent);
    const nlohmann::json options =
        config.options ? ToJson(config.options->yaml()) : nlohmann::json::object();
    lanes_.resize(contexts.size());
    for (std::size_t i = 0; i < contexts.size(); ++i) {
      make(config.module, options.dump(), contexts[i], &lanes_[i]);
    }
  }

  int lanes() const override { return static_cast<int>(lanes_.size()); }
  void Reset(int lane, const agent::Panorama& goal, std::uint64_t seed) override {
    at(lane).Reset(goal, seed);
  }
  void NextGoal(int lane, const agent::Panorama& goal, std::uint64_t seed) override {
    at(lane).NextGoal(goal, seed);
  }
  void Act(std::span<const agent::LaneObservation> observations,
           std::span<sim::Action> actions) override {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      actions[i] = at(observations[i].lane).Act(observations[i].observation);
    }
  }

  double time_limit_s() const override { return time_limit_s_; }
  std::optional<agent::ForeignCall> busy() const override {
    for (int lane = 0; lane < lanes(); ++lane) {
      const auto seconds = lanes_[static_cast<std::size_t>(lane)]->busy_s();
      if (seconds) return agent::ForeignCall{lane, *seconds};
    }
    return std::nullopt;
  }
  void Interrupt() override {
    for (const auto& lane : lanes_) {
      if (lane->busy_s()) lane->Interrupt();
    }
  }
  std::vector<std::filesystem::path> sources() const override { return lanes_.at(0)->sources(); }

 private:
  python::PythonLane& at(int lane) { return *lanes_.at(static_cast<std::size_t>(lane)); }

  double time_limit_s_;
  std::vector<std::unique_ptr<python::PythonLane>> lanes_;
};

const agent::AgentRegistration<PythonAgent> registration;

}  // namespace
}  // namespace bulletnav::bench
