// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/house/house_index.h"
#include "sim/house/refurnish.h"

namespace bulletnav::sim {

/// Some buildings of one kind in a set.
struct SetPart {
  std::string kind = "home";
  std::optional<Split> split = {};  // none: shared out as the set is
  int count = 10;
  double min_area_m2 = 0.0;  // 0: the kind's
  double max_area_m2 = 0.0;

  template <class V>
  void Visit(V& v) {
    v("kind", kind);
    v("split", split);
    v("count", count);
    v("min_area_m2", min_area_m2);
    v("max_area_m2", max_area_m2);
  }
  /// Throws Error, naming the nearest known kind or the limits, if the part cannot be made.
  void Validate() const;
};

/// A house a seed from `first_seed` on, split 68 / 4 / 14 into train / val / test, as the 86 Gibson
/// scenes of NTS (section 5) are, or in proportion.
struct HouseSetSpec {
  int count = 86;
  std::uint64_t first_seed = 0;
  /// Instead of `count` homes: buildings of these kinds, their descriptions with the furniture.
  /// Seeds count on from the first within a kind.
  std::vector<SetPart> parts = {};
  /// The same set with some rooms furnished anew; its index says so.
  Refurnish refurnished = {};
  int workers = 0;  // 0: one per processor
  /// The program's version; houses that an unfinished call of the same one left are kept. "": none.
  std::string made_by = {};
};

/// Whether the folder holds an index of these houses. Throws FileError if it is one of others,
/// Error as WriteHouseSet.
bool HasHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec);

/// How many of the houses WriteHouseSet would make: all but those that a call of the same `made_by`
/// that did not end left there. Throws as HasHouseSet, and FileError if what was left is
/// unreadable.
int CountUnmade(const std::filesystem::path& folder, const HouseSetSpec& spec);

/// Writes house_NNN.glb, or KIND_NNN.glb where the spec has parts, the same .json (see
/// house_json.h) and, last, index.json into `folder`. `advance` is called after each house that is
/// made, from any thread. The files do not depend on the number of workers, nor on what was left by
/// a call that did not end. Throws Error if count is not in 1..9999, FileError if the folder holds
/// an index of other houses or cannot be written; no house is begun after that.
std::vector<HouseEntry> WriteHouseSet(const std::filesystem::path& folder, const HouseSetSpec& spec,
                                      const std::function<void()>& advance);

}  // namespace bulletnav::sim
