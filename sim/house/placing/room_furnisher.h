// SPDX-License-Identifier: MIT
#pragma once
#include <deque>
#include <span>
#include <string>
#include <string_view>

#include "sim/house/furniture.h"
#include "sim/house/placing/room_space.h"

namespace bulletnav::sim::placing {

/// A piece in its place.
struct Placed {
  const FurnitureKind* kind = nullptr;
  Eigen::Affine3f pose = Eigen::Affine3f::Identity();  // of the piece's frame in the world
  Eigen::Vector3f size = Eigen::Vector3f::Zero();      // along the piece's own axes
  Box box;                                             // in the world
  std::vector<TopSurface> tops;
  Box bounds;        // in the piece's frame
  std::string name;  // of the object, as MeshBuilder gives it
};

enum class Anchor { kAnywhere, kCentre, kEnd };  // along a wall

/// What is wanted of a place. Lengths in metres; 0 leaves it to the kind.
struct Wish {
  float width = 0.0f;
  float min_width = 0.0f;  // a narrower one will do
  float height = 0.0f;
  Anchor anchor = Anchor::kAnywhere;
  const Placed* near = nullptr;       // as close as possible
  const PlanPoint* beside = nullptr;  // as close as possible to this place on the floor
  const Placed* facing = nullptr;     // looks at it and is in line with it
  bool far_from_doors = false;
  bool squeeze = false;        // rather near a door or with little free floor than not at all
  std::string_view seat = {};  // only where this can stand before it, see SeatAt
};

/// Where something goes relative to a piece, in that piece's frame: x to its left (seen from the
/// piece), z to its front, metres; turn about y, radians.
struct Offset {
  float x = 0.0f;
  float z = 0.0f;
  float turn = 0.0f;
};

/// Puts pieces into one room where they fit: inside its walls, clear of doors and windows, not into
/// each other, with the floor they need in front of them and a way left to every door. Every call
/// returns null and changes nothing where there is no such place.
class RoomFurnisher {
 public:
  RoomFurnisher(RoomSpace* space, const RoomStyle& style, const Rng& rng, MeshBuilder* builder)
      : space_(*space), style_(style), rng_(rng), common_rng_(rng), builder_(builder) {}

  const Placed* AgainstWall(std::string_view kind, const Wish& wish = {});
  /// With a chair before it, see SeatAt.
  const Placed* AgainstWallWithSeat(std::string_view kind, std::string_view chair, Wish wish = {});
  /// At one place of one wall, `x` metres from its left end.
  const Placed* AtWall(const shell::Side& side, float x, std::string_view kind, const Wish& wish);
  /// Against a wall with its left or right side, its head towards a corner: beds in small rooms.
  const Placed* Alongside(std::string_view kind);
  const Placed* InCorner(std::string_view kind);
  /// In the open, parallel to the walls; as near as possible to `wish.near` or the room's middle.
  const Placed* InTheOpen(std::string_view kind, const Wish& wish = {});
  /// In the open with its frame's origin at one place, turned about y by radians; what it should
  /// keep free in front of it is up to who places it.
  const Placed* AtPlace(std::string_view kind, const PlanPoint& at, float turn,
                        const Wish& wish = {});
  /// Near a wall, with its back to it, though it is a piece that can stand free.
  const Placed* NearWall(std::string_view kind, const Wish& wish = {});
  /// Relative to another piece; pieces that belong together may use each other's free floor.
  const Placed* At(const Placed& other, std::string_view kind, const Offset& offset,
                   const Wish& wish = {});
  /// Left and right of a piece against the same wall.
  const Placed* Beside(const Placed& other, std::string_view kind, bool left, float gap = 0.05f);
  /// In front of it, looking back at it if `turned`.
  const Placed* Before(const Placed& other, std::string_view kind, float gap, bool turned = false);
  /// A chair before a desk, looking at it: a gap away from its edge or pushed under it.
  const Placed* SeatAt(const Placed& desk, std::string_view chair, float gap = 0.22f);
  /// Around a table, looking at it. Returns how many.
  int ChairsAround(const Placed& table, std::string_view chair, int most);

  /// Flat on the floor; `turned` by a quarter.
  void Rug(std::string_view kind, const PlanPoint& centre, float width, bool turned);
  /// Small things on a piece's tops, each kind at most once.
  void OnTops(const Placed& piece, std::span<const std::string_view> kinds, int most);
  bool OnTop(const Placed& piece, std::string_view kind);
  /// Hung over a piece's middle, its lower edge `above` its top.
  const Placed* Over(const Placed& piece, std::string_view kind, float above);
  /// Hung on a free stretch of wall, its middle at eye height or its lower edge at `low`.
  const Placed* OnWall(std::string_view kind, float low = 0.0f, const Wish& wish = {});
  /// Curtains or blinds at all windows, whatever fits.
  void DressWindows(bool curtains);
  void Radiators();
  /// Hung from the ceiling in the middle of the room, or of `over`; repeated along long rooms.
  void Light(std::string_view kind, const Placed* over = nullptr);
  /// Hung from the ceiling at one place.
  bool HangAt(std::string_view kind, const PlanPoint& at, float turn);
  /// Hung from the ceiling in some corner.
  void HangInCorner(std::string_view kind);

  /// What `furnish` returns when it is tried out on a copy of the room, which is thrown away.
  template <class Furnish>
  bool Try(const Furnish& furnish) const {
    RoomSpace space = space_;
    MeshBuilder scratch;
    RoomFurnisher copy(&space, style_, rng_, &scratch);
    copy.common_rng_ = common_rng_;
    copy.rugs_ = rugs_;
    copy.on_tops_ = on_tops_;
    copy.built_ = built_;
    copy.alike_ = alike_;
    return furnish(&copy);
  }

  /// From now on pieces of a kind and width are all alike, or each is drawn anew again.
  void SetAlike(bool alike) { alike_ = alike; }
  /// The generator that rooms which look like each other draw from; set before the first piece.
  void SetCommonRng(const Rng& rng) { common_rng_ = rng; }
  /// From now on pieces and choices are drawn as in every other room of this type in the building.
  void DrawAsInOtherRooms() {
    rng_ = common_rng_.Fork("type", static_cast<std::uint64_t>(space_.room().type));
  }

  /// Of everything placed, in order.
  std::vector<std::string_view> kinds() const;
  const std::deque<Placed>& placed() const { return placed_; }
  Rng& rng() { return rng_; }
  bool Chance(double p) { return rng_.Chance(p); }
  std::string_view Pick(std::span<const std::string_view> names) { return rng_.Pick(names); }
  const RoomSpace& space() const { return space_; }
  float area() const { return space_.room().area(); }

 private:
  struct Draft {
    const FurnitureKind* kind = nullptr;
    Piece piece;
    Box bounds;  // in the piece's frame
  };
  struct Candidate {
    Eigen::Affine3f pose;
    double score = 0.0;
  };
  /// Which free floor counts: what other pieces want, what the piece itself wants.
  struct Rules {
    bool minds_clearance = true;
    bool keeps_clearance = true;
    bool minds_doorways = true;
  };

  Draft Build(std::string_view kind, const PieceRequest& request = {});
  /// Adds it to the building, as an object; returns its name.
  std::string Show(const Draft& draft, const Eigen::Affine3f& pose);
  bool Fits(const Draft& draft, const Eigen::Affine3f& pose, const Rules& rules) const;
  std::optional<Rect> ClearanceOf(const Draft& draft, const Eigen::Affine3f& pose) const;
  const Placed* Place(const Draft& draft, const Eigen::Affine3f& pose, bool keeps_clearance);
  const Placed* PlaceBest(const Draft& draft, std::vector<Candidate> candidates,
                          bool keeps_clearance = true, std::string_view seat = {});
  bool HasSeat(const Draft& draft, const Eigen::Affine3f& pose, bool keeps_clearance,
               std::string_view seat) const;
  /// Draws a chair up to a table's place; some stay pulled out or askew.
  bool PlaceChair(const Placed& table, std::string_view chair, const Offset& seat);
  void AddWallCandidates(const Draft& draft, const shell::Side& side, const Wish& wish,
                         const Rules& rules, std::vector<Candidate>* candidates);
  const Placed* PlaceAtWall(const Draft& draft, const Wish& wish, const Rules& rules);
  double Score(const Draft& draft, const Eigen::Affine3f& pose, const Wish& wish);
  void DressWindow(const shell::Side& side, const shell::Hole& window, bool curtain);
  bool Hang(const Draft& draft, const Eigen::Affine3f& pose);

  RoomSpace& space_;
  const RoomStyle& style_;
  Rng rng_;
  Rng common_rng_;
  MeshBuilder* builder_;
  std::deque<Placed> placed_;
  std::vector<Rect> rugs_;
  std::vector<std::pair<const Placed*, Rect>> on_tops_;  // in that piece's frame
  std::uint64_t built_ = 0;
  bool alike_ = false;
};

}  // namespace bulletnav::sim::placing
