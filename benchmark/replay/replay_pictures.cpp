// SPDX-License-Identifier: MIT
#include "benchmark/replay/replay_pictures.h"

#include <algorithm>
#include <cmath>

#include "benchmark/report/replay.h"
#include "sim/image/image.h"

namespace bulletnav::bench {
namespace {

constexpr int kQuality = 62;
constexpr sim::PanoramaSpec kLook = {.rows = 80, .cols = 320};

std::vector<std::uint8_t> Strip(const std::vector<sim::Image>& images) {
  sim::Image strip(images.front().width, images.front().height * static_cast<int>(images.size()),
                   3);
  auto end = strip.pixels.begin();
  for (const sim::Image& image : images) {
    end = std::copy(image.pixels.begin(), image.pixels.end(), end);
  }
  return sim::EncodeJpeg(strip, kQuality);
}

}  // namespace

std::vector<int> SpreadSteps(std::size_t steps, int count) {
  std::vector<int> spread;
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? i / (count - 1.0) : 0.0;
    const int step = static_cast<int>(std::lround(share * static_cast<double>(steps)));
    if (spread.empty() || step > spread.back()) spread.push_back(step);
  }
  return spread;
}

std::vector<std::uint8_t> SeenStrip(const std::shared_ptr<const sim::World>& world,
                                    const EpisodeTrajectory& trajectory,
                                    const std::vector<int>& steps) {
  return Strip(ReplayPanoramas(world, trajectory, kLook, steps));
}

std::vector<std::uint8_t> GoalStrip(const sim::World& world, const EpisodeTrajectory& trajectory) {
  std::vector<sim::Image> images;
  images.reserve(trajectory.goals.size());
  for (const sim::BodyPose& goal : trajectory.goals) {
    images.push_back(LookFrom(world, trajectory.body, kLook, goal));
  }
  return Strip(images);
}

}  // namespace bulletnav::bench
