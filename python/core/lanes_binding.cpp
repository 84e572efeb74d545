// SPDX-License-Identifier: MIT
#include "python/core/array.h"
#include "python/core/batch_speed.h"
#include "python/core/bindings.h"
#include "python/core/lanes.h"

#include <pybind11/stl.h>

#include "benchmark/episodes/episode_json.h"

namespace bulletnav::python {
namespace {

namespace py = pybind11;
using bench::VectorEnvironment;

/// Nobody but the environment writes there while it is used as it should; what Python writes is
/// lost with the next step.
std::byte* Writable(std::span<const std::byte> memory) {
  return const_cast<std::byte*>(memory.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

std::vector<Array> Observed(Lanes& lanes) {
  return lanes.View([&](const VectorEnvironment& environment) {
    std::vector<Array> arrays;
    arrays.reserve(environment.arrays().size());
    for (std::size_t i = 0; i < environment.arrays().size(); ++i) {
      const sim::ArraySpec& spec = environment.arrays()[i];
      std::vector<py::ssize_t> shape = {environment.lanes()};
      shape.insert(shape.end(), spec.shape.begin(), spec.shape.end());
      arrays.push_back({lanes.environment(), Writable(environment.memory(i)), std::move(shape),
                        DtypeOf(spec.element), spec.name, spec.units});
    }
    return arrays;
  });
}

template <class T>
Array OfLanes(const Lanes& lanes, std::span<const T> values, Dtype type, const char* name) {
  return {lanes.environment(),
          Writable(std::as_bytes(values)),
          {static_cast<py::ssize_t>(values.size())},
          type,
          name,
          ""};
}

/// Rewards, terminated, truncated: [lanes] each.
std::vector<Array> Outcome(Lanes& lanes) {
  return lanes.View([&](const VectorEnvironment& environment) -> std::vector<Array> {
    return {OfLanes(lanes, environment.rewards(), Dtype::kFloat64, "reward"),
            OfLanes(lanes, environment.terminated(), Dtype::kBool, "terminated"),
            OfLanes(lanes, environment.truncated(), Dtype::kBool, "truncated")};
  });
}

std::vector<std::pair<int, std::string>> Finished(Lanes& lanes) {
  return lanes.View([](const VectorEnvironment& environment) {
    std::vector<std::pair<int, std::string>> finished;
    for (const VectorEnvironment::Finished& one : environment.finished()) {
      finished.emplace_back(one.lane, bench::ToJsonLine(one.result));
    }
    return finished;
  });
}

void RequireLane(const VectorEnvironment& environment, int lane) {
  if (lane >= 0 && lane < environment.lanes()) return;
  throw sim::Error("there is no lane " + std::to_string(lane) + "; lanes go from 0 to " +
                   std::to_string(environment.lanes() - 1));
}

std::string EpisodeOf(Lanes& lanes, int lane) {
  return lanes.View([&](const VectorEnvironment& environment) {
    RequireLane(environment, lane);
    return bench::EpisodeToJson(environment.episode(lane)).dump();
  });
}

std::array<double, 4> Numbers(const sim::BodyPose& pose) {
  return {pose.position.x(), pose.position.y(), pose.position.z(), pose.yaw};
}

/// Pose and goal of a lane: x, y, z in metres, yaw in radians; geodesic metres between them.
std::tuple<std::array<double, 4>, std::array<double, 4>, double> Truth(Lanes& lanes, int lane) {
  return lanes.View([&](const VectorEnvironment& environment) {
    RequireLane(environment, lane);
    const bench::GroundTruth& truth = environment.truth(lane);
    const sim::NavmeshQuery query(truth.world->navmesh());
    return std::tuple(Numbers(truth.pose), Numbers(truth.goal),
                      query.GeodesicDistance(truth.pose.position.cast<float>(),
                                             truth.goal.position.cast<float>()));
  });
}

/// A UserWarning; what filters make an error of is shown and does not end the episode.
void WarnInPython(const std::string& line) {
  const py::gil_scoped_acquire locked;
  if (PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0) PyErr_WriteUnraisable(nullptr);
}

}  // namespace

void BindLanes(py::module_* module) {
  const auto unlocked = py::call_guard<py::gil_scoped_release>();
  py::class_<Lanes>(*module, "Lanes")
      .def(py::init([](const std::string& config) {
             return std::make_unique<Lanes>(config, WarnInPython);
           }),
           unlocked)
      .def("reset", &Lanes::Reset, unlocked)
      .def("reset_lanes", &Lanes::ResetLanes, unlocked)
      .def("step", &Lanes::Step, unlocked)
      .def("send", &Lanes::Send, unlocked)
      .def("recv", &Lanes::Receive, unlocked)
      .def("close", &Lanes::Close, unlocked)
      .def_property_readonly("closed", &Lanes::is_closed)
      .def_property_readonly("num_envs",
                             [](const Lanes& lanes) {
                               return lanes.config().num_envs;
                             })
      .def_property_readonly("max_depth_m",
                             [](const Lanes& lanes) {
                               return lanes.config().task().panorama.max_depth_m;
                             })
      .def_property_readonly("autoreset_mode",
                             [](const Lanes& lanes) {
                               return std::string(sim::NameOf(lanes.config().autoreset_mode));
                             })
      .def("observed", &Observed)
      .def("outcome", &Outcome)
      .def("finished", &Finished)
      .def("episode", &EpisodeOf)
      .def("truth", &Truth)
      .def(
          "batch_seconds",
          [](Lanes& lanes, const std::vector<std::vector<std::int64_t>>& actions,
             std::size_t warm_up) {
            return BatchSeconds(&lanes, actions, warm_up);
          },
          unlocked);
}

}  // namespace bulletnav::python
