// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string>
#include <utility>

#include "benchmark/base/json_cursor.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {

/// Habitat's episode files and two relatives of theirs.
/// list: a bare list with integer ids and null radii, as of image-goal-nav-dataset.
/// nrns: the goal's heading in goals[].rotation, the distance in length_shortest, as of NRNS.
enum class EpisodeFormat { kHabitat, kList, kNrns };

/// One episode of any of the formats turned into Habitat's, and the way back, which keeps what the
/// format has no key for inside `info`. There and back changes nothing.
Json ToHabitatForm(Json episode);
/// `number` is the integer id of the list format.
Json FromHabitatForm(const Json& episode, EpisodeFormat format, std::size_t number);

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::EpisodeFormat> {
  static constexpr std::array kNames = {
      std::pair{"habitat", bulletnav::bench::EpisodeFormat::kHabitat},
      std::pair{"list", bulletnav::bench::EpisodeFormat::kList},
      std::pair{"nrns", bulletnav::bench::EpisodeFormat::kNrns}};
};
