// SPDX-License-Identifier: MIT
#include "sim/house/shell/pits.h"

#include <algorithm>
#include <cmath>

#include "sim/house/shell/faces.h"

namespace bulletnav::sim::shell {
namespace {

constexpr float kSlab = 0.28f;     // what of a side is the storey's own floor
constexpr float kTread = 0.28f;    // from step to step
constexpr float kRise = 0.17f;     // of a flight that goes up
constexpr float kLanding = 0.95f;  // at a flight's end
constexpr float kRailHeight = 1.0f;
constexpr float kRailDepth = 0.05f;
constexpr float kHeadRoom = 1.1f;  // between the upper landing and the ceiling, at least

const Surface kConcrete{"concrete"};

/// One pit in its own frame: x from `corner` along the near edge, z into it, y up.
class PitBuilder {
 public:
  PitBuilder(const Pit& pit, const RoomStyle& style, float ceiling, MeshBuilder* builder)
      : pit_(pit), style_(style), ceiling_(ceiling), builder_(*builder) {
    is_mirrored_ = pit.across.x() * pit.into.y() - pit.across.y() * pit.into.x() < 0.0f;
  }

  void Build() {
    const MeshBuilder::Frame frame(&builder_, LocalFrame());
    AddSides();
    const bool has_both = pit_.goes_up && pit_.first_drop > 0.0f;
    const float split = has_both ? 0.5f * pit_.width : (pit_.goes_up ? 0.0f : pit_.width);
    if (pit_.first_drop > 0.0f) AddFlightDown(split);
    if (pit_.goes_up) AddFlightUp(split);
    AddRails(split);
  }

 private:
  Eigen::Affine3f LocalFrame() const {
    const PlanPoint x = is_mirrored_ ? PlanPoint(-pit_.across) : pit_.across;
    const PlanPoint at =
        is_mirrored_ ? PlanPoint(pit_.corner + pit_.width * pit_.across) : pit_.corner;
    Eigen::Affine3f frame = Eigen::Affine3f::Identity();
    frame.linear().col(0) = Vec(x.x(), 0.0f, x.y());
    frame.linear().col(2) = Vec(pit_.into.x(), 0.0f, pit_.into.y());
    frame.translation() = Vec(at.x(), 0.0f, at.y());
    return frame;
  }

  /// A box whose x is counted from `corner`.
  void Box(const Surface& surface, const Vec& low, const Vec& high) {
    if (!is_mirrored_) return builder_.Box(surface, low, high);
    builder_.Box(surface, {pit_.width - high.x(), low.y(), low.z()},
                 {pit_.width - low.x(), high.y(), high.z()});
  }

  void AddRing(const Surface& surface, float low, float high) {
    const float w = pit_.width;
    const float l = pit_.length;
    builder_.Quad(surface, {0, low, 0}, {w, low, 0}, {w, high, 0}, {0, high, 0});
    builder_.Quad(surface, {w, low, l}, {0, low, l}, {0, high, l}, {w, high, l});
    builder_.Quad(surface, {0, low, l}, {0, low, 0}, {0, high, 0}, {0, high, l});
    builder_.Quad(surface, {w, low, 0}, {w, low, l}, {w, high, l}, {w, high, 0});
  }

  void AddSides() {
    const float low = -pit_.depth;
    AddRing(kConcrete, -kSlab, 0.0f);
    AddRing(style_.walls.upper, low, -kSlab);
    builder_.Quad(kConcrete, {0, low, 0}, {0, low, pit_.length}, {pit_.width, low, pit_.length},
                  {pit_.width, low, 0});
  }

  /// Solid steps from the near edge down to the pit's floor, on its side of edge 2.
  void AddFlightDown(float width) {
    const auto most = std::max(1, static_cast<int>((pit_.length - kLanding) / kTread));
    const float fall = pit_.depth - pit_.first_drop;
    const auto steps = std::clamp(static_cast<int>(std::lround(fall / 0.19f)), 1, most);
    const float rise = fall / static_cast<float>(steps);
    for (int i = 0; i < steps; ++i) {
      const float y = -pit_.first_drop - rise * static_cast<float>(i);
      const float z = kTread * static_cast<float>(i);
      Box(kConcrete, {0, -pit_.depth, z}, {width, y, z + kTread});
    }
  }

  /// Steps over the pit up to a landing at its far end.
  void AddFlightUp(float from) {
    const float room = ceiling_ - kHeadRoom;
    const auto most = static_cast<int>((pit_.length - kLanding) / kTread);
    const int steps = std::clamp(static_cast<int>(room / kRise) - 1, 1, std::max(1, most));
    for (int i = 0; i < steps; ++i) {
      const float y = kRise * static_cast<float>(i + 1);
      const float z = kTread * static_cast<float>(i);
      Box(kConcrete, {from, std::max(y - 0.34f, -kSlab), z}, {pit_.width, y, z + kTread});
    }
    const float top = kRise * static_cast<float>(steps + 1);
    const float end = kTread * static_cast<float>(steps);
    if (pit_.length - end < 0.3f) return;
    Box(kConcrete, {0, top - 0.2f, end}, {pit_.width, top, pit_.length});
  }

  void AddRails(float split) {
    const float w = pit_.width;
    const float l = pit_.length;
    const float d = kRailDepth;
    if (pit_.rails[0]) {
      AddRail({0, 0, 0}, {w, 0, d});
    } else if (pit_.goes_up) {
      AddRail({split, 0, 0}, {w, 0, d});
    }
    if (pit_.rails[1]) AddRail({0, 0, l - d}, {w, 0, l});
    if (pit_.rails[2]) AddRail({0, 0, 0}, {d, 0, l});
    if (pit_.rails[3]) AddRail({w - d, 0, 0}, {w, 0, l});
  }

  /// Along the longer side of the rectangle between two corners, hung on the slab's side.
  void AddRail(Vec low, Vec high) {
    constexpr float kPost = 0.04f;
    low.y() = -0.15f;
    high.y() = kRailHeight;
    const bool along_x = high.x() - low.x() > high.z() - low.z();
    const int axis = along_x ? 0 : 2;
    const float length = high[axis] - low[axis];
    const Surface& metal = style_.palette.metal;
    if (pit_.rail == Rail::kBoards) return Box(style_.palette.wood, low, high);
    const float pitch = pit_.rail == Rail::kBars ? 0.11f : 1.1f;
    const auto posts = std::max(1, static_cast<int>(std::ceil(length / pitch)));
    for (int i = 0; i <= posts; ++i) {
      Vec a = low + Vec(0.01f, 0.0f, 0.01f);
      Vec b = high - Vec(0.01f, 0.03f, 0.01f);
      const float thick = pit_.rail == Rail::kBars ? 0.016f : kPost;
      a[axis] = low[axis] + (length - thick) * static_cast<float>(i) / static_cast<float>(posts);
      b[axis] = a[axis] + thick;
      Box(metal, a, b);
    }
    if (pit_.rail == Rail::kGlass) {
      Vec a = low;
      Vec b = high;
      const int thin = 2 - axis;
      a[thin] += 0.018f;
      b[thin] -= 0.018f;
      b.y() -= 0.04f;
      Box({"glass"}, a, b);
    }
    Vec top = low;
    top.y() = kRailHeight - 0.04f;
    Box(pit_.rail == Rail::kBars ? metal : style_.palette.wood, top, high);
  }

  const Pit& pit_;
  const RoomStyle& style_;
  float ceiling_;
  MeshBuilder& builder_;
  bool is_mirrored_ = false;
};

}  // namespace

void AddPits(const FloorPlan& plan, const HouseStyle& style, MeshBuilder* builder) {
  for (const Pit& pit : plan.pits) {
    builder->BeginObject("pit", plan.rooms[static_cast<std::size_t>(pit.room)].name);
    PitBuilder(pit, style.rooms[static_cast<std::size_t>(pit.room)], plan.ceiling, builder).Build();
  }
}

}  // namespace bulletnav::sim::shell
