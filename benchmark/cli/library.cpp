// SPDX-License-Identifier: MIT
#include "benchmark/cli/library.h"

#include <cstdlib>
#include <filesystem>

namespace bulletnav::bench {

void* OpenLibrary(const ProgramLibrary& library) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path file = program.parent_path() / library.file;
  if (!std::filesystem::exists(file)) {
    throw sim::Error(std::string("this program was built without ") + library.what + ": " +
                     file.string() + " is not there; in a checkout, unless with " + library.option +
                     "=OFF, this builds it: ./bulletnav " + library.command + " --help");
  }
  // What libraries log of their own comes before, and says less than, this program's one line.
  ::setenv("GLOG_minloglevel", "3", 0);
  void* open = ::dlopen(file.c_str(), RTLD_NOW | library.mode);
  if (open == nullptr) throw sim::FileError(file, "", ::dlerror());
  return open;
}

}  // namespace bulletnav::bench
