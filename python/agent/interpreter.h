// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <pybind11/pybind11.h>

namespace bulletnav::python {

/// Starts Python in this process, once, and lets go of its lock. Modules are found in the current
/// folder, in PYTHONPATH and in the active virtual environment. Never ended: the process does that.
/// Its forked children end with the thread that forked them. Throws std::runtime_error if Python
/// cannot be started.
void StartInterpreter();

/// "; VIRTUAL_ENV ... is not of Python 3.11 ..." if the active virtual environment is of another
/// version than this interpreter; else empty.
std::string OtherPythonNote();

/// Traceback and message of what Python raised. The lock must be held.
std::string Traceback(const pybind11::error_already_set& error);
/// Where it was raised: "mine.py:12", empty if that is not in Python. The lock must be held.
std::string Place(const pybind11::error_already_set& error);
/// Its last line.
std::string LastLine(const std::string& text);

}  // namespace bulletnav::python
