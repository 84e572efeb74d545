// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <dlfcn.h>

#include "sim/base/error.h"

namespace bulletnav::bench {

/// A library beside the program that is loaded when it is asked for, and stays.
struct ProgramLibrary {
  const char* file;     // its name, as "bulletnav-slam.so"
  const char* what;     // it is for, as "SLAM"
  const char* option;   // of CMake, without which it is not built
  const char* command;  // of the launcher that builds it in a checkout
  int mode;             // RTLD_GLOBAL or RTLD_LOCAL: who sees its names
};

/// Throws sim::Error if the program was built without it, FileError if it cannot be loaded.
void* OpenLibrary(const ProgramLibrary& library);

/// A function of an open library. Throws sim::Error if it is not there.
template <class Function>
Function* FindFunction(const ProgramLibrary& library, void* open, const char* name) {
  const auto function = reinterpret_cast<Function*>(::dlsym(open, name));
  if (function == nullptr) throw sim::Error(std::string(library.file) + ": " + ::dlerror());
  return function;
}

}  // namespace bulletnav::bench
