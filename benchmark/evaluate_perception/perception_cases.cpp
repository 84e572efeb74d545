// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_cases.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "benchmark/episodes/drawn_grey.h"
#include "benchmark/evaluate_perception/wall_count.h"
#include "benchmark/training/supervised/scene_panoramas.h"
#include "sim/scene/import.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

/// Makes one scene's cases.
class SceneExam {
 public:
  SceneExam(LabelledScene scene, const DataConfig& config, const CasesProgress& progress)
      : config_(config), progress_(progress) {
    cases_.scene = std::move(scene.file);
    cases_.samples = std::move(scene.samples);
    const auto n = cases_.samples.poses.size();
    cases_.predictions.resize(n * n);
    cases_.walls.resize(n * n);
  }

  SceneCases Take(agent::SemanticModel* model) {
    const sim::ImportedScene imported = sim::ImportScene(cases_.scene, config_.import.options());
    const std::string grey = DrawnGrey(cases_.scene, imported.report);
    if (progress_.on_note && !grey.empty()) progress_.on_note(grey);
    CountWalls(sim::PhysicsWorld(imported.mesh));
    const auto render = sim::MakeRenderScene(imported.drawn_mesh(), sim::Backend::kEmbree);
    const std::vector<agent::PanoramaCode> codes = Encode(*render, model);
    for (const agent::PanoramaCode& code : codes) {
      cases_.explorable.push_back(model->Explorable(code));
    }
    for (int goal = 0; goal < cases_.count(); ++goal) {
      ComparePlaces(codes, goal, model);
      if (progress_.on_place) progress_.on_place();
    }
    return std::move(cases_);
  }

 private:
  void CountWalls(const sim::PhysicsWorld& scene) {
    constexpr int kMost = std::numeric_limits<std::uint8_t>::max();
    const auto& poses = cases_.samples.poses;
    for (std::size_t a = 0; a < poses.size(); ++a) {
      for (std::size_t b = a + 1; b < poses.size(); ++b) {
        const int walls = WallsBetween(scene, poses[a].position, poses[b].position);
        const auto kept = static_cast<std::uint8_t>(std::min(walls, kMost));
        cases_.walls[a * poses.size() + b] = cases_.walls[b * poses.size() + a] = kept;
      }
    }
  }

  std::vector<agent::PanoramaCode> Encode(const sim::RenderScene& scene,
                                          agent::SemanticModel* model) {
    ScenePanoramas panoramas(scene, config_);
    std::vector<std::uint8_t> color(3 * config_.panorama.pixels());
    std::vector<float> depth(config_.panorama.pixels());
    std::vector<agent::PanoramaCode> codes;
    for (int place = 0; place < cases_.count(); ++place) {
      panoramas.Render(cases_.samples.poses, {&place, 1}, color, depth);
      const agent::Panorama panorama = {color, depth};
      codes.push_back(std::move(model->Encode({&panorama, 1}).front()));
    }
    return codes;
  }

  void ComparePlaces(const std::vector<agent::PanoramaCode>& codes, int goal,
                     agent::SemanticModel* model) {
    std::vector<const agent::PanoramaCode*> sources;
    for (int source = 0; source < cases_.count(); ++source) {
      if (source != goal) sources.push_back(&codes[static_cast<std::size_t>(source)]);
    }
    const auto predictions = model->Compare(sources, codes[static_cast<std::size_t>(goal)]);
    auto next = predictions.begin();
    for (int source = 0; source < cases_.count(); ++source) {
      if (source != goal) cases_.prediction(source, goal) = *next++;
    }
  }

  const DataConfig& config_;
  const CasesProgress& progress_;
  SceneCases cases_;
};

}  // namespace

std::vector<SceneCases> MakeCases(const DataConfig& config, const ModelMaker& make_model,
                                  int workers, const CasesProgress& progress) {
  const std::vector<std::filesystem::path> scenes = ScenesOf(config);
  std::vector<SceneCases> cases(scenes.size());
  sim::WorkerPool pool(workers);
  std::vector<std::shared_ptr<agent::SemanticModel>> models(
      static_cast<std::size_t>(pool.workers()));
  pool.ForEach(static_cast<int>(scenes.size()), [&](int task, int worker) {
    const auto s = static_cast<std::size_t>(task);
    auto& model = models[static_cast<std::size_t>(worker)];
    if (!model) model = make_model();
    LabelledScene labelled = LabelScene(scenes[s], config);
    if (progress.on_note && !labelled.note.empty()) progress.on_note(labelled.note);
    cases[s] = SceneExam(std::move(labelled), config, progress).Take(model.get());
  });
  return cases;
}

}  // namespace bulletnav::bench
