// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bulletnav::bench {

struct ReplayOptions {
  std::filesystem::path run;
  std::filesystem::path out;          // empty: RUN/replay.html
  std::vector<std::string> episodes;  // only these; empty: all
  int panoramas = 12;                 // of an episode; 0: no pictures
  int pictured = 400;                 // at most so many results have them, the worst first
};

/// What a page holds.
struct ReplayCount {
  std::filesystem::path file;
  std::size_t results = 0;
  std::size_t paths = 0;
  std::size_t beliefs = 0;
  std::uintmax_t picture_bytes = 0;
  std::uintmax_t bytes = 0;        // of the page
  std::vector<std::string> notes;  // what is not in it, and why; the page says so too
};

/// Makes a page of a run to look at in a browser: one file that needs no other. What is missing or
/// damaged (scenes, trajectories, beliefs) is left out with a note. `progress`, if given, hears how
/// many results are done of how many. Throws sim::Error if there are no results, or none of
/// the episodes that were asked for.
/// Cost: rendering `panoramas` small pictures of each result.
ReplayCount MakeReplay(const ReplayOptions& options,
                       const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace bulletnav::bench
