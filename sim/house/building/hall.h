// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>

#include "sim/house/placing/room_furnisher.h"

namespace bulletnav::sim::building {

using placing::Placed;
using placing::RoomFurnisher;
using placing::Wish;

inline constexpr float kHalfTurn = 3.14159265f;

/// Which way a piece in a hall looks: towards larger or smaller v, larger or smaller u.
enum class Look { kUp, kDown, kRight, kLeft };

/// Evenly between two numbers.
inline float Draw(Rng* rng, double low, double high) {
  return static_cast<float>(rng->Uniform(low, high));
}

/// The part of a hall that a pattern of furniture may fill, metres.
struct Field {
  float u0 = 0.0f;
  float u1 = 0.0f;
  float v0 = 0.0f;
  float v1 = 0.0f;
};

/// Rows of pieces side by side with ways between them. Lengths in metres.
struct Rows {
  std::string_view kind;
  float width = 2.0f;        // of a piece, along the row
  float height = 0.0f;       // asked of it; 0: its own
  float pitch = 3.0f;        // from row to row
  float depth = 0.0f;        // of pieces whose back is their origin; 0: it is their middle
  float gap = 0.0f;          // from piece to piece
  float break_after = 0.0f;  // a way across after this much of a row; 0: none
  float share = 1.0f;        // of the places that are taken
};

/// A room seen as a rectangle in which furniture stands in patterns: u runs along the longer side
/// of its largest rectangle, v across it, both from 0. What does not fit where a pattern wants it
/// (columns, doorways, ways that would be closed) is left out.
class Hall {
 public:
  explicit Hall(RoomFurnisher* room);

  float length() const { return length_; }
  float width() const { return width_; }
  /// All of it but a margin along the walls.
  Field Inner(float margin) const { return {margin, length_ - margin, margin, width_ - margin}; }
  RoomFurnisher& room() { return *room_; }
  Rng* rng() { return &room_->rng(); }

  PlanPoint At(float u, float v) const;
  float Turn(Look look) const;

  const Placed* Put(std::string_view kind, float u, float v, Look look, const Wish& wish = {});
  /// Somewhere in a field, looking anywhere.
  const Placed* Scatter(std::string_view kind, const Field& field, const Wish& wish = {});
  /// Rows along u in a field, pieces' fronts to larger v. Returns how many pieces.
  int Fill(const Rows& rows, const Field& field);
  /// Columns in a grid, from floor to ceiling.
  void Columns(float spacing);
  /// Lamps in a grid.
  void Lights(std::string_view kind, float spacing);
  /// `count` pieces against walls, each of a kind picked from a list.
  void AlongWalls(std::span<const std::string_view> kinds, int count, float width = 0.0f);

 private:
  /// The row whose pieces' fronts lie at v.
  int FillRow(const Rows& rows, const Field& field, float v);

  RoomFurnisher* room_;
  PlanPoint origin_ = PlanPoint::Zero();
  bool along_x_ = true;
  float length_ = 0.0f;
  float width_ = 0.0f;
};

}  // namespace bulletnav::sim::building
