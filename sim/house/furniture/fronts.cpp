// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kGap = 0.007f;     // half the dark line between two fronts
constexpr float kProud = 0.016f;   // how far a front stands out of its body
constexpr float kHandle = 0.022f;  // thickness

void Field(PieceMaker& m, const Surface& surface, const FrontField& f) {
  m.Quad(surface, {f.x0, f.y0, f.z}, {f.x1, f.y0, f.z}, {f.x1, f.y1, f.z}, {f.x0, f.y1, f.z});
}

/// The leaf of a door or drawer, without its handle.
void FrontLeaf(PieceMaker& m, const Surface& surface, const FrontField& field) {
  FrontField f = {field.x0 + kGap, field.x1 - kGap, field.y0 + kGap, field.y1 - kGap,
                  field.z + kProud};
  Field(m, surface, f);
  const float frame = std::min({0.07f, 0.3f * (f.x1 - f.x0), 0.3f * (f.y1 - f.y0)});
  if (!m.palette().framed_fronts || frame < 0.035f) return;
  Field(m, Shaded(surface, 0.72f),
        {f.x0 + frame, f.x1 - frame, f.y0 + frame, f.y1 - frame, f.z + 0.002f});
  constexpr float kShadow = 0.014f;
  Field(m, Shaded(surface, 0.93f),
        {f.x0 + frame + kShadow, f.x1 - frame, f.y0 + frame, f.y1 - frame - kShadow, f.z + 0.004f});
}

void Handle(PieceMaker& m, const Vec& at, float length, bool upright) {
  switch (m.palette().handles) {
    case Handles::kBar: {
      const Vec half =
          upright ? Vec(0.5f * kHandle, 0.5f * length, 0) : Vec(0.5f * length, 0.5f * kHandle, 0);
      Panel(m, m.palette().metal, at - half, at + half + Vec(0, 0, 0.03f));
      break;
    }
    case Handles::kKnob: {
      const Vec half(0.018f, 0.018f, 0);
      Panel(m, m.palette().metal, at - half, at + half + Vec(0, 0, 0.03f));
      break;
    }
    case Handles::kNone:
      break;
  }
}

}  // namespace

void Doors(PieceMaker& m, const Surface& surface, const FrontField& field, int count,
           HandleAt handle) {
  const float width = (field.x1 - field.x0) / static_cast<float>(count);
  const float tall = field.y1 - field.y0;
  const float length = std::clamp(0.25f * tall, 0.1f, 0.3f);
  float y = 0.5f * (field.y0 + field.y1);
  if (handle == HandleAt::kTop) y = field.y1 - 0.5f * length - 0.05f;
  if (handle == HandleAt::kBottom) y = field.y0 + 0.5f * length + 0.05f;
  for (int i = 0; i < count; ++i) {
    FrontField one = field;
    one.x0 = field.x0 + static_cast<float>(i) * width;
    one.x1 = one.x0 + width;
    FrontLeaf(m, surface, one);
    const bool opens_left = i % 2 == 1;
    const float x = opens_left ? one.x0 + 0.045f : one.x1 - 0.045f;
    Handle(m, {x, y, field.z + kProud}, length, true);
  }
}

void Drawers(PieceMaker& m, const Surface& surface, const FrontField& field, int rows) {
  const float height = (field.y1 - field.y0) / static_cast<float>(rows);
  const float width = field.x1 - field.x0;
  for (int i = 0; i < rows; ++i) {
    FrontField one = field;
    one.y0 = field.y0 + static_cast<float>(i) * height;
    one.y1 = one.y0 + height;
    FrontLeaf(m, surface, one);
    const float y = 0.5f * (one.y0 + one.y1) + 0.12f * height;
    const float z = field.z + kProud + 0.004f;
    if (m.palette().handles == Handles::kKnob && width > 0.6f) {
      Handle(m, {field.x0 + 0.25f * width, y, z}, 0.0f, false);
      Handle(m, {field.x1 - 0.25f * width, y, z}, 0.0f, false);
    } else {
      Handle(m, {0.5f * (field.x0 + field.x1), y, z}, std::clamp(0.35f * width, 0.1f, 0.3f), false);
    }
  }
}

}  // namespace bulletnav::sim::furniture
