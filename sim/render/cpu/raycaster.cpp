// SPDX-License-Identifier: MIT
#include "sim/render/cpu/raycaster.h"

#include <cstring>
#include <limits>
#include <numeric>

#include "sim/base/check.h"

namespace bulletnav::sim {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

RTCRay MakeRay(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float far) {
  RTCRay ray{};
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tfar = far;
  ray.mask = ~0u;
  return ray;
}

}  // namespace

Raycaster::Raycaster(std::span<const std::array<Eigen::Vector3f, 3>> triangles)
    : device_(NewEmbreeDevice()), scene_(rtcNewScene(device_.get())) {
  const std::size_t vertices = 3 * triangles.size();
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                            3 * sizeof(float), vertices);
  void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                          3 * sizeof(unsigned), triangles.size());
  BULLETNAV_CHECK(positions != nullptr && indices != nullptr);
  std::memcpy(positions, static_cast<const void*>(triangles.data()), triangles.size_bytes());
  auto* first = static_cast<unsigned*>(indices);
  std::iota(first, first + vertices, 0u);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene_.get());
}

RayHit Raycaster::Cast(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = MakeRay(origin, direction, kInfinity);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {query.ray.tfar, static_cast<std::int32_t>(query.hit.primID)};
}

bool Raycaster::IsBlocked(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  RTCRay ray = MakeRay(from, to - from, 1.0f);
  rtcOccluded1(scene_.get(), &context, &ray);
  return ray.tfar < 0.0f;
}

void Raycaster::CastPacket(const Eigen::Vector3f& origin,
                           const std::array<std::array<float, 16>, 3>& directions,
                           std::array<RayHit, 16>* hits) const {
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) std::array<int, 16> valid{};
  valid.fill(-1);
  RTCRayHit16 query;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
  for (std::size_t i = 0; i < 16; ++i) {
    query.ray.org_x[i] = origin.x();
    query.ray.org_y[i] = origin.y();
    query.ray.org_z[i] = origin.z();
    query.ray.dir_x[i] = directions[0][i];
    query.ray.dir_y[i] = directions[1][i];
    query.ray.dir_z[i] = directions[2][i];
    query.ray.tnear[i] = 0.0f;
    query.ray.tfar[i] = kInfinity;
    query.ray.time[i] = 0.0f;
    query.ray.mask[i] = ~0u;
    query.ray.flags[i] = 0;
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect16(valid.data(), scene_.get(), &context, &query);
  for (std::size_t i = 0; i < 16; ++i) {
    const bool hit = query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    (*hits)[i] = {hit ? query.ray.tfar[i] : 0.0f,
                  hit ? static_cast<std::int32_t>(query.hit.primID[i]) : -1};
  }
}

}  // namespace bulletnav::sim
