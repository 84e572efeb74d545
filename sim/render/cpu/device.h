// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include <embree3/rtcore.h>

namespace bulletnav::sim {

/// Embree's handles, released when they go out of scope.
struct ReleaseEmbree {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};
using EmbreeDevice = std::unique_ptr<RTCDeviceTy, ReleaseEmbree>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, ReleaseEmbree>;
using EmbreeBvh = std::unique_ptr<RTCBVHTy, ReleaseEmbree>;

/// A device that builds with the calling thread only. Throws RenderError.
EmbreeDevice NewEmbreeDevice();

}  // namespace bulletnav::sim
