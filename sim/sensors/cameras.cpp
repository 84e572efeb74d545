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
  if (channel == kColor || channel == kDepth) return;
  if (channel == kSemantic) {
    throw KeyError("channels",
                   "the channel semantic needs scenes that carry object ids, and none do yet; it "
                   "comes with them");
  }
  throw KeyError("channels", "unknown channel '" + channel + "'; known are: color, depth");
}

}  // namespace

void CameraChannels::Validate(const std::vector<std::string>& channels) {
  if (channels.empty()) throw KeyError("channels", "a camera needs a channel: color, depth");
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
    } else {
      arrays.push_back({channel, {size.rows, size.cols}, Element::kFloat32, "m"});
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
    : renderer_(scene.MakeRenderer(camera)), channels_(channels) {}

void CameraReader::Read(const CameraPose& pose, std::span<const std::span<std::byte>> out) {
  std::span<std::uint8_t> color;
  std::span<float> depth;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (channels_[i] == kColor) {
      color = ValuesIn<std::uint8_t>(out[i]);
    } else {
      depth = ValuesIn<float>(out[i]);
    }
  }
  renderer_->Render({&pose, 1}, color, depth);
}

}  // namespace bulletnav::sim
