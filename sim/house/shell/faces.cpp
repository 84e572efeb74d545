// SPDX-License-Identifier: MIT
#include "sim/house/shell/faces.h"

namespace bulletnav::sim::shell {

Eigen::Affine3f FaceFrame(const PlanPoint& left, const PlanPoint& right) {
  const PlanPoint along = (right - left).normalized();
  Eigen::Affine3f frame = Eigen::Affine3f::Identity();
  frame.linear().col(0) = Vec(along.x(), 0.0f, along.y());
  frame.linear().col(1) = Vec::UnitY();
  frame.linear().col(2) = Vec(-along.y(), 0.0f, along.x());
  frame.translation() = Vec(left.x(), 0.0f, left.y());
  return frame;
}

void AddPanel(const Surface& surface, const Panel& p, float z, MeshBuilder* builder) {
  builder->Quad(surface, {p.x0, p.y0, z}, {p.x1, p.y0, z}, {p.x1, p.y1, z}, {p.x0, p.y1, z});
}

void AddBoard(const Surface& surface, const Panel& p, float z0, float z1, Grain grain,
              MeshBuilder* builder) {
  // The grain runs down a wood's picture; on a level board it is turned by a quarter.
  const bool turn = grain == Grain::kLevel;
  const Vec front = turn ? Vec(Vec::UnitY()) : Vec(Vec::UnitX());
  const Vec end = turn ? Vec(Vec::UnitZ()) : Vec(Vec::UnitX());
  builder->Quad(surface, {p.x0, p.y0, z1}, {p.x1, p.y0, z1}, {p.x1, p.y1, z1}, {p.x0, p.y1, z1},
                front);
  builder->Quad(surface, {p.x0, p.y0, z0}, {p.x0, p.y0, z1}, {p.x0, p.y1, z1}, {p.x0, p.y1, z0});
  builder->Quad(surface, {p.x1, p.y0, z1}, {p.x1, p.y0, z0}, {p.x1, p.y1, z0}, {p.x1, p.y1, z1});
  builder->Quad(surface, {p.x0, p.y1, z1}, {p.x1, p.y1, z1}, {p.x1, p.y1, z0}, {p.x0, p.y1, z0},
                end);
  if (p.y0 > 0.0f) {
    builder->Quad(surface, {p.x0, p.y0, z0}, {p.x1, p.y0, z0}, {p.x1, p.y0, z1}, {p.x0, p.y0, z1},
                  end);
  }
}

void AddBar(const Surface& surface, const Panel& p, float z0, float z1, Grain grain,
            MeshBuilder* builder) {
  AddBoard(surface, p, z0, z1, grain, builder);
  builder->Quad(surface, {p.x1, p.y0, z0}, {p.x0, p.y0, z0}, {p.x0, p.y1, z0}, {p.x1, p.y1, z0},
                grain == Grain::kLevel ? Vec(Vec::UnitY()) : Vec(Vec::UnitX()));
}

void AddReveal(const Surface& surface, const Reveal& reveal, MeshBuilder* builder) {
  const float x0 = reveal.hole.x0 - reveal.by;
  const float x1 = reveal.hole.x1 + reveal.by;
  const float y0 = reveal.hole.y0 - (reveal.has_bottom ? reveal.by : kOverlap);
  const float y1 = reveal.hole.y1 + reveal.by;
  const float z0 = reveal.z0;
  const float z1 = reveal.z1;
  builder->Quad(surface, {x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}, {x0, y1, z0});
  builder->Quad(surface, {x1, y0, z1}, {x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1});
  builder->Quad(surface, {x0, y1, z1}, {x1, y1, z1}, {x1, y1, z0}, {x0, y1, z0});
  if (reveal.has_bottom) {
    builder->Quad(surface, {x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1});
  }
}

}  // namespace bulletnav::sim::shell
