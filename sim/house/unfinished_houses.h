// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "sim/house/house_index.h"

namespace bulletnav::sim {

/// The houses that are written in a folder while its index is not: unfinished.json, so that the
/// same call goes on after a kill. Those of another version of the program, which may look
/// different, and of another first seed do not count.
class UnfinishedHouses {
 public:
  /// Reads what an earlier call left. `made_by`: the program's version; empty: nothing is kept.
  /// Throws FileError if the file is not a list of houses.
  UnfinishedHouses(std::filesystem::path folder, std::string made_by, std::uint64_t first_seed);

  /// Fills in what is known of a planned house; false if it has to be made.
  bool Find(HouseEntry* house) const;

  /// From here on others' houses may be overwritten: a list that does not count is removed.
  void Begin() const;

  /// One more is written. Thread-safe. Throws FileError.
  void Add(const HouseEntry& house);

  /// All are, and so is the index.
  void Finish() const;

 private:
  std::filesystem::path folder_;
  std::string made_by_;
  std::uint64_t first_seed_;
  std::mutex mutex_;
  std::vector<HouseEntry> houses_;
};

}  // namespace bulletnav::sim
