// SPDX-License-Identifier: MIT
#include "python/agent/module_sources.h"

#include <pybind11/pybind11.h>

namespace bulletnav::python {
namespace {

namespace py = pybind11;

constexpr const char* kFind = R"py(
import os, sys, sysconfig

def file_of(module):
    file = getattr(module, "__file__", None)
    return os.path.abspath(file) if isinstance(file, str) else None

def sources(name):
    own, top = file_of(sys.modules[name]), sys.modules[name.partition(".")[0]]
    if own is None:
        return []
    folder = os.path.dirname(file_of(top) or own)
    files = {own}
    installed = ("site-packages", "dist-packages")
    if hasattr(top, "__path__") or os.path.basename(folder) not in installed:
        outside = [os.path.join(folder, name) + os.sep for name in installed]
        outside += [sysconfig.get_path(name) + os.sep for name in ("stdlib", "platstdlib")]
        for file in map(file_of, list(sys.modules.values())):
            if (file and file.startswith(folder + os.sep) and os.path.exists(file)
                    and not any(file.startswith(path) for path in outside)
                    and not any(os.sep + name + os.sep in file[len(folder):] for name in installed)):
                files.add(file)
    return [own] + sorted(files - {own})
)py";

}  // namespace

std::vector<std::filesystem::path> ModuleSources(const std::string& module) {
  py::dict scope;
  scope["__builtins__"] = py::module_::import("builtins");
  py::reinterpret_steal<py::object>(PyRun_String(kFind, Py_file_input, scope.ptr(), scope.ptr()));
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  std::vector<std::filesystem::path> files;
  for (const py::handle file : scope["sources"](module)) {
    files.emplace_back(file.cast<std::string>());
  }
  return files;
}

}  // namespace bulletnav::python
