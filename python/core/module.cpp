// SPDX-License-Identifier: MIT
// The extension bulletnav._core: thin, texts (JSON) where Python has readers of its own.
#include "python/core/array.h"
#include "python/core/bindings.h"

#include <pybind11/stl.h>

#include "benchmark/base/program_version.h"
#include "benchmark/episodes/made_houses.h"
#include "sim/base/error.h"

namespace bulletnav::python {
namespace {

namespace py = pybind11;

/// `kind`: empty for homes as they are made where no kind is named.
std::vector<std::string> Generate(const std::string& folder, int count, std::uint64_t first_seed,
                                  int workers, const std::string& kind) {
  bench::HousesSpec houses;
  houses.folder = folder;
  houses.count = count;
  houses.first_seed = first_seed;
  if (!kind.empty()) houses.parts = {sim::SetPart{.kind = kind, .count = count}};
  houses.Validate();
  bench::MakeHouses(houses, bench::CommittedVersion(), workers, [](const std::string&, int) {
    return [] {};
  });
  std::vector<std::string> files;
  for (const auto& file : bench::FilesOf(houses)) files.push_back(file.string());
  return files;
}

/// Later ones are asked first.
void BindErrors(py::module_* module) {
  const auto& error = py::register_exception<sim::Error>(*module, "Error");
  error.attr("__doc__") =
      "What you can mend: the message is one line that names the file, the place in it, what is "
      "wrong and the remedy.";
  py::register_exception<sim::FileError>(*module, "FileError", error).attr("__doc__") =
      "Bad content of a file.";
  py::register_exception<sim::PoseError>(*module, "PoseError", error).attr("__doc__") =
      "A pose that a body cannot have: inside something, or above no floor.";
  py::register_exception<sim::RenderError>(*module, "RenderError", error).attr("__doc__") =
      "No usable renderer.";
}

}  // namespace

PYBIND11_MODULE(_core, module) {  // NOLINT
  module.doc() = "BulletNav's simulator and benchmark; use the package bulletnav.";
  module.attr("__version__") = bench::ProgramVersion();
  BindErrors(&module);
  BindArray(&module);
  BindLanes(&module);
  BindScene(&module);
  BindFiles(&module);
  module.def("generate", &Generate, py::arg("folder"), py::arg("count"), py::arg("first_seed"),
             py::arg("workers"), py::arg("kind"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace bulletnav::python
