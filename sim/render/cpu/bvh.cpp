// SPDX-License-Identifier: MIT
#include "sim/render/cpu/bvh.h"

#include <algorithm>
#include <limits>

#include "sim/base/check.h"
#include "sim/render/cpu/device.h"

namespace bulletnav::sim {
namespace {

using Triangles = Bvh::Triangles;

/// What Embree's builder makes through our callbacks, in its own arena; flattened afterwards.
struct BuiltNode {
  unsigned count = 0;  // of children, or of triangles in a leaf
  bool is_leaf = false;
  std::array<const BuiltNode*, kBvhWidth> children{};
  std::array<RTCBounds, kBvhWidth> bounds{};
  std::array<unsigned, kBvhWidth> triangles{};
};

BuiltNode* NewNode(RTCThreadLocalAllocator arena) {
  void* memory = rtcThreadLocalAlloc(arena, sizeof(BuiltNode), alignof(BuiltNode));
  return new (memory) BuiltNode;  // NOLINT(cppcoreguidelines-owning-memory): Embree's arena owns it
}

void* CreateNode(RTCThreadLocalAllocator arena, unsigned count, void*) {
  BuiltNode* node = NewNode(arena);
  node->count = count;
  return node;
}

void SetChildren(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) {
    static_cast<BuiltNode*>(node)->children[i] = static_cast<const BuiltNode*>(children[i]);
  }
}

void SetBounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<BuiltNode*>(node)->bounds[i] = *bounds[i];
}

void* CreateLeaf(RTCThreadLocalAllocator arena, const RTCBuildPrimitive* primitives,
                 std::size_t count, void*) {
  BULLETNAV_CHECK_LE(count, std::size_t{kBvhWidth});
  BuiltNode* node = NewNode(arena);
  node->is_leaf = true;
  node->count = static_cast<unsigned>(count);
  for (std::size_t i = 0; i < count; ++i) node->triangles[i] = primitives[i].primID;
  return node;
}

std::vector<RTCBuildPrimitive> MakePrimitives(Triangles triangles) {
  std::vector<RTCBuildPrimitive> primitives(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const Eigen::Vector3f low = a.cwiseMin(b).cwiseMin(c);
    const Eigen::Vector3f high = a.cwiseMax(b).cwiseMax(c);
    RTCBuildPrimitive& p = primitives[t];
    p.lower_x = low.x();
    p.lower_y = low.y();
    p.lower_z = low.z();
    p.upper_x = high.x();
    p.upper_y = high.y();
    p.upper_z = high.z();
    p.geomID = 0;
    p.primID = static_cast<unsigned>(t);
  }
  return primitives;
}

const BuiltNode* Build(RTCBVH bvh, std::vector<RTCBuildPrimitive>* primitives) {
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.byteSize = sizeof(arguments);
  arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
  arguments.maxBranchingFactor = kBvhWidth;
  arguments.maxDepth = 256;
  arguments.sahBlockSize = kBvhWidth;
  // Full leaves matter more to the sweep than tight ones: measured in docs/rendering.md.
  arguments.minLeafSize = kBvhWidth;
  arguments.maxLeafSize = kBvhWidth;
  arguments.bvh = bvh;
  arguments.primitives = primitives->data();
  arguments.primitiveCount = primitives->size();
  arguments.primitiveArrayCapacity = primitives->size();
  arguments.createNode = CreateNode;
  arguments.setNodeChildren = SetChildren;
  arguments.setNodeBounds = SetBounds;
  arguments.createLeaf = CreateLeaf;
  const auto* root = static_cast<const BuiltNode*>(rtcBuildBVH(&arguments));
  BULLETNAV_CHECK(root != nullptr);
  return root;
}

class Flattener {
 public:
  /// `first`: the number of the first triangle that the tree was built over.
  Flattener(Triangles triangles, std::size_t first, Bvh* bvh)
      : triangles_(triangles), first_(first), bvh_(*bvh) {}

  /// Returns the reference a parent stores.
  std::int32_t Add(const BuiltNode& built) {
    return built.is_leaf ? ~AddLeaf(built) : AddNode(built);
  }

  std::int32_t AddNode(const BuiltNode& built) {
    const auto index = static_cast<std::int32_t>(bvh_.nodes.size());
    bvh_.nodes.emplace_back();
    BvhNode node{};
    node.count = static_cast<std::int32_t>(built.count);
    for (unsigned i = 0; i < kBvhWidth; ++i) {
      const bool used = i < built.count;
      SetBox(used ? built.bounds[i] : EmptyBox(), i, &node);
      if (used) node.child[i] = Add(*built.children[i]);
    }
    bvh_.nodes[static_cast<std::size_t>(index)] = node;
    return index;
  }

 private:
  static RTCBounds EmptyBox() {
    RTCBounds box{};
    constexpr float kFar = std::numeric_limits<float>::max() / 4;
    box.lower_x = box.lower_y = box.lower_z = kFar;
    box.upper_x = box.upper_y = box.upper_z = -kFar;
    return box;
  }

  static void SetBox(const RTCBounds& box, unsigned i, BvhNode* node) {
    node->low[0][i] = box.lower_x;
    node->low[1][i] = box.lower_y;
    node->low[2][i] = box.lower_z;
    node->high[0][i] = box.upper_x;
    node->high[1][i] = box.upper_y;
    node->high[2][i] = box.upper_z;
  }

  std::int32_t AddLeaf(const BuiltNode& built) {
    BvhLeaf leaf{};
    leaf.count = static_cast<std::int32_t>(built.count);
    for (unsigned i = 0; i < kBvhWidth; ++i) {
      const std::size_t t = first_ + built.triangles[std::min(i, built.count - 1)];
      leaf.id[i] = static_cast<std::int32_t>(t);
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3f& corner = triangles_[t][k];
        for (int axis = 0; axis < 3; ++axis) leaf.corner[k][axis][i] = corner[axis];
      }
    }
    bvh_.leaves.push_back(leaf);
    return static_cast<std::int32_t>(bvh_.leaves.size()) - 1;
  }

  Triangles triangles_;
  std::size_t first_;
  Bvh& bvh_;
};

}  // namespace

Bvh::Bvh(Triangles triangles) {
  BULLETNAV_CHECK(!triangles.empty());
  const EmbreeDevice device = NewEmbreeDevice();
  const EmbreeBvh built(rtcNewBVH(device.get()));
  std::vector<RTCBuildPrimitive> primitives = MakePrimitives(triangles);
  const BuiltNode* root = Build(built.get(), &primitives);
  Flattener flattener(triangles, 0, this);
  if (!root->is_leaf) {
    flattener.AddNode(*root);
    return;
  }
  BuiltNode top;
  top.count = 1;
  top.children[0] = root;
  Eigen::Vector3f low = triangles[0][0];
  Eigen::Vector3f high = low;
  for (const auto& triangle : triangles) {
    for (const Eigen::Vector3f& p : triangle) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  top.bounds[0] = {low.x(), low.y(), low.z(), 0.0f, high.x(), high.y(), high.z(), 0.0f};
  flattener.AddNode(top);
}

std::int32_t Bvh::Graft(Triangles triangles, std::size_t first) {
  BULLETNAV_CHECK_LT(first, triangles.size());
  const EmbreeDevice device = NewEmbreeDevice();
  const EmbreeBvh built(rtcNewBVH(device.get()));
  std::vector<RTCBuildPrimitive> primitives = MakePrimitives(triangles.subspan(first));
  return Flattener(triangles, first, this).Add(*Build(built.get(), &primitives));
}

std::int32_t Bvh::AddDetail(std::int32_t fine, std::int32_t coarse, float error) {
  BvhNode node{};
  node.count = kDetailNode;
  node.child[0] = fine;
  node.child[1] = coarse;
  node.low[0][0] = error;
  nodes.push_back(node);
  return static_cast<std::int32_t>(nodes.size()) - 1;
}

}  // namespace bulletnav::sim
