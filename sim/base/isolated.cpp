// SPDX-License-Identifier: MIT
#include "sim/base/isolated.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

/// The child's own endings. Sanitizers (1, 23, 66, 77), sysexits (64..78) and libraries that call
/// exit use other numbers: theirs are crashes.
enum ExitCode { kExitDone = 181, kExitThrew = 182, kExitTooLarge = 183 };

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// Memory that parent and child see, growing as a file does.
class SharedFile {
 public:
  SharedFile() : fd_(::memfd_create("bulletnav", MFD_CLOEXEC)) {
    if (fd_ < 0) throw Error(std::string("no shared memory: ") + std::strerror(errno));
  }
  ~SharedFile() { ::close(fd_); }
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;
  SharedFile(SharedFile&&) = delete;
  SharedFile& operator=(SharedFile&&) = delete;

  bool Write(const void* data, std::size_t size) const {
    const auto* at = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t n = ::write(fd_, at, size);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      at += n;
      size -= static_cast<std::size_t>(n);
    }
    return true;
  }

  std::vector<std::uint8_t> Read() const {
    struct stat status = {};
    ::fstat(fd_, &status);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t n =
          ::pread(fd_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;
      done += static_cast<std::size_t>(n);
    }
    return bytes;
  }

 private:
  int fd_;
};

void Limit(int resource, rlim_t value) {
  rlimit limit{};
  ::getrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
  limit.rlim_cur = std::min(value, limit.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

/// What the address space already holds; limits count it.
std::uint64_t AddressSpace() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

[[noreturn]] void RunChild(const SharedFile& file,
                           const std::function<std::vector<std::uint8_t>()>& work) {
  // A crash is an answer here, not an event: no core file, no report of a debugger. A sanitizer is
  // there to report.
  Limit(RLIMIT_CORE, 0);
  if (!kIsSanitized) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
      std::signal(signal, SIG_DFL);
    }
    // What a library prints about its own crash is nothing that users can act on.
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  }
  ExitCode code = kExitDone;
  try {
    const std::vector<std::uint8_t> bytes = work();
    if (!file.Write(bytes.data(), bytes.size())) code = kExitTooLarge;
  } catch (const std::bad_alloc&) {
    code = kExitTooLarge;
  } catch (const std::exception& e) {
    std::string_view text = e.what();
    if (text.empty()) text = "fails without saying why";
    file.Write(text.data(), text.size());
    code = kExitThrew;
  }
  ::_exit(code);
}

/// How far a process is.
struct Activity {
  bool is_waiting = false;  // for something that is no disk
  long ticks = 0;           // of processor time
};

Activity ActivityOf(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(file, line);
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream rest(line.substr(name_end + 1));
  std::string state;
  rest >> state;
  constexpr int kBetween = 10;  // numbers between the state and the times, proc(5)
  std::string skipped;
  for (int i = 0; i < kBetween; ++i) rest >> skipped;
  long user = 0;
  long system = 0;
  rest >> user >> system;
  return {state == "S", user + system};
}

/// Until the child ends, or waits without end. False: the latter.
bool WatchTillEnd(int handle, pid_t child) {
  constexpr int kPeriodMs = 250;
  constexpr int kPatience = 8;  // periods
  pollfd events = {handle, POLLIN, 0};
  long ticks = -1;
  for (int idle = 0; idle < kPatience;) {
    const int ended = ::poll(&events, 1, kPeriodMs);
    if (ended > 0 || (ended < 0 && errno != EINTR)) return true;
    const Activity now = ActivityOf(child);
    idle = now.is_waiting && now.ticks == ticks ? idle + 1 : 0;
    ticks = now.ticks;
  }
  return false;
}

/// Waits for the child's end.
int StatusOf(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// The child's status, or nothing if it waits without end; it goes on then.
std::optional<int> StatusUnlessStuck(pid_t child) {
  const auto handle = static_cast<int>(::syscall(SYS_pidfd_open, child, 0));
  if (handle >= 0) {
    const bool is_ended = WatchTillEnd(handle, child);
    ::close(handle);
    if (!is_ended) return std::nullopt;
  }
  return StatusOf(child);
}

IsolatedResult::End EndOf(int status) {
  using End = IsolatedResult::End;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return signal == SIGXCPU || signal == SIGKILL ? End::kTimedOut : End::kCrashed;
  }
  switch (WEXITSTATUS(status)) {
    case kExitDone:
      return End::kDone;
    case kExitThrew:
      return End::kThrew;
    case kExitTooLarge:
      return End::kTooLarge;
    default:
      return End::kCrashed;
  }
}

}  // namespace

IsolatedResult RunIsolated(const std::function<std::vector<std::uint8_t>()>& work, int cpu_seconds,
                           std::uint64_t memory_bytes) {
  constexpr int kTries = 20;
  for (int i = 0; i < kTries; ++i) {
    const SharedFile file;
    const std::uint64_t held = AddressSpace();
    const pid_t child = ::fork();
    if (child < 0) throw Error(std::string("no process can be made: ") + std::strerror(errno));
    if (child == 0) {
      Limit(RLIMIT_CPU, static_cast<rlim_t>(cpu_seconds));
#ifndef __SANITIZE_ADDRESS__  // its shadow memory is larger than any limit
      Limit(RLIMIT_AS, held + memory_bytes);
#else
      (void)held;
      (void)memory_bytes;
#endif
      RunChild(file, work);
    }
    if (const std::optional<int> status = StatusUnlessStuck(child)) {
      return {EndOf(*status), file.Read()};
    }
    // It waits for a lock that another thread held when it was made; the next one may not.
    ::kill(child, SIGKILL);
    StatusOf(child);
  }
  return {IsolatedResult::End::kTimedOut, {}};
}

void AllowCpuSeconds(int more) {
  rlimit limit{};
  ::getrlimit(RLIMIT_CPU, &limit);
  if (limit.rlim_cur == RLIM_INFINITY) return;
  Limit(RLIMIT_CPU, limit.rlim_cur + static_cast<rlim_t>(more));
}

}  // namespace bulletnav::sim
