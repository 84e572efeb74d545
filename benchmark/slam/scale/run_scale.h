// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/scale/scale_config.h"

namespace bulletnav::bench {

/// How queries fared among so many frames.
struct ScaleFigures {
  int frames = 0;
  double recall_1 = 0.0;  // of queries: the first frame found is covisible
  double recall_5 = 0.0;  // one of the first five is
  double recall_10 = 0.0;
  double index_mb = 0.0;  // of descriptors

  template <class V>
  void Visit(V& v) {
    v("frames", frames);
    v("recall_1", recall_1);
    v("recall_5", recall_5);
    v("recall_10", recall_10);
    v("index_mb", index_mb);
  }
};

struct ScaleResult {
  int queries = 0;
  std::vector<ScaleFigures> figures;  // by rising size

  template <class V>
  void Visit(V& v) {
    v("queries", queries);
    v("figures", figures);
  }
};

/// Milliseconds, which depend on the machine.
struct ScaleTimes {
  StageTimes describing;             // a picture
  std::vector<StageTimes> searches;  // ten frames for one query, on one thread; by size
  double resident_mb = 0.0;          // of the whole program, at the end

  template <class V>
  void Visit(V& v) {
    v("describing", describing);
    v("searches", searches);
    v("resident_mb", resident_mb);
  }
};

struct PlayedScale {
  ScaleResult result;
  ScaleTimes times;
};

/// Makes houses that are not there, drives through all of them and searches. The result is a
/// function of the config, the times are not. Throws sim::FileError for weights that cannot be
/// used and scenes that are there twice, sim::KeyError if there is no scene of queries, if houses
/// have not so many frames, and if no query has a loop.
/// Cost: drawing; 100,000 frames take some seven minutes of one core.
PlayedScale PlayScale(const ScaleConfig& config, int workers, const StartProgress& start);

/// A row a size.
std::string ScaleTable(const PlayedScale& played);

}  // namespace bulletnav::bench
