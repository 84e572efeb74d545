// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace bulletnav::sim {

/// How an isolated piece of work ended.
struct IsolatedResult {
  enum class End {
    kDone,     // `bytes` is what it returned
    kThrew,    // `bytes` is the exception's text, never empty
    kCrashed,  // by a signal, a sanitizer, or a library that ends the process
    kTimedOut,
    kTooLarge  // ran out of the memory allowed
  };
  End end = End::kDone;
  std::vector<std::uint8_t> bytes;
};

/// Runs `work` in a child process and returns what it returned: for libraries that may crash, hang
/// or eat all memory on hostile input. The child is a copy of the calling thread alone; `work` must
/// not wait for other threads. A lock that one of them holds at that moment (an allocator's: glibc
/// and tcmalloc take care, sanitizers do not) stays held in the child: one that waits for two
/// seconds without using the processor is ended and made anew. Costs about a millisecond and a copy
/// of the bytes. Throws Error if no process can be made.
IsolatedResult RunIsolated(const std::function<std::vector<std::uint8_t>()>& work, int cpu_seconds,
                           std::uint64_t memory_bytes);

/// Called by isolated work that finds more to do: allows it that many seconds more.
void AllowCpuSeconds(int more);

}  // namespace bulletnav::sim
