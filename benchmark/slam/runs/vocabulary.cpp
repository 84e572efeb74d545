// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/vocabulary.h"

#include <filesystem>
#include <iterator>
#include <utility>
#include <vector>

#include "benchmark/slam/runs/drive_frames.h"
#include "benchmark/slam/runs/frame_eye.h"
#include "sim/base/check.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

using Pictures = std::vector<std::vector<agent::BinaryDescriptor>>;

Pictures PicturesOf(const SlamConfig& config, const std::filesystem::path& house) {
  const VocabularySource& source = *config.vocabulary;
  Pictures pictures;
  const auto world = sim::World::Load(house, WorldOptionsOf(config.import));
  const TraversalSpec traversal = TraversalOf(config, source.actions, source.seed);
  const CameraLens lens = LensOf(traversal);
  Traverse(world, traversal, [&](const TraversalFrame& frame) {
    if (frame.step % source.every != 0) return;
    pictures.push_back(CornersOf(frame.color, lens, config.orb).descriptors);
  });
  return pictures;
}

}  // namespace

std::shared_ptr<const agent::Vocabulary> GrowVocabulary(const SlamConfig& config, int workers) {
  BULLETNAV_CHECK(config.vocabulary.has_value());
  const auto houses = FilesOf(config.vocabulary->houses);
  std::vector<Pictures> by_house(houses.size());
  sim::WorkerPool pool(workers);
  pool.ForEach(static_cast<int>(houses.size()), [&](int house, int /*worker*/) {
    const auto place = static_cast<std::size_t>(house);
    by_house[place] = PicturesOf(config, houses[place]);
  });
  Pictures all;
  for (Pictures& pictures : by_house) {
    all.insert(all.end(), std::make_move_iterator(pictures.begin()),
               std::make_move_iterator(pictures.end()));
  }
  return std::make_shared<const agent::Vocabulary>(all, config.vocabulary->tree);
}

}  // namespace bulletnav::bench
