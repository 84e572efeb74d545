// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_batches.h"

#include <numeric>
#include <utility>

#include "benchmark/slam/training/vary_pictures.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

/// `count` different numbers below `below`.
std::vector<int> Draw(int count, int below, sim::Rng* rng) {
  std::vector<int> numbers(static_cast<std::size_t>(below));
  std::iota(numbers.begin(), numbers.end(), 0);
  rng->Shuffle(numbers);
  numbers.resize(static_cast<std::size_t>(count));
  return numbers;
}

/// The views of a batch that are of one scene.
struct Part {
  const PlaceViews* scene = nullptr;
  std::vector<int> views;
};

/// All views of `places` places.
Part DrawViews(const PlaceViews& scene, int places, sim::Rng* rng) {
  Part part{&scene, {}};
  for (const int place : Draw(places, scene.places, rng)) {
    for (int view = 0; view < scene.views; ++view) part.views.push_back(place * scene.views + view);
  }
  return part;
}

/// What a part's view shares with each of the part.
void WriteRow(const Part& part, std::size_t a, float* row) {
  for (std::size_t b = 0; b < part.views.size(); ++b) {
    row[b] = static_cast<float>(part.scene->covisibility(part.views[a], part.views[b]));
  }
}

}  // namespace

std::vector<std::uint8_t> PictureOf(const PlaceViews& views, int number, int rows) {
  const auto whole = views.picture(number);
  if (rows == views.rows) return {whole.begin(), whole.end()};
  BULLETNAV_CHECK_EQ(2 * rows, views.rows);
  const auto stride = static_cast<std::size_t>(views.cols) * 3;
  std::vector<std::uint8_t> half;
  half.reserve(whole.size() / 4);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
    for (std::size_t i = 0; i < stride / 2; ++i) {
      const std::uint8_t* at = whole.data() + 2 * row * stride + i / 3 * 6 + i % 3;
      half.push_back(
          static_cast<std::uint8_t>((at[0] + at[3] + at[stride] + at[stride + 3] + 2) / 4));
    }
  }
  return half;
}

PlaceBatches::PlaceBatches(std::vector<PlaceViews> scenes, const PlaceBatchSpec& spec)
    : scenes_(std::move(scenes)), spec_(spec) {
  if (static_cast<int>(scenes_.size()) < spec_.scenes) {
    throw sim::Error("there are fewer scenes than a batch takes; name more, or set 'scenes' lower");
  }
  for (const PlaceViews& scene : scenes_) {
    if (scene.places >= spec_.places / spec_.scenes) continue;
    throw sim::Error("a scene has " + std::to_string(scene.places) +
                     " places that can be seen from several sides, fewer than a batch takes of "
                     "one; set 'places' lower");
  }
}

PlaceBatch PlaceBatches::Batch(std::uint64_t number) const {
  sim::Rng rng = sim::Rng(spec_.seed, "place batch").Fork("number", number);
  std::vector<Part> parts;
  for (const int scene : Draw(spec_.scenes, static_cast<int>(scenes_.size()), &rng)) {
    parts.push_back(
        DrawViews(scenes_[static_cast<std::size_t>(scene)], spec_.places / spec_.scenes, &rng));
  }
  PlaceBatch batch;
  for (const Part& part : parts) batch.count += static_cast<int>(part.views.size());
  const auto count = static_cast<std::size_t>(batch.count);
  batch.covisibility.assign(count * count, 0.0f);
  std::size_t first = 0;
  for (const Part& part : parts) {
    for (const int view : part.views) {
      const auto picture = PictureOf(*part.scene, view, spec_.rows);
      batch.pictures.insert(batch.pictures.end(), picture.begin(), picture.end());
    }
    for (std::size_t a = 0; a < part.views.size(); ++a) {
      WriteRow(part, a, batch.covisibility.data() + (first + a) * count + first);
    }
    first += part.views.size();
  }
  if (spec_.augment) VaryPictures(*spec_.augment, rng.Fork("vary"), spec_.rows, &batch.pictures);
  return batch;
}

}  // namespace bulletnav::bench
