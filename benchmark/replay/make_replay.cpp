// SPDX-License-Identifier: MIT
#include "benchmark/replay/make_replay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "benchmark/base/gzip.h"
#include "benchmark/base/json_cursor.h"
#include "benchmark/base/program_version.h"
#include "benchmark/play/belief_log.h"
#include "benchmark/replay/replay_page.h"
#include "benchmark/replay/replay_pictures.h"
#include "benchmark/replay/replay_rows.h"
#include "benchmark/replay/replay_scene.h"
#include "benchmark/report/plot_choice.h"
#include "benchmark/report/run_scene.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/runner.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/require_writable.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kFloorStep = 0.1;      // metres
constexpr int kMapPixels = 900;         // of the longer side of a furniture's picture
constexpr std::size_t kMostLines = 10;  // damaged lines that have a note each

/// A scene, as long as its results are written.
struct OpenScene {
  sim::ImportedScene imported;
  std::shared_ptr<const sim::World> world;
  std::optional<sim::FloorPlan> plan;
  std::map<long, int> storeys;  // blocks by height of the start in steps of rugs and thresholds
};

OpenScene Open(const fs::path& file, const std::string& name, const RunConfig& config) {
  if (config.fingerprints) RequireSceneOfRun(file, name, config.fingerprints->scenes);
  const sim::WorldOptions as_run = config.world_options();
  OpenScene scene;
  scene.imported = sim::ImportScene(file, as_run.import);
  scene.world =
      std::make_shared<const sim::World>(file.filename().string(), scene.imported, as_run);
  scene.plan = PlanOfScene(file, config.import.scale, scene.imported.doors);
  return scene;
}

/// Fills a page from a run.
class ReplayMaker {
 public:
  ReplayMaker(const ReplayOptions& options, RunConfig config, std::vector<ReplayRow> rows,
              ReplayPage* page)
      : options_(options), config_(std::move(config)), rows_(std::move(rows)), page_(*page) {
    std::vector<EpisodeResult> results;
    results.reserve(rows_.size());
    for (const ReplayRow& row : rows_) results.push_back(row.result);
    for (const EpisodeResult& one : Choose(results, {.worst = std::max(options.pictured, 1)})) {
      pictured_.insert(one.key);
    }
  }

  void Note(const std::string& note) {
    auto& notes = notes_.notes;
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }

  void Add(const std::function<void(std::size_t, std::size_t)>& progress) {
    std::map<std::string, std::vector<std::size_t>> by_scene;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      by_scene[rows_[i].result.key.scene].push_back(i);
    }
    std::size_t done = 0;
    for (const auto& [name, ones] : by_scene) {
      scene_.reset();
      has_tried_scene_ = false;
      for (const std::size_t i : ones) {
        AddRow(i);
        if (progress) progress(++done, rows_.size());
      }
    }
  }

  ReplayCount Finish() {
    notes_.to_play_again = VersionHint();
    if (paths_ == 0) {
      Note("This run has kept no trajectories: there is the table, but nothing to play back.");
    } else if (beliefs_ == 0) {
      Note(std::string("This run has logged no beliefs: what an agent believed is shown at its end "
                       "alone. Run "
                       "with --beliefs to have it at each step.") +
           (notes_.to_play_again.empty() ? "" : " " + notes_.to_play_again));
    }
    page_.Finish(RowsJson(options_.run, config_, AgentRowsOf(config_), rows_, notes_));
    ReplayCount count;
    count.results = rows_.size();
    count.paths = paths_;
    count.beliefs = beliefs_;
    count.picture_bytes = picture_bytes_;
    count.notes = notes_.notes;
    return count;
  }

 private:
  /// Which version can play the run again, if others than this one have played it.
  std::string VersionHint() {
    std::vector<std::string> versions;
    try {
      versions = VersionsOf(options_.run);
    } catch (const sim::Error& e) {
      Note(e.what());
    }
    if (versions.empty() || versions == std::vector{ProgramVersion()}) return "";
    return fmt::format(
        "The run was played with bulletnav {}: play it again with that version, not with {}, which "
        "made this page.",
        fmt::join(versions, " and "), ProgramVersion());
  }

  /// What can be had of a result; the rest is noted.
  void AddRow(std::size_t i) {
    ReplayRow& row = rows_[i];
    const fs::path file = TrajectoryPath(options_.run, row.result.key);
    std::error_code unreadable;
    if (!fs::exists(file, unreadable)) return;
    std::optional<EpisodeTrajectory> trajectory;
    try {
      trajectory = ReadTrajectory(file);
    } catch (const sim::Error& e) {
      Note(e.what());
      return;
    }
    AddBeliefs(i);
    if (row.has_beliefs) trajectory->belief = {};
    page_.AddText(fmt::format("e{}", i), ToJson(*trajectory));
    row.has_path = true;
    ++paths_;
    try {
      AddScene(*trajectory, &row);
    } catch (const sim::Error& e) {
      Note(fmt::format("{}. Paths in it are shown without a plan.", e.what()));
    }
    try {
      AddPictures(i, *trajectory);
    } catch (const sim::Error& e) {
      Note(e.what());
    }
  }

  void AddBeliefs(std::size_t i) {
    const fs::path file = BeliefPath(options_.run, rows_[i].result.key);
    std::error_code unreadable;
    if (!fs::exists(file, unreadable)) return;
    try {
      const std::string bytes = sim::ReadTextFile(file);
      const std::span packed(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ParseJson(Decompress(packed), file);
      page_.AddPacked(fmt::format("b{}", i), packed);
      rows_[i].has_beliefs = true;
      ++beliefs_;
    } catch (const sim::Error& e) {
      Note(fmt::format("{}: left out: {}", file.string(), e.what()));
    }
  }

  void AddScene(const EpisodeTrajectory& trajectory, ReplayRow* row) {
    if (!has_tried_scene_) {
      has_tried_scene_ = true;  // also if it throws: one note is enough
      scene_ = Open(trajectory.scene_file, row->result.key.scene, config_);
    }
    if (!scene_) return;
    const long step = std::lround(trajectory.start.position.y() / kFloorStep);
    const auto [storey, is_new] = scene_->storeys.try_emplace(step, scene_blocks_);
    row->scene_block = storey->second;
    if (!is_new) return;
    TopDownSpec spec;
    spec.floor_y = static_cast<float>(kFloorStep * static_cast<double>(step));
    spec.max_pixels = kMapPixels;
    page_.AddText(fmt::format("s{}", scene_blocks_++),
                  SceneJson(MakeSceneMap(scene_->imported.mesh, scene_->world->navmesh(),
                                         scene_->plan, spec)));
  }

  void AddPictures(std::size_t i, const EpisodeTrajectory& trajectory) {
    ReplayRow& row = rows_[i];
    if (!scene_ || options_.panoramas == 0 || !pictured_.contains(row.result.key)) return;
    const auto [goal, is_new] = goals_.try_emplace({row.result.key.scene, row.result.key.episode},
                                                   static_cast<int>(goals_.size()));
    row.goal_block = goal->second;
    if (is_new) {
      AddPicture(fmt::format("g{}", row.goal_block), GoalStrip(*scene_->world, trajectory));
    }
    const std::vector<int> steps = SpreadSteps(trajectory.steps.size(), options_.panoramas);
    AddPicture(fmt::format("i{}", i), SeenStrip(scene_->world, trajectory, steps));
    row.seen = steps;
  }

  void AddPicture(const std::string& id, const std::vector<std::uint8_t>& jpeg) {
    page_.AddPicture(id, jpeg);
    picture_bytes_ += jpeg.size();
  }

  const ReplayOptions& options_;
  RunConfig config_;
  std::vector<ReplayRow> rows_;
  ReplayPage& page_;
  std::set<ResultKey> pictured_;
  std::optional<OpenScene> scene_;
  bool has_tried_scene_ = false;
  int scene_blocks_ = 0;
  std::map<std::pair<std::string, std::string>, int> goals_;  // blocks by scene and episode
  ReplayNotes notes_;
  std::size_t paths_ = 0;
  std::size_t beliefs_ = 0;
  std::uintmax_t picture_bytes_ = 0;
};

/// `damaged` gets a text for each line that cannot be read.
std::vector<ReplayRow> RowsOf(const ReplayOptions& options, std::vector<std::string>* damaged) {
  auto [results, lines] = ReadReadableResults(options.run);
  *damaged = std::move(lines);
  if (results.empty() && !damaged->empty()) {
    throw sim::FileError(options.run, "", "holds no result that can be read: " + damaged->front());
  }
  if (results.empty()) throw sim::FileError(options.run, "", "holds no results yet");
  const auto& wanted = options.episodes;
  std::vector<ReplayRow> rows;
  for (EpisodeResult& result : results) {
    const bool is_wanted = wanted.empty() || std::find(wanted.begin(), wanted.end(),
                                                       result.key.episode) != wanted.end();
    if (!is_wanted) continue;
    rows.emplace_back();
    rows.back().result = std::move(result);
  }
  if (!rows.empty()) return rows;
  throw sim::FileError(options.run, "",
                       fmt::format("has no result of episode '{}'", wanted.front()));
}

}  // namespace

ReplayCount MakeReplay(const ReplayOptions& options,
                       const std::function<void(std::size_t, std::size_t)>& progress) {
  RunConfig config = LoadSavedRunConfig(options.run / "config.yaml");
  const fs::path file = options.out.empty() ? options.run / "replay.html" : options.out;
  sim::RequireWritable(file);
  std::vector<std::string> damaged;
  std::vector<ReplayRow> rows = RowsOf(options, &damaged);
  ReplayCount count;
  sim::WriteFileAtomically(file, [&](const fs::path& temporary) {
    ReplayPage page(temporary, RunName(options.run) + " - BulletNav replay");
    ReplayMaker maker(options, std::move(config), std::move(rows), &page);
    for (std::size_t i = 0; i < std::min(damaged.size(), kMostLines); ++i) {
      maker.Note(damaged[i] + ". This line is left out.");
    }
    if (damaged.size() > kMostLines) {
      maker.Note(fmt::format("{} more lines of episodes.jsonl cannot be read, and are left out.",
                             damaged.size() - kMostLines));
    }
    maker.Add(progress);
    count = maker.Finish();
  });
  count.file = file;
  count.bytes = fs::file_size(file);
  return count;
}

}  // namespace bulletnav::bench
