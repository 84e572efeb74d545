// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/floor_plan.h"
#include "sim/house/mesh_builder.h"

namespace bulletnav::sim::shell {

using Vec = MeshBuilder::Vec;

/// How far walls, floors and ceilings run on behind each other, metres.
inline constexpr float kOverlap = 0.02f;
inline constexpr float kCasingWidth = 0.07f;
inline constexpr float kCasingDepth = 0.018f;

/// Frame of an upright face seen from its front: x from its left end to its right, y up from the
/// floor, z towards the viewer.
Eigen::Affine3f FaceFrame(const PlanPoint& left, const PlanPoint& right);

/// Rectangle in the plane z of the current frame, facing +z.
struct Panel {
  float x0 = 0.0f;
  float y0 = 0.0f;
  float x1 = 0.0f;
  float y1 = 0.0f;
};
void AddPanel(const Surface& surface, const Panel& panel, float z, MeshBuilder* builder);

enum class Grain { kUpright, kLevel };

/// A board on the wall: front and edges, without a back. From z0 (the wall) to z1.
void AddBoard(const Surface& surface, const Panel& panel, float z0, float z1, Grain grain,
              MeshBuilder* builder);

/// A board seen from both sides.
void AddBar(const Surface& surface, const Panel& panel, float z0, float z1, Grain grain,
            MeshBuilder* builder);

/// What is added to the sides of a hole: faces that look into it, from z0 back to z1 < z0, at `by`
/// outside its edges.
struct Reveal {
  Panel hole;
  float z0 = 0.0f;
  float z1 = 0.0f;
  float by = 0.0f;
  bool has_bottom = false;
};
void AddReveal(const Surface& surface, const Reveal& reveal, MeshBuilder* builder);

}  // namespace bulletnav::sim::shell
