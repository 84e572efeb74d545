// SPDX-License-Identifier: MIT
#include "benchmark/cli/learning.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <dlfcn.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kLibrary = "bulletnav-learning.so";

/// OpenBLAS reads these when it is loaded. Its threads only get in the way of ours. Debian 12's
/// takes processors that are newer than it for ones without AVX-512.
void SetUpOpenBlas() {
  constexpr int kKeep = 0;  // what the user has set
  ::setenv("OPENBLAS_NUM_THREADS", "1", kKeep);
#if defined(__x86_64__)
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
  if (has_avx512) ::setenv("OPENBLAS_CORETYPE", "SkylakeX", kKeep);
#endif
}

void* OpenLibrary() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path file = program.parent_path() / kLibrary;
  if (!std::filesystem::exists(file)) {
    throw sim::Error("this program was built without learning (BULLETNAV_LEARNING=OFF): " +
                     file.string() + " is not there");
  }
  SetUpOpenBlas();
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) throw sim::FileError(file, "", ::dlerror());
  return library;
}

void* Library() {
  static void* const library = OpenLibrary();
  return library;
}

}  // namespace

void LoadLearning() {
  Library();
}

int RunLearningCommand(int argc, char** argv) {
  using Run = int(int, char**);
  const auto run = reinterpret_cast<Run*>(::dlsym(Library(), "BulletnavRunLearningCommand"));
  if (run == nullptr) throw sim::Error(std::string(kLibrary) + ": " + ::dlerror());
  return run(argc, argv);
}

}  // namespace bulletnav::bench
