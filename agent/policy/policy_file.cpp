// SPDX-License-Identifier: MIT
#include "agent/policy/policy_file.h"

#include <string>

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include "agent/models/config_in_weights.h"
#include "agent/perception/model_file.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Policies are trained in the body that is the default.
void RequireTrainedBody(const Rig& rig, const std::filesystem::path& file) {
  const Rig trained;
  if (rig.panorama.projection != trained.panorama.projection) {
    throw sim::FileError(file, "", "is of a policy that knows cylindrical panoramas alone");
  }
  if (rig.panorama.max_depth_m != trained.panorama.max_depth_m ||
      rig.camera_height != trained.camera_height) {
    throw sim::FileError(
        file, "",
        fmt::format("is of a policy of a body whose camera is {} m over the floor and sees {} m "
                    "deep; here it is {} m and {} m: set body.camera_height and "
                    "panorama.max_depth_m so",
                    trained.camera_height, trained.panorama.max_depth_m, rig.camera_height,
                    rig.panorama.max_depth_m));
  }
  if (rig.body_radius != trained.body_radius || rig.body_height != trained.body_height) {
    throw sim::FileError(
        file, "",
        fmt::format("is of a policy of a body with a radius of {} m and {} m high, which knows "
                    "what that fits through; here they are {} m and {} m: set body.radius and "
                    "body.height so",
                    trained.body_radius, trained.body_height, rig.body_radius, rig.body_height));
  }
}

}  // namespace

std::string TrainedSetting(const TensorFile& weights, const std::filesystem::path& file) {
  const auto training = weights.metadata.find("training");
  if (training == weights.metadata.end() || weights.metadata.contains(kStitchedKey)) return "";
  const sim::YamlNode config = sim::ParseYaml(training->second, file);
  config.ExpectMap();
  const YAML::Node setting = config.yaml()["setting"];
  return setting ? config.Child(setting).ToString() : "";
}

PolicyConfig PolicyConfigOf(const TensorFile& weights, const std::filesystem::path& file) {
  return ConfigInWeights<PolicyConfig>(weights, kPolicyKey, file, "a policy; train it again");
}

void RequireTrainedSetting(const std::string& setting, const TensorFile& weights,
                           const std::filesystem::path& file) {
  const std::string trained = TrainedSetting(weights, file);
  if ((trained == "rgb" || trained == "rgbd") && trained != setting) {
    throw sim::FileError(
        file, "",
        fmt::format("is of a policy that was trained in the setting {}, and knows nothing else; "
                    "this is the setting {}: take weights of this one",
                    trained, setting));
  }
}

void RequirePolicyRig(const Rig& rig, const TensorFile& weights,
                      const std::filesystem::path& file) {
  RequireRig(rig, ModelConfig{.depth = DepthFusion::kNone}, file);
  RequireTrainedBody(rig, file);
  if (PolicyConfigOf(weights, file).map && !rig.has_depth) {
    throw sim::FileError(file, "",
                         "is of a policy that is shown a metric map, which takes depth; this body "
                         "has none: take the setting rgbd");
  }
  RequireTrainedSetting(rig.has_depth ? "rgbd" : "rgb", weights, file);
}

}  // namespace bulletnav::agent
