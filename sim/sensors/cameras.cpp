// SPDX-License-Identifier: MIT
#include "sim/sensors/cameras.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::sim {
namespace {

constexpr const char* kColor = "color";
constexpr const char* kDepth = "depth";
constexpr const char* kSemantic = "semantic";

void ValidateChannel(const std::string& channel) {
  if (channel == kColor || channel == kDepth || channel == kSemantic) return;
  throw KeyError("channels",
                 "unknown channel '" + channel + "'; known are: color, depth, semantic");
}

}  // namespace

void CameraChannels::Validate(const std::vector<std::string>& channels) {
  if (channels.empty())
    throw KeyError("channels", "a camera needs a channel: color, depth, semantic");
  for (const std::string& channel : channels) {
    ValidateChannel(channel);
    if (std::count(channels.begin(), channels.end(), channel) > 1) {
      throw KeyError("channels", "the channel " + channel + " is given twice");
    }
  }
}

std::vector<ArraySpec> CameraChannels::Arrays(const CameraSpec& camera,
                                              const std::vector<std::string>& channels) {
  const PictureSize size = SizeOf(camera);
  std::vector<ArraySpec> arrays;
  for (const std::string& channel : channels) {
    if (channel == kColor) {
      arrays.push_back({channel, {size.rows, size.cols, 3}, Element::kUint8, "display value"});
    } else if (channel == kDepth) {
      arrays.push_back({channel, {size.rows, size.cols}, Element::kFloat32, "m"});
    } else {
      arrays.push_back({channel, {size.rows, size.cols}, Element::kInt32, ""});
    }
  }
  return arrays;
}

void CameraMount::Validate() const {
  if (!std::isfinite(forward_m + left_m + above_m + yaw_deg)) {
    throw Error("where a camera is mounted must be finite");
  }
}

CameraPose CameraMount::On(const BodyPose& pose, const CameraPose& eye) const {
  Eigen::Vector3d offset = forward_m * pose.forward() + left_m * pose.left();
  offset.y() += above_m;
  return {eye.position + offset.cast<float>(), eye.yaw + static_cast<float>(DegToRad(yaw_deg))};
}

CameraReader::CameraReader(const RenderScene& scene, const CameraSpec& camera,
                           const std::vector<std::string>& channels)
    : renderer_(scene.MakeRenderer(camera)), channels_(channels) {
  if (std::count(channels.begin(), channels.end(), kSemantic) == 0) return;
  if (!scene.has_objects()) {
    throw Error(
        "the channel semantic needs a scene whose objects are known: one that BulletNav has made; "
        "leave the channel out");
  }
  if (!renderer_->sees_objects()) {
    throw RenderError("the channel semantic cannot be drawn by " + scene.description() +
                      "; take the backend embree");
  }
}

void CameraReader::Read(const CameraPose& pose, std::span<const std::span<std::byte>> out,
                        std::span<std::uint8_t> glass) {
  PictureMemory memory{{}, {}, {}, glass};
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (channels_[i] == kColor) {
      memory.color = ValuesIn<std::uint8_t>(out[i]);
    } else if (channels_[i] == kDepth) {
      memory.depth = ValuesIn<float>(out[i]);
    } else {
      memory.objects = ValuesIn<std::int32_t>(out[i]);
    }
  }
  renderer_->Draw({&pose, 1}, memory);
}

}  // namespace bulletnav::sim
