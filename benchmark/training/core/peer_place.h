// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>

namespace bulletnav::bench {

/// Where a process stands among those that train one network together.
struct PeerPlace {
  int rank = 0;            // from 0
  int size = 1;            // processes in all
  int local_size = 1;      // of them on this machine
  std::string address;     // of the machine of rank 0
  int port = 29500;        // there
  bool has_store = false;  // the launcher serves the port; else rank 0 does
  std::string round;       // other for each time that the launcher starts them anew
  int timeout_s = 600;     // to wait for another process
};

/// Says a variable of the environment; null if it is not set.
using Variables = std::function<const char*(const char*)>;

/// From what launchers set: torchrun RANK, WORLD_SIZE, LOCAL_WORLD_SIZE, MASTER_ADDR and
/// MASTER_PORT; Slurm SLURM_PROCID, SLURM_NTASKS and, unless MASTER_ADDR says it, the first of the
/// job's nodes. BULLETNAV_PEER_TIMEOUT: seconds, instead of 600. Without any of them the process is
/// alone. Throws Error, naming the variable, for what is missing or no such number.
PeerPlace PeerPlaceOf(const Variables& variables);

namespace internal {

/// The first host of a list as Slurm writes it: "node[03-07,9],other" is "node03".
std::string FirstHost(const std::string& list);

}  // namespace internal

}  // namespace bulletnav::bench
