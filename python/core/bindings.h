// SPDX-License-Identifier: MIT
#pragma once
#include <pybind11/pybind11.h>

namespace bulletnav::python {

/// Adds what bulletnav/vector_env.py is made of.
void BindLanes(pybind11::module_* module);

/// Likewise scene.py.
void BindScene(pybind11::module_* module);

/// Likewise episodes.py and results.py.
void BindFiles(pybind11::module_* module);

}  // namespace bulletnav::python
