// SPDX-License-Identifier: MIT
#include "sim/physics/capsule_body.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

constexpr float kSkin = 0.002f;       // gap kept to whatever stops a sweep
constexpr float kTouch = 0.001f;      // nearer than the radius by this is still free
constexpr float kSettleReach = 0.5f;  // how far Reset looks for the floor
constexpr int kMaxRounds = 6;         // of sweeping and sliding in one move
constexpr int kPushes = 12;
constexpr int kLedgeHalvings = 5;
constexpr float kShortest = 1e-5f;
constexpr float kClimbed = 0.01f;

std::string Where(const Eigen::Vector3f& p) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", p.x(), p.y(), p.z());
}

}  // namespace

void BodySpec::Validate() const {
  if (!std::isfinite(radius + height + camera_height + max_climb)) {
    throw Error("a body's lengths must be finite");
  }
  if (!(radius > 0.0f && camera_height > 0.0f && max_climb >= 0.0f)) {
    throw Error("a body's radius, camera_height and max_climb must be positive");
  }
  if (!(height >= max_climb + 2.0f * radius)) {
    throw Error("a body's height must be at least max_climb + 2 * radius");
  }
  if (!(max_slope_deg >= 0.0f && max_slope_deg < 90.0f)) {
    throw Error("max_slope_deg must lie between 0 and 90");
  }
}

CapsuleBody::CapsuleBody(const PhysicsWorld& world, const BodySpec& spec)
    : world_(world), spec_(spec) {
  spec_.Validate();
}

Capsule CapsuleBody::Torso(const Eigen::Vector3f& foot) const {
  return {foot + Eigen::Vector3f(0, spec_.max_climb + spec_.radius, 0),
          spec_.height - spec_.max_climb - 2.0f * spec_.radius, spec_.radius};
}

std::optional<float> CapsuleBody::FloorUnder(const Eigen::Vector3f& foot, float above,
                                             float below) const {
  const auto least_up = static_cast<float>(Cos(DegToRad(spec_.max_slope_deg)));
  const Eigen::Vector3f down(0, -(above + below), 0);
  // The centre decides; where it looks into a crack or over an edge, the foot around it does.
  const float toe = 0.5f * spec_.radius;
  const std::array offsets = {Eigen::Vector2f(0, 0), Eigen::Vector2f(toe, 0),
                              Eigen::Vector2f(-toe, 0), Eigen::Vector2f(0, toe),
                              Eigen::Vector2f(0, -toe)};
  for (const Eigen::Vector2f& offset : offsets) {
    const Eigen::Vector3f top = foot + Eigen::Vector3f(offset.x(), above, offset.y());
    const auto hit = world_.RayTest(top, top + down);
    if (hit && std::abs(hit->normal.y()) >= least_up) return top.y() + hit->fraction * down.y();
  }
  return std::nullopt;
}

bool CapsuleBody::IsFree(const Eigen::Vector3f& foot) const {
  return !world_.Nearest(Torso(foot), spec_.radius - kTouch).has_value();
}

Eigen::Vector3f CapsuleBody::PushOut(const Eigen::Vector3f& foot) const {
  Eigen::Vector3f pushed = foot;
  for (int i = 0; i < kPushes; ++i) {
    const auto nearest = world_.Nearest(Torso(pushed), spec_.radius);
    if (!nearest) break;
    Eigen::Vector3f away = nearest->on_axis - nearest->on_scene;
    away.y() = 0.0f;
    if (away.norm() < kShortest) break;
    pushed += (spec_.radius + kSkin - nearest->distance) * away.normalized();
    if ((pushed - foot).norm() > spec_.radius) break;
  }
  return pushed;
}

std::optional<BodyPose> CapsuleBody::TryReset(const BodyPose& wanted) {
  try {
    Reset(wanted);
  } catch (const PoseError&) {
    return std::nullopt;
  }
  return pose();
}

void CapsuleBody::Reset(const BodyPose& pose) {
  const Eigen::Vector3f wanted = pose.position.cast<float>();
  if (!wanted.allFinite() || !std::isfinite(pose.yaw)) throw PoseError("the pose is not finite");
  Eigen::Vector3f foot = wanted;
  // The nearest floor first: under a table the table's top is a floor too.
  std::optional<float> floor = FloorUnder(foot, spec_.max_climb, spec_.max_climb);
  if (!floor) floor = FloorUnder(foot, kSettleReach, kSettleReach);
  if (!floor) {
    throw PoseError("there is no floor within 0.5 m of " + Where(wanted) +
                    "; choose a pose inside the scene");
  }
  foot.y() = *floor;
  const Eigen::Vector3f pushed = PushOut(foot);
  if (!IsFree(pushed) || world_.AxisCrosses(Torso(foot), pushed - foot)) {
    throw PoseError("the body does not fit at " + Where(wanted) +
                    ": it would stand inside a wall or furniture; choose a free pose");
  }
  floor = FloorUnder(pushed, spec_.max_climb, spec_.max_climb);
  if (!floor) {
    throw PoseError("there is no floor beside the wall at " + Where(wanted) +
                    "; choose a pose inside the scene");
  }
  // The floor there may lie higher or lower than the one the body was pushed away on.
  const Eigen::Vector3f standing(pushed.x(), *floor, pushed.z());
  if (!IsFree(standing)) {
    throw PoseError("the body does not fit at " + Where(wanted) +
                    ": beside the wall the floor changes its height; choose a free pose");
  }
  pose_.position = standing.cast<double>();
  pose_.yaw = WrapAngle(pose.yaw);
}

bool CapsuleBody::Walk(const Eigen::Vector3f& motion, Eigen::Vector3f* foot) const {
  const auto stand = [&](float share) -> std::optional<Eigen::Vector3f> {
    Eigen::Vector3f at = *foot + share * motion;
    const auto floor = FloorUnder(at, spec_.max_climb, spec_.max_climb);
    if (!floor) return std::nullopt;
    at.y() = *floor;
    return at;
  };
  std::optional<Eigen::Vector3f> end = stand(1.0f);
  bool got_there = end.has_value();
  float reached = 0.0f;
  float step = 0.5f;
  for (int i = 0; !got_there && i < kLedgeHalvings; ++i, step *= 0.5f) {
    if (const auto nearer = stand(reached + step)) {
      end = nearer;
      reached += step;
    }
  }
  if (!end) return false;
  // Bullet's sweep is not exact; what it allows must hold: no wall between, and no deeper in one.
  if (world_.AxisCrosses(Torso(*foot), *end - *foot)) return false;
  const auto after = world_.Nearest(Torso(*end), spec_.radius - kTouch);
  if (after) {
    const auto before = world_.Nearest(Torso(*foot), spec_.radius - kTouch);
    if (!before || after->distance < before->distance) return false;
  }
  *foot = *end;
  return got_there;
}

MoveResult CapsuleBody::Move(const PlanarPose& motion) {
  MoveResult result;
  Eigen::Vector3f foot = pose_.position.cast<float>();
  Eigen::Vector3f left = (motion.x * pose_.forward() + motion.y * pose_.left()).cast<float>();
  Eigen::Vector3f last_normal = Eigen::Vector3f::Zero();
  for (int round = 0; round < kMaxRounds && left.norm() > kShortest; ++round) {
    const float length = left.norm();
    const auto hit = world_.Sweep(Torso(foot), left * ((length + kSkin) / length));
    const float travel = hit ? std::max(0.0f, hit->fraction * (length + kSkin) - kSkin) : length;
    const Eigen::Vector3f step = left * (travel / length);
    const float height_before = foot.y();
    const bool arrived = Walk(step, &foot);
    if (arrived && travel >= length) break;
    left -= step;
    // Half way up a stair the next riser looks like a wall until the body has climbed.
    if (arrived && foot.y() > height_before + kClimbed) continue;
    ++result.contacts;
    Eigen::Vector3f normal = hit ? hit->normal : Eigen::Vector3f::Zero();
    normal.y() = 0.0f;
    if (!arrived || !spec_.sliding || normal.norm() < 1e-3f) break;
    normal.normalize();
    left -= std::min(0.0f, left.dot(normal)) * normal;
    if (left.dot(last_normal) < 0.0f) break;  // a corner: nowhere to slide
    last_normal = normal;
  }
  result.collided = result.contacts > 0;
  pose_.position = foot.cast<double>();
  pose_.yaw = WrapAngle(pose_.yaw + motion.yaw);
  return result;
}

}  // namespace bulletnav::sim
