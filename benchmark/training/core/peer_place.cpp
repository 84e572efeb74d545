// SPDX-License-Identifier: MIT
#include "benchmark/training/core/peer_place.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

class Reader {
 public:
  explicit Reader(const Variables& variables) : variables_(variables) {}

  std::optional<std::string> Text(const char* name) const {
    const char* value = variables_(name);
    return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>(value);
  }

  /// Whole, from `low` to `high`.
  int Number(const char* name, const std::string& text, int low, int high) const {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end && number >= low && number <= high) return number;
    throw sim::Error(std::string(name) + " is '" + text + "'; it must be a whole number from " +
                     std::to_string(low) + " to " + std::to_string(high));
  }
  int Number(const char* name, int low, int high, std::optional<int> otherwise = {}) const {
    if (const auto text = Text(name)) return Number(name, *text, low, high);
    if (otherwise) return *otherwise;
    throw sim::Error(std::string(name) +
                     " is not set; start all processes with torchrun or srun, or set it");
  }

 private:
  const Variables& variables_;
};

constexpr int kMostProcesses = 4096;
constexpr int kLastPort = 65535;
constexpr int kDay = 86400;  // seconds

void ReadTorchrun(const Reader& read, PeerPlace* place) {
  place->size = read.Number("WORLD_SIZE", 1, kMostProcesses);
  place->rank = read.Number("RANK", 0, place->size - 1);
  place->local_size = read.Number("LOCAL_WORLD_SIZE", 1, kMostProcesses, 1);
  place->has_store = read.Text("TORCHELASTIC_USE_AGENT_STORE").value_or("") == "True";
  place->round = read.Text("TORCHELASTIC_RESTART_COUNT").value_or("");
}

void ReadSlurm(const Reader& read, PeerPlace* place) {
  const char* tasks = read.Text("SLURM_STEP_NUM_TASKS") ? "SLURM_STEP_NUM_TASKS" : "SLURM_NTASKS";
  place->size = read.Number(tasks, 1, kMostProcesses);
  place->rank = read.Number("SLURM_PROCID", 0, place->size - 1);
  place->local_size = read.Number("SLURM_NTASKS_PER_NODE", 1, kMostProcesses, 1);
}

}  // namespace

namespace internal {

std::string FirstHost(const std::string& list) {
  const std::size_t end = list.find_first_of(",[");
  if (end == std::string::npos || list[end] == ',') return list.substr(0, end);
  const std::size_t last = list.find_first_of(",-]", end + 1);
  if (last == std::string::npos) return list.substr(0, end);
  return list.substr(0, end) + list.substr(end + 1, last - end - 1);
}

}  // namespace internal

PeerPlace PeerPlaceOf(const Variables& variables) {
  const Reader read(variables);
  PeerPlace place;
  const bool is_torchrun = read.Text("RANK") || read.Text("WORLD_SIZE");
  const bool is_slurm = !is_torchrun && read.Text("SLURM_PROCID") && read.Text("SLURM_NTASKS");
  if (is_torchrun) ReadTorchrun(read, &place);
  if (is_slurm) ReadSlurm(read, &place);
  place.timeout_s = read.Number("BULLETNAV_PEER_TIMEOUT", 1, kDay, place.timeout_s);
  if (place.size == 1) return place;
  place.port = read.Number("MASTER_PORT", 1, kLastPort, place.port);
  std::optional<std::string> address = read.Text("MASTER_ADDR");
  if (!address && is_slurm) {
    std::optional<std::string> nodes = read.Text("SLURM_STEP_NODELIST");
    if (!nodes) nodes = read.Text("SLURM_JOB_NODELIST");
    if (nodes) address = internal::FirstHost(*nodes);
  }
  if (!address) {
    throw sim::Error("MASTER_ADDR is not set; it must name the machine of the process of RANK 0");
  }
  place.address = *address;
  return place;
}

}  // namespace bulletnav::bench
