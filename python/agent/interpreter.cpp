// SPDX-License-Identifier: MIT
#include "python/agent/interpreter.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <pthread.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace bulletnav::python {
namespace {

namespace py = pybind11;

void Initialize() {
  PyConfig config;
  PyConfig_InitPythonConfig(&config);
  config.install_signal_handlers = 0;
  // Else the first python3 in PATH, perhaps of another version, would say where modules are.
  PyStatus status =
      PyConfig_SetBytesString(&config, &config.program_name, BULLETNAV_PYTHON_EXECUTABLE);
  if (PyStatus_Exception(status) == 0) status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  if (PyStatus_Exception(status) != 0) {
    throw std::runtime_error(std::string("Python cannot be started: ") +
                             (status.err_msg != nullptr ? status.err_msg : "no reason given"));
  }
}

const std::string& Version() {
  static const std::string version =
      std::to_string(PY_MAJOR_VERSION) + "." + std::to_string(PY_MINOR_VERSION);
  return version;
}

/// Where the active virtual environment has modules for this interpreter; empty if none is active.
std::filesystem::path SiteFolder() {
  const char* const environment = std::getenv("VIRTUAL_ENV");
  if (environment == nullptr || *environment == '\0') return {};
  return std::filesystem::path(environment) / "lib" / ("python" + Version()) / "site-packages";
}

void FindModules() {
  const auto path = py::module_::import("sys").attr("path");
  const std::filesystem::path site = SiteFolder();
  if (!site.empty()) py::module_::import("site").attr("addsitedir")(site.string());
  path.attr("insert")(0, std::filesystem::current_path().string());
}

/// A child of an agent's that never comes back would hold the lock of the folder of results.
void EndWithParent() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
}

/// os._exit in an agent would end the run without a word; children that it has forked may.
void GuardExit() {
  const py::module_ os = py::module_::import("os");
  const py::object leave = os.attr("_exit");
  const pid_t run = ::getpid();
  os.attr("_exit") = py::cpp_function([leave, run](const py::object& status) {
    if (::getpid() != run) leave(status);
    PyErr_SetString(PyExc_SystemExit, "os._exit, which would end the whole run");
    throw py::error_already_set();
  });
}

bool Start() {
  Initialize();
  ::pthread_atfork(nullptr, nullptr, &EndWithParent);
  FindModules();
  GuardExit();
  // What crashes in C code is told with Python's traceback before the process ends.
  py::module_::import("faulthandler").attr("enable")();
  PyEval_SaveThread();
  return true;
}

}  // namespace

void StartInterpreter() {
  static const bool is_started = Start();
  static_cast<void>(is_started);
}

std::string OtherPythonNote() {
  const std::filesystem::path site = SiteFolder();
  if (site.empty() || std::filesystem::exists(site)) return "";
  return "; VIRTUAL_ENV is not of Python " + Version() +
         ", which agents in Python run in: make one with " BULLETNAV_PYTHON_EXECUTABLE
         " -m venv FOLDER";
}

std::string Traceback(const py::error_already_set& error) {
  try {
    const py::object trace = error.trace() ? error.trace() : py::none();  // none if C raised it
    const auto lines = py::module_::import("traceback")
                           .attr("format_exception")(error.type(), error.value(), trace);
    auto text = py::str("").attr("join")(lines).cast<std::string>();
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
  } catch (const py::error_already_set&) {
    return error.what();  // An exception that cannot even be shown.
  }
}

std::string Place(const py::error_already_set& error) {
  if (!error.trace()) return "";
  try {
    const py::list frames = py::module_::import("traceback").attr("extract_tb")(error.trace());
    if (frames.empty()) return "";
    const py::object last = frames[frames.size() - 1];
    const auto file = last.attr("filename").cast<std::string>();
    return file + ":" + py::str(last.attr("lineno")).cast<std::string>();
  } catch (const py::error_already_set&) {
    return "";
  }
}

std::string LastLine(const std::string& text) {
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace bulletnav::python
