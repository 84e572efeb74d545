// SPDX-License-Identifier: MIT
#include "sim/scene/run_program.h"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;  // and is there to report
#else
constexpr bool kIsSanitized = false;
#endif

[[noreturn]] void Fail(const std::filesystem::path& program, int error) {
  throw Error(program.string() + " cannot be run: " + std::strerror(error));
}

/// Memory that is written as a file is.
class MemoryFile {
 public:
  explicit MemoryFile(const std::filesystem::path& program)
      : fd_(::memfd_create("bulletnav", MFD_CLOEXEC)) {
    if (fd_ < 0) Fail(program, errno);
  }
  ~MemoryFile() { ::close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  MemoryFile(MemoryFile&&) = delete;
  MemoryFile& operator=(MemoryFile&&) = delete;

  int fd() const { return fd_; }

  /// For munmap to give back.
  std::span<const std::uint8_t> Map() const {
    struct stat status = {};
    ::fstat(fd_, &status);
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size == 0) return {};
    void* const at = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, fd_, 0);
    if (at == MAP_FAILED) throw std::bad_alloc();
    return {static_cast<const std::uint8_t*>(at), size};
  }

 private:
  int fd_;
};

/// How a program is to be started.
class SpawnPlan {
 public:
  explicit SpawnPlan(int output) {
    ::posix_spawn_file_actions_init(&files_);
    ::posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
    if (!kIsSanitized) {
      ::posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
    // Whatever the host blocks or ignores is no business of the program's.
    sigset_t signals;
    ::posix_spawnattr_init(&attributes_);
    ::sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes_, &signals);
    ::sigfillset(&signals);
    ::posix_spawnattr_setsigdefault(&attributes_, &signals);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnPlan() {
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&files_);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  SpawnPlan(SpawnPlan&&) = delete;
  SpawnPlan& operator=(SpawnPlan&&) = delete;

  pid_t Spawn(const std::filesystem::path& program, char** arguments) const {
    pid_t process = 0;
    const int error =
        ::posix_spawn(&process, program.c_str(), &files_, &attributes_, arguments, environ);
    if (error != 0) Fail(program, error);
    return process;
  }

 private:
  posix_spawn_file_actions_t files_ = {};
  posix_spawnattr_t attributes_ = {};
};

}  // namespace

EndedProgram::EndedProgram(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments) {
  std::vector<std::string> texts = {program.string()};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  const MemoryFile output(program);
  const pid_t process = SpawnPlan(output.fd()).Spawn(program, pointers.data());
  int status = 0;
  pid_t ended = -1;
  do {
    ended = ::waitpid(process, &status, 0);
  } while (ended < 0 && errno == EINTR);
  if (ended == process && WIFSIGNALED(status)) signal_ = WTERMSIG(status);
  output_ = output.Map();
}

EndedProgram::~EndedProgram() {
  if (output_.empty()) return;
  ::munmap(const_cast<std::uint8_t*>(output_.data()), output_.size());
}

}  // namespace bulletnav::sim
