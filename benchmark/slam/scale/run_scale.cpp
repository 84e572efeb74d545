// SPDX-License-Identifier: MIT
#include "benchmark/slam/scale/run_scale.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <fstream>
#include <memory>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "agent/slam/descriptors/picture_describer.h"
#include "agent/slam/retrieval/descriptor_index.h"
#include "benchmark/base/program_version.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/slam/runs/drive_frames.h"
#include "benchmark/slam/runs/measure_drive.h"
#include "benchmark/slam/runs/travel.h"
#include "benchmark/slam/truth/loop_truth.h"
#include "sim/base/error.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kFound = 10;

/// A drive as it is remembered.
struct KnownDrive {
  std::vector<agent::PictureDescriptor> descriptors;  // by frame
  std::vector<TruthFrame> truth;                      // by frame, of drives with queries
  std::vector<double> describing_ms;
};

class Driving {
 public:
  explicit Driving(const ScaleConfig& config)
      : config_(config),
        weights_(ShippedOr(config.descriptors)),
        size_(agent::LoadPictureDescriber(weights_)->config().size) {}

  int descriptor_size() const { return size_; }

  KnownDrive Through(const fs::path& house, int actions, bool has_queries) const {
    TraversalSpec traversal;
    traversal.body = config_.body;
    traversal.camera = config_.camera;
    traversal.noise = config_.noise;
    traversal.actions = actions;
    traversal.seed = config_.seed;
    const auto describer = agent::LoadPictureDescriber(weights_);
    const Intrinsics camera = IntrinsicsOf(config_.camera);
    Travel travel(config_.apart_m);
    KnownDrive drive;
    Traverse(sim::World::Load(house, WorldOptionsOf(config_.import)), traversal,
             [&](const TraversalFrame& frame) {
               const auto start = Clock::now();
               drive.descriptors.push_back(
                   describer->Describe(frame.color.pixels, frame.color.width, frame.color.height));
               drive.describing_ms.push_back(MillisecondsSince(start));
               if (!has_queries) return;
               drive.truth.push_back({frame.true_pose, Coarsened(frame.depth, camera),
                                      travel.Next(frame.dead_reckoned)});
             });
    return drive;
  }

 private:
  const ScaleConfig& config_;
  fs::path weights_;
  int size_;
};

/// Houses of a split, and other scenes.
std::vector<fs::path> ScenesOf(const ScaleConfig& config, sim::Split split,
                               const std::vector<std::string>& more) {
  std::vector<fs::path> files;
  for (const std::string& scene : more) {
    if (!fs::exists(scene))
      throw sim::FileError(scene, "", "is not there; see the config's scenes");
    files.emplace_back(scene);
  }
  if (!config.houses) return files;
  const fs::path folder = config.houses->folder;
  for (const sim::HouseEntry& house : sim::ReadHouseIndex(folder / "index.json")) {
    if (house.split == split) files.push_back(folder / house.file);
  }
  return files;
}

/// Copies of a query's frames would count as wrong answers.
void RequireOnce(const std::vector<fs::path>& own, const std::vector<fs::path>& other) {
  std::set<fs::path> places;
  for (const auto* scenes : {&own, &other}) {
    for (const fs::path& scene : *scenes) {
      if (places.insert(fs::weakly_canonical(scene)).second) continue;
      throw sim::FileError(scene, "",
                           "is there twice among the scenes of queries and others; leave one out "
                           "of 'query_scenes' or 'other_scenes'");
    }
  }
}

std::vector<KnownDrive> DriveAll(const std::vector<fs::path>& houses,
                                 const std::function<KnownDrive(const fs::path&)>& drive,
                                 sim::WorkerPool* pool, const std::function<void()>& advance) {
  std::vector<KnownDrive> drives(houses.size());
  pool->ForEach(static_cast<int>(houses.size()), [&](int i, int /*worker*/) {
    const auto at = static_cast<std::size_t>(i);
    drives[at] = drive(houses[at]);
    advance();
  });
  return drives;
}

/// A frame that has a loop before it, in its drive.
struct Query {
  const KnownDrive* drive = nullptr;
  const LoopTruth* truth = nullptr;
  int frame = 0;
};

/// The frames of a drive and those of others, to search among.
class Memory {
 public:
  Memory(const std::vector<KnownDrive>& others, int descriptor_size)
      : size_(descriptor_size), others_(descriptor_size) {
    for (const KnownDrive& drive : others) {
      for (const agent::PictureDescriptor& descriptor : drive.descriptors) others_.Add(descriptor);
    }
  }
  int others() const { return others_.count(); }

  /// Whether the frames found for a query, the most alike first, are covisible.
  RankedTruth Search(const Query& query, int frames, double* milliseconds) {
    Know(*query.drive);
    const int own = query.truth->compared(query.frame);
    const auto start = Clock::now();
    const agent::PictureDescriptor& descriptor =
        query.drive->descriptors[static_cast<std::size_t>(query.frame)];
    const auto here = own_->MostLike(descriptor, kFound, own);
    const auto elsewhere = others_.MostLike(descriptor, kFound, frames - own);
    *milliseconds = MillisecondsSince(start);
    RankedTruth ranked;
    auto next = elsewhere.begin();
    for (const agent::LikeDescriptor& one : here) {
      for (; next != elsewhere.end() && next->cosine > one.cosine; ++next) ranked.push_back(false);
      ranked.push_back(query.truth->Is(LoopKind::kCovisible, query.frame, one.number));
    }
    ranked.resize(kFound);  // what is left is of elsewhere
    return ranked;
  }

 private:
  void Know(const KnownDrive& drive) {
    if (known_ == &drive) return;
    known_ = &drive;
    own_ = std::make_unique<agent::DescriptorIndex>(size_);
    for (const agent::PictureDescriptor& descriptor : drive.descriptors) own_->Add(descriptor);
  }

  int size_;
  agent::DescriptorIndex others_;
  const KnownDrive* known_ = nullptr;
  std::unique_ptr<agent::DescriptorIndex> own_;
};

/// Memory of this program that is in use, of /proc; 0 where there is none.
double ResidentMb() {
  std::ifstream file("/proc/self/status");
  std::string word;
  while (file >> word) {
    double kb = 0.0;
    if (word == "VmRSS:" && file >> kb) return kb / 1024.0;
  }
  return 0.0;
}

using Truths = std::vector<std::unique_ptr<LoopTruth>>;

Truths TruthsOf(const std::vector<KnownDrive>& drives, sim::WorkerPool* pool) {
  Truths truths(drives.size());
  pool->ForEach(static_cast<int>(drives.size()), [&](int i, int /*worker*/) {
    const auto at = static_cast<std::size_t>(i);
    truths[at] = std::make_unique<LoopTruth>(drives[at].truth, nullptr);
  });
  return truths;
}

void AddQueries(const KnownDrive& drive, const LoopTruth& truth, int every,
                std::vector<Query>* queries) {
  for (int frame = 0; frame < truth.frames(); frame += every) {
    if (truth.HasLoop(LoopKind::kCovisible, frame)) queries->push_back({&drive, &truth, frame});
  }
}

std::vector<Query> QueriesOf(const std::vector<KnownDrive>& drives, const Truths& truths,
                             int every) {
  std::vector<Query> queries;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    AddQueries(drives[i], *truths[i], every, &queries);
  }
  return queries;
}

void RequireFrames(const ScaleConfig& config, std::size_t houses) {
  const std::size_t frames = houses * (static_cast<std::size_t>(config.other_actions) + 1);
  if (static_cast<std::size_t>(config.sizes.back()) <= frames) return;
  throw sim::KeyError("sizes",
                      fmt::format("'sizes' asks for {} frames, and drives through {} other "
                                  "scenes have {}; raise 'other_actions' or leave sizes "
                                  "out",
                                  config.sizes.back(), houses, frames));
}

/// Searches for all queries among so many frames.
void Search(int size, const std::vector<Query>& queries, int descriptor_size, Memory* memory,
            PlayedScale* played) {
  std::vector<RankedTruth> ranked;
  std::vector<double> milliseconds;
  ranked.reserve(queries.size());
  milliseconds.reserve(queries.size());
  for (const Query& query : queries) {
    ranked.push_back(memory->Search(query, size, &milliseconds.emplace_back()));
  }
  constexpr double kMb = 1024.0 * 1024.0;
  const double bytes = 1.0 * size * descriptor_size * sizeof(std::int16_t);
  played->result.figures.push_back(
      {size, RecallAt(ranked, 1), RecallAt(ranked, 5), RecallAt(ranked, kFound), bytes / kMb});
  played->times.searches.push_back(TimesOf(std::move(milliseconds)));
}

}  // namespace

PlayedScale PlayScale(const ScaleConfig& config, int workers, const StartProgress& start) {
  const auto begin = [&start](const std::string& what, int total) -> std::function<void()> {
    if (!start) return [] {};
    return start(what, total);
  };
  if (config.houses) MakeHouses(*config.houses, CommittedVersion(), workers, begin);
  const std::vector<fs::path> own = ScenesOf(config, config.queries, config.query_scenes);
  const std::vector<fs::path> other = ScenesOf(config, config.others, config.other_scenes);
  if (own.empty()) {
    throw sim::KeyError("query_scenes",
                        "there is no scene to drive through for queries; name 'query_scenes', or "
                        "'houses' with some of the split 'queries'");
  }
  RequireOnce(own, other);
  RequireFrames(config, other.size());
  const Driving driving(config);
  sim::WorkerPool pool(workers);
  const auto advance = begin("drives", static_cast<int>(own.size() + other.size()));
  const std::vector<KnownDrive> drives = DriveAll(
      own,
      [&](const fs::path& house) {
        return driving.Through(house, config.actions, true);
      },
      &pool, advance);
  const std::vector<KnownDrive> others = DriveAll(
      other,
      [&](const fs::path& house) {
        return driving.Through(house, config.other_actions, false);
      },
      &pool, advance);
  const Truths truths = TruthsOf(drives, &pool);
  const std::vector<Query> queries = QueriesOf(drives, truths, config.query_every);
  if (queries.empty()) {
    throw sim::KeyError("actions", "no query has a loop; drive on: raise 'actions'");
  }
  PlayedScale played;
  played.result.queries = static_cast<int>(queries.size());
  std::vector<double> describing;
  for (const KnownDrive& drive : drives) {
    describing.insert(describing.end(), drive.describing_ms.begin(), drive.describing_ms.end());
  }
  played.times.describing = TimesOf(std::move(describing));
  Memory memory(others, driving.descriptor_size());
  const auto searched = begin("searches", static_cast<int>(config.sizes.size()));
  for (const int size : config.sizes) {
    Search(size, queries, driving.descriptor_size(), &memory, &played);
    searched();
  }
  played.times.resident_mb = ResidentMb();
  return played;
}

std::string ScaleTable(const PlayedScale& played) {
  const ScaleTimes& times = played.times;
  std::string text = fmt::format(
      "{} queries that have a loop; it is among the first 1, 5, 10 frames found\n\n"
      "| frames | recall@1 | recall@5 | recall@10 | search, ms, median | p95 | with describing, "
      "p95 | index, MB |\n|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      played.result.queries);
  for (std::size_t i = 0; i < played.result.figures.size(); ++i) {
    const ScaleFigures& row = played.result.figures[i];
    const StageTimes& search = times.searches[i];
    text += fmt::format("| {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |\n",
                        row.frames, row.recall_1, row.recall_5, row.recall_10, search.median_ms,
                        search.p95_ms, search.p95_ms + times.describing.p95_ms, row.index_mb);
  }
  return text;
}

}  // namespace bulletnav::bench
