// SPDX-License-Identifier: MIT
#pragma once
#include <pybind11/pybind11.h>

namespace bulletnav::python {

/// Adds what bulletnav/vector_env.py is made of.
void BindLanes(pybind11::module_* module);

}  // namespace bulletnav::python
