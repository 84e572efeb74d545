// SPDX-License-Identifier: MIT
#include "sim/physics/physics_world.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <btBulletCollisionCommon.h>

#include "sim/base/error.h"
#include "sim/math/segment_triangle.h"

namespace bulletnav::sim {
namespace {

// Bullet thickens triangles by its collision margin, 4 cm by default; the capsule has its radius.
constexpr float kMargin = 0.0f;

btVector3 ToBullet(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}
Eigen::Vector3f FromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
Eigen::Vector3d ToDouble(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Keeps the first contact that the motion runs against; grazing ones are not obstacles.
class FirstAgainst : public btCollisionWorld::ConvexResultCallback {
 public:
  explicit FirstAgainst(const btVector3& motion) : motion_(motion) {}

  btScalar addSingleResult(btCollisionWorld::LocalConvexResult& result, bool) override {
    btVector3 normal = result.m_hitNormalLocal;
    if (normal.dot(motion_) > -1e-4f * motion_.length()) return m_closestHitFraction;
    m_closestHitFraction = result.m_hitFraction;
    normal_ = normal.normalized();
    return m_closestHitFraction;
  }
  const btVector3& normal() const { return normal_; }

 private:
  btVector3 motion_;
  btVector3 normal_{0, 0, 0};
};

/// Calls a function with every triangle near a box.
class ForTriangle : public btTriangleCallback {
 public:
  explicit ForTriangle(std::function<void(const Triangle3d&)> visit) : visit_(std::move(visit)) {}
  void processTriangle(btVector3* t, int, int) override {
    visit_({ToDouble(t[0]), ToDouble(t[1]), ToDouble(t[2])});
  }

 private:
  std::function<void(const Triangle3d&)> visit_;
};

std::vector<float> Flatten(const std::vector<Eigen::Vector3f>& points) {
  std::vector<float> flat;
  flat.reserve(3 * points.size());
  for (const Eigen::Vector3f& p : points) flat.insert(flat.end(), {p.x(), p.y(), p.z()});
  return flat;
}

std::vector<int> Flatten(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<int> flat;
  flat.reserve(3 * triangles.size());
  for (const auto& t : triangles) {
    for (const std::uint32_t v : t) flat.push_back(static_cast<int>(v));
  }
  return flat;
}

}  // namespace

/// Members in the order in which Bullet needs them: each refers to the one before.
struct PhysicsWorld::Impl {
  explicit Impl(const SceneMesh& mesh)
      : vertices(Flatten(mesh.positions)),
        indices(Flatten(mesh.triangles)),
        arrays(static_cast<int>(mesh.triangles.size()), indices.data(), 3 * sizeof(int),
               static_cast<int>(mesh.positions.size()), vertices.data(), 3 * sizeof(float)),
        shape(&arrays, /*useQuantizedAabbCompression=*/true) {
    shape.setMargin(kMargin);
    object.setCollisionShape(&shape);
  }

  void ForTrianglesIn(const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                      std::function<void(const Triangle3d&)> visit) const {
    ForTriangle callback(std::move(visit));
    shape.processAllTriangles(&callback, ToBullet(low), ToBullet(high));
  }

  std::vector<float> vertices;
  std::vector<int> indices;
  btTriangleIndexVertexArray arrays;
  btBvhTriangleMeshShape shape;
  btCollisionObject object;
};

PhysicsWorld::PhysicsWorld(const SceneMesh& mesh) {
  if (mesh.triangles.empty()) throw Error("a scene without triangles has no physics");
  impl_ = std::make_unique<Impl>(mesh);
}

PhysicsWorld::~PhysicsWorld() = default;

std::optional<SweepHit> PhysicsWorld::RayTest(const Eigen::Vector3f& from,
                                              const Eigen::Vector3f& to) const {
  const btVector3 a = ToBullet(from);
  const btVector3 b = ToBullet(to);
  btCollisionWorld::ClosestRayResultCallback result(a, b);
  btCollisionWorld::rayTestSingle(btTransform(btQuaternion::getIdentity(), a),
                                  btTransform(btQuaternion::getIdentity(), b),
                                  const_cast<btCollisionObject*>(&impl_->object), &impl_->shape,
                                  btTransform::getIdentity(), result);
  if (!result.hasHit()) return std::nullopt;
  return SweepHit{result.m_closestHitFraction, FromBullet(result.m_hitNormalWorld)};
}

std::optional<SweepHit> PhysicsWorld::Sweep(const Capsule& capsule,
                                            const Eigen::Vector3f& motion) const {
  const btCapsuleShape shape(capsule.radius, capsule.length);
  const Eigen::Vector3f centre = capsule.low + Eigen::Vector3f(0, 0.5f * capsule.length, 0);
  const btTransform from(btQuaternion::getIdentity(), ToBullet(centre));
  const btTransform to(btQuaternion::getIdentity(), ToBullet(centre + motion));
  FirstAgainst result(ToBullet(motion));
  btCollisionWorld::objectQuerySingle(&shape, from, to,
                                      const_cast<btCollisionObject*>(&impl_->object), &impl_->shape,
                                      btTransform::getIdentity(), result, 0.0f);
  if (result.m_closestHitFraction >= 1.0f) return std::nullopt;
  return SweepHit{result.m_closestHitFraction, FromBullet(result.normal())};
}

std::optional<NearestPoint> PhysicsWorld::Nearest(const Capsule& capsule, float reach) const {
  const Eigen::Vector3f high = capsule.low + Eigen::Vector3f(0, capsule.length, 0);
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(reach);
  std::optional<NearestPoint> nearest;
  impl_->ForTrianglesIn(capsule.low - margin, high + margin, [&](const Triangle3d& triangle) {
    const ClosestPoints c =
        SegmentToTriangle(capsule.low.cast<double>(), high.cast<double>(), triangle);
    if (c.distance >= (nearest ? nearest->distance : reach)) return;
    nearest =
        NearestPoint{c.on_a.cast<float>(), c.on_b.cast<float>(), static_cast<float>(c.distance)};
  });
  return nearest;
}

bool PhysicsWorld::AxisCrosses(const Capsule& capsule, const Eigen::Vector3f& motion) const {
  const Eigen::Vector3d up(0, capsule.length, 0);
  const Eigen::Vector3d a = capsule.low.cast<double>();
  const Eigen::Vector3d b = a + motion.cast<double>();
  const Triangle3d swept[2] = {{a, b, b + up}, {a, b + up, a + up}};
  const Eigen::Vector3f end = capsule.low + motion;
  const Eigen::Vector3f rise(0, capsule.length, 0);
  bool crosses = false;
  impl_->ForTrianglesIn(
      capsule.low.cwiseMin(end), capsule.low.cwiseMax(end) + rise, [&](const Triangle3d& triangle) {
        crosses =
            crosses || TrianglesCross(triangle, swept[0]) || TrianglesCross(triangle, swept[1]);
      });
  return crosses;
}

}  // namespace bulletnav::sim
