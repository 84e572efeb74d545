// SPDX-License-Identifier: MIT
#include "python/core/arguments.h"
#include "python/core/bindings.h"

#include <pybind11/stl.h>

#include "benchmark/episodes/episode_file.h"
#include "benchmark/episodes/episode_json.h"
#include "benchmark/episodes/generator.h"
#include "benchmark/play/trajectory.h"
#include "benchmark/runs/result_store.h"

namespace bulletnav::python {
namespace {

namespace py = pybind11;

std::vector<std::string> Told(const std::vector<bench::Episode>& episodes) {
  std::vector<std::string> told;
  told.reserve(episodes.size());
  for (const bench::Episode& episode : episodes) {
    told.push_back(bench::EpisodeToJson(episode).dump());
  }
  return told;
}

std::vector<std::string> Draw(const std::string& config, int workers) {
  const auto spec = ReadArguments<bench::GeneratorSpec>(config);
  return Told(bench::GenerateEpisodes(spec, bench::ScenesOf(spec), workers));
}

/// `text`: a list of episodes as JSON, checked as one in `file` would be.
void Write(const std::string& file, const std::string& text) {
  const bench::Json json = bench::ParseJson(text, file);
  bench::EpisodeSet set;
  set.episodes.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string name = "episodes[" + std::to_string(i) + "]";
    set.episodes.push_back(bench::EpisodeFromJson({json[i], file, name}));
  }
  bench::RequireUniqueIds(set.episodes, file);
  bench::WriteEpisodes(file, set);
}

std::vector<std::string> Results(const std::string& folder) {
  std::vector<std::string> lines;
  for (const bench::EpisodeResult& result : bench::ReadResults(folder)) {
    lines.push_back(bench::ToJsonLine(result));
  }
  return lines;
}

py::list Measures() {
  py::list measures;
  for (const bench::Measure& measure : bench::AllMeasures()) {
    py::dict facts;
    facts["name"] = measure.name;
    facts["label"] = measure.label;
    facts["column"] = measure.column;
    measures.append(facts);
  }
  return measures;
}

}  // namespace

void BindFiles(py::module_* module) {
  const auto unlocked = py::call_guard<py::gil_scoped_release>();
  module->def("draw_episodes", &Draw, unlocked);
  module->def("write_episodes", &Write, unlocked);
  module->def(
      "read_episodes",
      [](const std::string& file) {
        return Told(bench::ReadEpisodes(file).episodes);
      },
      unlocked);
  module->def("read_results", &Results, unlocked);
  module->def(
      "read_trajectory",
      [](const std::string& file) {
        return bench::ToJson(bench::ReadTrajectory(file));
      },
      unlocked);
  module->def("measures", &Measures);
}

}  // namespace bulletnav::python
