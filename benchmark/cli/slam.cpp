// SPDX-License-Identifier: MIT
#include "benchmark/cli/slam.h"

#include <filesystem>
#include <string>

#include <dlfcn.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kLibrary = "bulletnav-slam.so";

void* OpenLibrary() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path file = program.parent_path() / kLibrary;
  if (!std::filesystem::exists(file)) {
    throw sim::Error("this program was built without SLAM (BULLETNAV_SLAM=OFF): " + file.string() +
                     " is not there");
  }
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw sim::FileError(file, "", ::dlerror());
  return library;
}

}  // namespace

int RunSlamCommand(int argc, char** argv) {
  using Run = int(int, char**);
  const auto run = reinterpret_cast<Run*>(::dlsym(OpenLibrary(), "BulletnavRunSlamCommand"));
  if (run == nullptr) throw sim::Error(std::string(kLibrary) + ": " + ::dlerror());
  return run(argc, argv);
}

}  // namespace bulletnav::bench
