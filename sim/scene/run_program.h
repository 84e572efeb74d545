// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bulletnav::sim {

/// A program that has ended.
class EndedProgram {
 public:
  /// Runs `program` with `arguments` until it ends. Its standard output is kept in memory, its
  /// input is empty, what it says about its own troubles is not shown. Safe in processes with
  /// threads, CUDA or MPI: nothing of this process is copied. Throws Error if it cannot be started.
  EndedProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~EndedProgram();
  EndedProgram(const EndedProgram&) = delete;
  EndedProgram& operator=(const EndedProgram&) = delete;
  EndedProgram(EndedProgram&&) = delete;
  EndedProgram& operator=(EndedProgram&&) = delete;

  /// What it wrote.
  std::span<const std::uint8_t> output() const { return output_; }
  /// The signal that ended it, if one did and nobody else has waited for it.
  std::optional<int> signal() const { return signal_; }

 private:
  std::span<const std::uint8_t> output_;
  std::optional<int> signal_;
};

}  // namespace bulletnav::sim
