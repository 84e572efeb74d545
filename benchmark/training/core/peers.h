// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "benchmark/training/core/peer_place.h"

namespace at {
class Tensor;
}

namespace bulletnav::bench {

/// The processes that train one network together, on one machine or several, seen from one of
/// them. Each calls the same functions in the same order. A process that dies, ends with an error
/// or does not answer in time ends the others: what they wait in throws Error, in one line that
/// names it. By torch's c10d with Gloo, over TCP.
class Peers {
 public:
  /// Alone: nothing is sent.
  Peers();
  /// Meets the others. Throws Error, naming those that do not come, if that takes too long. From
  /// now on this process does not die of SIGPIPE, unless it has a handler of its own.
  explicit Peers(const PeerPlace& place);
  ~Peers();
  Peers(const Peers&) = delete;
  Peers& operator=(const Peers&) = delete;
  Peers(Peers&&) = delete;
  Peers& operator=(Peers&&) = delete;

  int rank() const { return place_.rank; }
  int size() const { return place_.size; }
  bool is_first() const { return place_.rank == 0; }
  /// That this process should work with: its part of the machine's processors; 0: all of them.
  int threads() const;

  /// What all have, in the order of ranks, for all. Expects: equally many.
  std::vector<double> Gather(std::span<const double> own);
  /// Likewise, [size, ...] of tensors of one shape and type; the own one must stay where it is.
  at::Tensor Gather(const at::Tensor& own);
  /// The text of rank 0, for all.
  std::string FromFirst(const std::string& text);
  /// Throws Error unless all say the same of what `what` names.
  void RequireSame(const std::string& text, const std::string& what);

  /// Tells the others why this one ends, before it does.
  void Leave(const std::string& why) noexcept;

 private:
  class Link;
  template <class T>
  T Guarded(const std::function<T()>& work);

  PeerPlace place_;
  std::unique_ptr<Link> link_;  // null: alone
};

}  // namespace bulletnav::bench
