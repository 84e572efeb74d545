// SPDX-License-Identifier: MIT
#include "benchmark/cli/hand_over.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <unistd.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// OpenBLAS reads these when it is loaded. Its threads only get into the way of ours and can hang
/// when two of ours fork at once, as imports of scenes do. Debian 12's takes processors that are
/// newer than it for ones without AVX-512.
void SetUpOpenBlas() {
  constexpr int kKeep = 0;  // what the user has set
  ::setenv("OPENBLAS_NUM_THREADS", "1", kKeep);
#if defined(__x86_64__)
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
  if (has_avx512) ::setenv("OPENBLAS_CORETYPE", "SkylakeX", kKeep);
#endif
}

}  // namespace

void HandOverToLearn() {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::string program = self.parent_path() / "bulletnav-learn";
  std::ifstream file("/proc/self/cmdline");
  std::string words((std::istreambuf_iterator<char>(file)), {});  // each ends in a zero
  std::vector<char*> arguments;
  for (std::size_t at = 0; at < words.size(); at += std::strlen(&words[at]) + 1) {
    arguments.push_back(&words[at]);
  }
  arguments.push_back(nullptr);
  SetUpOpenBlas();
  ::execv(program.c_str(), arguments.data());
  throw sim::FileError(program, "",
                       std::string("cannot be started: ").append(std::strerror(errno)));
}

}  // namespace bulletnav::bench
