// SPDX-License-Identifier: MIT
// bulletnav-import: reads a mesh for ImportScene, in a process of its own, because a damaged file
// may crash or hang the libraries that read it. Not for users. Compiled a second time, with
// BULLETNAV_READS_SDF, as bulletnav-import-sdf: libsdformat takes 0.1 s to start, which other
// scenes shall not wait for.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/import/cpu_time.h"
#include "sim/import/gazebo_world.h"
#include "sim/import/mesh_io.h"
#include "sim/import/read_scene.h"
#include "sim/scene/import_program.h"
#include "sim/scene/mesh_blob.h"

namespace {

using namespace bulletnav::sim;

constexpr int kImportSeconds = 10;
constexpr rlim_t kImportMemory = rlim_t{16} << 30;

void Limit(const std::filesystem::path& file) {
  LimitCpuSeconds(kImportSeconds + SecondsToRead(file));
  // A crash is an answer here, not an event: no core file.
  const rlimit none = {0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
#ifndef __SANITIZE_ADDRESS__  // its shadow memory is larger than any limit
  rlimit memory{};
  ::getrlimit(RLIMIT_AS, &memory);
  memory.rlim_cur = std::min(kImportMemory, memory.rlim_max);
  ::setrlimit(RLIMIT_AS, &memory);
#endif
}

/// The standard output, which libraries then no longer can write to.
int TakeOutput() {
  const int output = ::dup(STDOUT_FILENO);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
  return output;
}

bool Write(int output, const void* data, std::size_t size) {
  const auto* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t n = ::write(output, at, size);
    if (n <= 0) return false;
    at += n;
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

/// Ends the process without destructors: the scene is large, and all has been said.
[[noreturn]] void Answer(int output, const void* data, std::size_t size, ImportEnd end) {
  const bool is_written = Write(output, data, size) && Write(output, &end, sizeof(end));
  ::_exit(is_written ? 0 : 1);
}

[[noreturn]] void AnswerText(int output, const char* text) {
  if (*text == '\0') text = "fails without saying why";
  Answer(output, text, std::strlen(text), ImportEnd::kError);
}

#ifdef BULLETNAV_READS_SDF
ImportedScene Read(const ImportRequest& request, char** /*arguments*/, int /*output*/) {
  return ReadScene(request.file, ReadGazeboWorld(request.file), request.options);
}
#else
/// Goes on as the program that reads Gazebo's worlds, which lies beside this one.
void BecomeSdfReader(const std::filesystem::path& world, char** arguments, int output) {
  std::error_code ignored;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", ignored).string() + "-sdf";
  ::dup2(output, STDOUT_FILENO);
  ::unsetenv("HOME");  // where libsdformat would leave a log
  ::execv(program.c_str(), arguments);
  throw bulletnav::sim::FileError(
      world, "",
      "is a world of Gazebo's, which this build does not read; configure BulletNav with "
      "-DBULLETNAV_SDF=ON (Debian's libsdformat-dev) and build it again");
}

ImportedScene Read(const ImportRequest& request, char** arguments, int output) {
  if (IsGazeboWorld(request.file)) BecomeSdfReader(request.file, arguments, output);
  return ReadScene(request.file, request.options);
}
#endif

}  // namespace

int main(int argc, char** argv) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int output = TakeOutput();
  try {
    const ImportRequest request = FromArguments({argv + 1, static_cast<std::size_t>(argc - 1)});
    Limit(request.file);
    const std::vector<std::uint8_t> blob = ToBlob(Read(request, argv, output));
    Answer(output, blob.data(), blob.size(), ImportEnd::kScene);
  } catch (const std::bad_alloc&) {
    Answer(output, nullptr, 0, ImportEnd::kTooLarge);
  } catch (const std::exception& e) {
    AnswerText(output, e.what());
  }
}
