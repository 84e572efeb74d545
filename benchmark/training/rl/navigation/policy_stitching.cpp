// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/policy_stitching.h"

#include <map>
#include <utility>
#include <vector>

#include "agent/models/model_registry.h"
#include "agent/policy/policy_file.h"
#include "agent/policy/stitch_policy.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/play/environment.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// Of starts and goals of episodes, with depth, [n, bytes].
torch::Tensor Pictures(NavigationScenes* scenes, int rows, int count) {
  constexpr int kLane = 0;
  agent::PolicyPictures pictures(rows);
  std::vector<torch::Tensor> seen;
  const auto show = [&](const agent::Panorama& panorama) {
    torch::Tensor bytes =
        torch::zeros({static_cast<std::int64_t>(pictures.bytes())}, torch::kUInt8);
    pictures.Write(panorama, {bytes.data_ptr<std::uint8_t>(), pictures.bytes()});
    seen.push_back(bytes);
  };
  for (int i = 0; 2 * i < count; ++i) {
    const NavigationScenes::Drawn drawn = scenes->DrawInTurn(static_cast<std::uint64_t>(i));
    GroundTruth truth;
    Environment environment(Task{}, {&truth}, 1);
    environment.Reset(kLane, drawn.episode, drawn.world);
    environment.Observe({&kLane, 1});
    show(environment.observation(kLane).panorama);
    show(environment.goal(kLane));
  }
  return at::stack(seen);
}

/// As runs show them to an encoder that was trained in that setting.
torch::Tensor ShownIn(const std::string& setting, const torch::Tensor& pictures) {
  return setting == sim::NameOf(LaneSetting::kRgb) ? agent::WithoutDepth(pictures) : pictures;
}

}  // namespace

void StitchConfig::Validate() const {
  internal::RequireAtLeast(agent::kCodeSize, pictures, "pictures");
}

double Stitch(const StitchConfig& config, const std::filesystem::path& out,
              const TrainContext& context) {
  const std::filesystem::path weights = ShippedOr(config.weights);
  const std::shared_ptr<agent::PolicyNet> policy = agent::LoadPolicy(weights);
  if (!policy->sight() || policy->config().map) {
    throw sim::FileError(weights, "",
                         "is of a policy with an encoder of its own or a map; only those that see "
                         "with a semantic model's in integers alone are stitched");
  }
  const agent::TensorFile content = agent::ReadTensorFile(weights);
  if (content.metadata.contains(agent::kStitchedKey)) {
    throw sim::FileError(weights, agent::kStitchedKey,
                         "says that it was stitched already; train it first, or stitch the weights "
                         "that it was made of");
  }
  const std::filesystem::path encoder = ShippedOr(config.encoder);
  const auto other = agent::LoadSight(encoder, policy->config().rows);
  NavigationScenes scenes = LoadNavigationScenes(config.data, context, "loading scenes");
  const torch::Tensor pictures = Pictures(&scenes, policy->config().rows, config.pictures);
  const double explained = agent::StitchPolicy(
      {ShownIn(agent::TrainedSetting(content, weights), pictures),
       ShownIn(agent::TrainedSetting(agent::ReadTensorFile(encoder), encoder), pictures)},
      other, policy.get());
  std::map<std::string, std::string> notes = content.metadata;
  notes[agent::kStitchedKey] = config.weights + " to the encoder of " + config.encoder;
  agent::SavePolicy(*policy, std::move(notes), agent::StoredType::kBfloat16, out);
  return explained;
}

}  // namespace bulletnav::bench
