// SPDX-License-Identifier: MIT
#include "sim/house/shell/door_leaf.h"

#include <algorithm>

#include "sim/house/shell/faces.h"

namespace bulletnav::sim::shell {
namespace {

constexpr float kGap = 0.008f;         // around a leaf in its frame
constexpr float kStile = 0.11f;        // width of the boards around panels
constexpr float kGroove = 0.014f;      // around a raised field
constexpr float kFieldDepth = 0.007f;  // how far it stands out
constexpr float kHandleHeight = 1.02f;

/// A raised field in a dark groove.
void AddField(const Surface& surface, const Panel& field, MeshBuilder* builder) {
  Surface groove = surface;
  for (std::uint8_t& value : groove.tint) value = static_cast<std::uint8_t>(value * 0.72);
  AddPanel(groove, field, 0.001f, builder);
  AddBoard(surface,
           {field.x0 + kGroove, field.y0 + kGroove, field.x1 - kGroove, field.y1 - kGroove}, 0.0f,
           kFieldDepth, Grain::kUpright, builder);
}

/// Low and high fields; in two columns if the leaf is wide.
void AddFields(const Surface& surface, float width, float height, MeshBuilder* builder) {
  const float middle = 0.45f * height;
  const int columns = width > 0.85f ? 2 : 1;
  const float share = (width - kStile) / static_cast<float>(columns);
  for (int i = 0; i < columns; ++i) {
    const float x0 = kStile + share * static_cast<float>(i);
    const float x1 = x0 + share - kStile;
    AddField(surface, {x0, 0.18f, x1, middle - 0.5f * kStile}, builder);
    AddField(surface, {x0, middle + 0.5f * kStile, x1, height - kStile}, builder);
  }
}

/// Plate and lever; the free edge is at x = `edge`, the hinge towards `inwards` (-1 or 1).
void AddHandle(const Surface& surface, float edge, float inwards, MeshBuilder* builder) {
  const float x = edge + 0.065f * inwards;
  AddBoard(surface, {x - 0.02f, kHandleHeight - 0.11f, x + 0.02f, kHandleHeight + 0.06f}, 0.0f,
           0.006f, Grain::kUpright, builder);
  AddBoard(surface, {x - 0.009f, kHandleHeight - 0.009f, x + 0.009f, kHandleHeight + 0.009f},
           0.006f, 0.05f, Grain::kUpright, builder);
  const float tip = x + 0.12f * inwards;
  AddBar(
      surface,
      {std::min(x, tip) - 0.009f, kHandleHeight - 0.009f, std::max(x, tip), kHandleHeight + 0.009f},
      0.035f, 0.05f, Grain::kLevel, builder);
}

}  // namespace

void AddLeaf(const HouseStyle& style, const Opening& door, MeshBuilder* builder) {
  const bool is_entry = door.room_b < 0;
  const Surface& surface = is_entry ? style.entry_door : style.door;
  const auto leaf = LeafOutline(door);
  const float width = (leaf[1] - leaf[0]).norm();
  const float height = door.top - kGap;
  const float half = 0.5f * kLeafThickness;
  const PlanPoint hinge = 0.5f * (leaf[0] + leaf[3]);
  const PlanPoint tip = 0.5f * (leaf[1] + leaf[2]);
  {
    const MeshBuilder::Frame frame(builder, FaceFrame(hinge, tip));
    AddBar(surface, {kGap, kGap, width - kGap, height}, -half, half, Grain::kUpright, builder);
  }
  // Each face from its own side: the hinge is to the left on one of them, to the right on the
  // other.
  for (const bool hinge_is_left : {true, false}) {
    const MeshBuilder::Frame side(builder,
                                  hinge_is_left ? FaceFrame(hinge, tip) : FaceFrame(tip, hinge));
    const MeshBuilder::Frame face(builder, Vec(0.0f, 0.0f, half));
    if (style.has_panelled_doors || is_entry) {
      AddFields(surface, width, height, builder);
    }
    AddHandle(style.handle, hinge_is_left ? width : 0.0f, hinge_is_left ? -1.0f : 1.0f, builder);
  }
}

}  // namespace bulletnav::sim::shell
