// SPDX-License-Identifier: MIT
#include "python/agent/guarded_call.h"
#include "python/agent/interpreter.h"
#include "python/agent/make_agent.h"
#include "python/agent/module_sources.h"
#include "python/core/array.h"

#include <algorithm>
#include <stdexcept>

#include <pybind11/pybind11.h>
#include <unistd.h>

#include "sim/base/error.h"

namespace bulletnav::python {
namespace {

namespace py = pybind11;

/// Where the class Array is, in this interpreter.
void BindOnce() {
  static PyModuleDef definition;
  static const bool is_bound = [] {
    auto module = py::module_::create_extension_module("bulletnav_agent", nullptr, &definition);
    BindArray(&module);
    module.release();  // NOLINT(bugprone-unused-return-value): it stays
    return true;
  }();
  static_cast<void>(is_bound);
}

/// None where there is no numpy.
py::object Numpy() {
  try {
    return py::module_::import("numpy");
  } catch (py::error_already_set& e) {
    if (!e.matches(PyExc_ImportError)) throw;
    return py::none();
  }
}

/// A numpy array where there is numpy.
py::object Show(Array array) {
  py::object shown = py::cast(std::move(array));
  const py::object numpy = Numpy();
  return numpy.is_none() ? shown : numpy.attr("asarray")(shown);
}

py::object Copy(const sim::ArraySpec& spec, std::span<const std::byte> bytes) {
  Array array = MakeArray(spec);
  std::copy_n(bytes.begin(), std::min(bytes.size(), spec.bytes()), array.data);
  return Show(std::move(array));
}

py::dict Told(const agent::Rig& rig) {
  py::dict told;
  told["rows"] = rig.panorama.rows;
  told["cols"] = rig.panorama.cols;
  told["projection"] = std::string(sim::NameOf(rig.panorama.projection));
  told["max_depth_m"] = rig.panorama.max_depth_m;
  told["has_color"] = rig.has_color;
  told["has_depth"] = rig.has_depth;
  told["camera_height"] = rig.camera_height;
  told["body_radius"] = rig.body_radius;
  told["body_height"] = rig.body_height;
  return told;
}

/// An object of the user's class. Whatever it raises becomes a C++ exception; the interpreter's
/// lock is held in here alone.
class PythonAgent final : public PythonLane {
 public:
  PythonAgent(const std::string& name, const std::string& options,
              const agent::AgentContext& context)
      : rig_(context.rig) {
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos) {
      throw sim::FileError(name, "", "an agent's module must be MODULE:CLASS, as in mine:MyAgent");
    }
    StartInterpreter();
    const pid_t process = ::getpid();
    const py::gil_scoped_acquire lock;
    try {
      BindOnce();
      Numpy();  // now, where no clock runs: it takes a while
      const std::string module = name.substr(0, colon);
      const py::object made =
          py::module_::import(module.c_str()).attr(name.substr(colon + 1).c_str());
      own_ = made(Told(rig_), py::module_::import("json").attr("loads")(options));
      EndChild(process);
      for (const char* call : {"reset", "act"}) py::getattr(own_, call);
      sources_ = ModuleSources(module);
    } catch (const py::error_already_set& e) {
      EndChild(process);
      own_.release().dec_ref();
      const std::string place = Place(e);
      throw sim::FileError(name, "",
                           "this agent cannot be built: " + LastLine(Traceback(e)) +
                               (place.empty() ? "" : " (" + place + ")") + OtherPythonNote());
    }
  }

  ~PythonAgent() override {  // NOLINT(bugprone-exception-escape): taking the lock throws nothing
    const pid_t process = ::getpid();
    const py::gil_scoped_acquire lock;
    own_.release().dec_ref();
    EndChild(process);
  }
  PythonAgent(const PythonAgent&) = delete;
  PythonAgent& operator=(const PythonAgent&) = delete;
  PythonAgent(PythonAgent&&) = delete;
  PythonAgent& operator=(PythonAgent&&) = delete;

  void Reset(const agent::Panorama& goal, std::uint64_t seed) override {
    call_.Run([&] {
      own_.attr("reset")(Seen(goal), seed);
    });
  }

  void NextGoal(const agent::Panorama& goal, std::uint64_t seed) override {
    call_.Run([&] {
      own_.attr(py::hasattr(own_, "next_goal") ? "next_goal" : "reset")(Seen(goal), seed);
    });
  }

  sim::Action Act(const agent::Observation& observation) override {
    auto action = sim::Action::kStop;
    call_.Run([&] {
      py::dict seen;
      for (const sim::ArrayView& array : observation.arrays) {
        seen[py::str(array.spec().name)] = Copy(array.spec(), array.bytes());
      }
      seen["step"] = observation.step;
      action = Read(own_.attr("act")(seen));
    });
    return action;
  }

  std::optional<double> busy_s() const override { return call_.busy_s(); }
  void Interrupt() override { call_.Interrupt(); }
  std::vector<std::filesystem::path> sources() const override { return sources_; }

 private:
  static sim::Action Read(const py::object& answer) {
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(answer.ptr()));
    if (number) {
      const long value = PyLong_AsLong(number.ptr());
      if (value >= 0 && value < static_cast<long>(sim::kAllActions.size())) {
        return static_cast<sim::Action>(value);
      }
    }
    PyErr_Clear();
    throw std::runtime_error(
        "act answered " + py::repr(answer).cast<std::string>() +
        ", which is no action; 0: stop, 1: move forward, 2: turn left, 3: turn "
        "right");
  }

  py::dict Seen(const agent::Panorama& goal) const {
    // Goals are panoramas, unless the rig has a word of them.
    const sim::ArraySpec* picture = rig_.FindArray("goal.color");
    const int rows = picture == nullptr ? rig_.panorama.rows : picture->shape[0];
    const int cols = picture == nullptr ? rig_.panorama.cols : picture->shape[1];
    py::dict told;
    if (!goal.color.empty()) {
      told["color"] = Copy({"goal.color", {rows, cols, 3}, sim::Element::kUint8, "display value"},
                           std::as_bytes(goal.color));
    }
    if (!goal.depth.empty()) {
      told["depth"] = Copy({"goal.depth", {rows, cols}, sim::Element::kFloat32, "m"},
                           std::as_bytes(goal.depth));
    }
    return told;
  }

  agent::Rig rig_;
  GuardedCall call_;
  py::object own_;
  std::vector<std::filesystem::path> sources_;
};

}  // namespace
}  // namespace bulletnav::python

extern "C" __attribute__((visibility("default"))) void BulletnavMakePythonAgent(
    const std::string& module, const std::string& options,
    const bulletnav::agent::AgentContext& context,
    std::unique_ptr<bulletnav::python::PythonLane>* made) {
  *made = std::make_unique<bulletnav::python::PythonAgent>(module, options, context);
}
