// SPDX-License-Identifier: MIT
// {agent: python, parameters: {module: mine:MyAgent}} in a run config. Python is in a library of
// its own, which is loaded when it is asked for.
#include "python/agent/make_agent.h"

#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "agent/registry.h"
#include "benchmark/cli/library.h"

namespace bulletnav::bench {
namespace {

// Extension modules of Python look for libpython among what everybody sees.
constexpr ProgramLibrary kLibrary = {python::kPythonLibrary, "agents in Python", "BULLETNAV_PYTHON",
                                     RTLD_GLOBAL};

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

/// An agent that the user has written in Python; see python/agent/make_agent.h.
class PythonAgent final : public agent::Agent {
 public:
  static constexpr std::string_view kName = "python";

  struct Config {
    std::string module;                    // "mine:MyAgent"
    std::optional<sim::YamlNode> options;  // what its class is built with
    template <class V>
    void Visit(V& v) {
      v.Required("module", module);
      v("options", options);
    }
  };

  PythonAgent(const Config& config, const agent::AgentContext& context) {
    static python::MakePythonAgent* const make = FindFunction<python::MakePythonAgent>(
        kLibrary, OpenLibrary(kLibrary), python::kMakePythonAgent);
    const nlohmann::json options =
        config.options ? ToJson(config.options->yaml()) : nlohmann::json::object();
    make(config.module, options.dump(), context, &own_);
  }

  void Reset(const agent::Panorama& goal, std::uint64_t seed) override { own_->Reset(goal, seed); }
  void NextGoal(const agent::Panorama& goal, std::uint64_t seed) override {
    own_->NextGoal(goal, seed);
  }
  sim::Action Act(const agent::Observation& observation) override { return own_->Act(observation); }

 private:
  std::unique_ptr<agent::Agent> own_;
};

const agent::AgentRegistration<PythonAgent> registration;

}  // namespace
}  // namespace bulletnav::bench
