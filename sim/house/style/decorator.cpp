// SPDX-License-Identifier: MIT
#include "sim/house/style/decorator.h"

#include <algorithm>
#include <array>

#include "sim/house/style/palettes.h"
#include "sim/house/style/tint.h"

namespace bulletnav::sim::style {
namespace {

constexpr float kWholeWall = 9.0f;  // metres: higher than any ceiling
constexpr std::array<std::string_view, 2> kKidsWallpapers = {"stars_wallpaper", "polka_wallpaper"};

class Decorator {
 public:
  Decorator(const StyleBook& book, const HouseTheme& theme, const FloorPlan& plan, int room,
            Rng* rng)
      : book_(book), theme_(theme), plan_(plan), room_(room), rng_(rng) {}

  RoomStyle Run() {
    style_.floor = Floor();
    style_.ceiling = IsWet() ? Surface{"plaster_smooth"} : theme_.ceiling;
    style_.baseboard = theme_.frame;
    style_.baseboard_height = 0.01f * static_cast<float>(rng_->Between(6, 12));
    PaintWalls();
    if (style_.walls.split > 0.0f && IsTiled()) style_.baseboard_height = 0.0f;
    AddAccentWall();
    AddCeilingWork();
    style_.palette = DrawPalette(book_, type(), rng_);
    if (type() != RoomType::kKidsRoom && rng_->Chance(0.55)) style_.palette.wood = theme_.wood;
    return style_;
  }

 private:
  RoomType type() const { return plan_.rooms[static_cast<std::size_t>(room_)].type; }
  bool IsSleeping() const { return type() == RoomType::kBedroom || type() == RoomType::kKidsRoom; }
  bool IsWet() const { return type() == RoomType::kBathroom || type() == RoomType::kToilet; }
  bool IsTiled() const {
    return FindMaterial(style_.walls.lower.material).family == MaterialFamily::kTile ||
           FindMaterial(style_.walls.lower.material).family == MaterialFamily::kStone;
  }

  Surface Floor() {
    switch (type()) {
      case RoomType::kLivingRoom:
      case RoomType::kDiningRoom:
      case RoomType::kCorridor:
        return theme_.main_floor;
      case RoomType::kEntry:
        return rng_->Chance(0.7) ? theme_.main_floor : rng_->Pick(book_.kitchen_floors);
      case RoomType::kKitchen:
        return rng_->Chance(0.2) ? theme_.main_floor : rng_->Pick(book_.kitchen_floors);
      case RoomType::kBedroom:
      case RoomType::kKidsRoom:
        return rng_->Chance(0.5) ? theme_.bedroom_floor : rng_->Pick(book_.bedroom_floors);
      case RoomType::kStudy:
        return rng_->Chance(0.5) ? theme_.main_floor : rng_->Pick(book_.bedroom_floors);
      case RoomType::kStorage:
        return rng_->Chance(0.5) ? theme_.main_floor : rng_->Pick(book_.bath_floors);
      case RoomType::kBathroom:
      case RoomType::kToilet:
      case RoomType::kLaundry:
        return rng_->Pick(book_.bath_floors);
      case RoomType::kOpenOffice:
      case RoomType::kOffice:
      case RoomType::kMeetingRoom:
      case RoomType::kReception:
      case RoomType::kBreakRoom:
      case RoomType::kRestroom:
      case RoomType::kStockRoom:
      case RoomType::kTechnicalRoom:
      case RoomType::kWard:
      case RoomType::kExamRoom:
      case RoomType::kWaitingRoom:
      case RoomType::kShopFloor:
      case RoomType::kFittingRoom:
      case RoomType::kClassroom:
      case RoomType::kLaboratory:
      case RoomType::kCanteen:
      case RoomType::kHotelRoom:
      case RoomType::kLobby:
      case RoomType::kWorkshop:
      case RoomType::kWarehouse:
      case RoomType::kAssemblyHall:
      case RoomType::kPaintRoom:
      case RoomType::kStairwell:
      case RoomType::kStudio:
        break;
    }
    return theme_.main_floor;
  }

  Surface Paint(const Rgb8& tint) const { return {book_.plaster, tint}; }

  Surface Neutral() {
    const Rgb8 tint = rng_->Pick(book_.neutrals);
    return Paint(Mix(tint, rng_->Pick(book_.neutrals), rng_->Uniform(0.0, 0.3)));
  }

  /// A colour, thinned with white.
  Surface Colored(double least_white, double most_white) {
    return Paint(Mix(rng_->Pick(book_.colors), kWhite, rng_->Uniform(least_white, most_white)));
  }

  void PaintWalls() {
    WallFinish& walls = style_.walls;
    walls.upper = Neutral();
    switch (type()) {
      case RoomType::kLivingRoom:
        if (rng_->Chance(0.3)) walls.upper = Colored(0.35, 0.65);
        break;
      case RoomType::kDiningRoom:
        if (rng_->Chance(0.5)) walls.upper = Colored(0.15, 0.55);
        AddPanels(book_.panel_chance, 0.85, 1.1);
        break;
      case RoomType::kKitchen:
        if (rng_->Chance(0.5)) walls.upper = Colored(0.3, 0.6);
        if (rng_->Chance(0.4)) AddTiles(1.45, 1.6);
        break;
      case RoomType::kBedroom:
        if (rng_->Chance(0.7)) walls.upper = Colored(0.1, 0.55);
        break;
      case RoomType::kKidsRoom:
        PaintKidsRoom();
        break;
      case RoomType::kBathroom:
      case RoomType::kToilet:
        if (rng_->Chance(0.5)) walls.upper = Colored(0.2, 0.6);
        AddTiles(1.2, 2.0);
        if (rng_->Chance(0.35)) walls.split = kWholeWall;
        break;
      case RoomType::kCorridor:
      case RoomType::kEntry:
        if (rng_->Chance(0.35)) walls.upper = Colored(0.3, 0.6);
        AddPanels(book_.panel_chance + 0.1, 0.9, 1.2);
        break;
      case RoomType::kStudy:
        walls.upper = Colored(0.0, 0.35);
        break;
      case RoomType::kLaundry:
        if (rng_->Chance(0.4)) walls.upper = Colored(0.35, 0.6);
        AddTiles(0.9, 1.5);
        break;
      case RoomType::kStorage:
        if (rng_->Chance(0.4)) walls.upper = Colored(0.3, 0.6);
        break;
      case RoomType::kOpenOffice:
      case RoomType::kOffice:
      case RoomType::kMeetingRoom:
      case RoomType::kReception:
      case RoomType::kBreakRoom:
      case RoomType::kRestroom:
      case RoomType::kStockRoom:
      case RoomType::kTechnicalRoom:
      case RoomType::kWard:
      case RoomType::kExamRoom:
      case RoomType::kWaitingRoom:
      case RoomType::kShopFloor:
      case RoomType::kFittingRoom:
      case RoomType::kClassroom:
      case RoomType::kLaboratory:
      case RoomType::kCanteen:
      case RoomType::kHotelRoom:
      case RoomType::kLobby:
      case RoomType::kWorkshop:
      case RoomType::kWarehouse:
      case RoomType::kAssemblyHall:
      case RoomType::kPaintRoom:
      case RoomType::kStairwell:
      case RoomType::kStudio:
        break;
    }
  }

  void PaintKidsRoom() {
    const auto color = [&](double least, double most) {
      return Paint(Mix(rng_->Pick(KidsColors()), kWhite, rng_->Uniform(least, most)));
    };
    style_.walls.upper = color(0.15, 0.45);
    if (!rng_->Chance(0.35)) return;
    style_.walls.lower = color(0.0, 0.25);
    style_.walls.upper = color(0.5, 0.8);
    style_.walls.split = static_cast<float>(rng_->Uniform(0.9, 1.2));
  }

  void AddPanels(double chance, double low, double high) {
    if (!rng_->Chance(chance)) return;
    style_.walls.lower = rng_->Pick(book_.panels);
    style_.walls.split = static_cast<float>(rng_->Uniform(low, high));
    style_.walls.has_cap = true;
  }

  void AddTiles(double low, double high) {
    style_.walls.lower = rng_->Pick(book_.bath_tiles);
    style_.walls.split = static_cast<float>(rng_->Uniform(low, high));
  }

  /// The longest sides without doors come first into question for a wall that differs.
  void AddAccentWall() {
    const bool may_differ = IsSleeping() || type() == RoomType::kLivingRoom ||
                            type() == RoomType::kDiningRoom || type() == RoomType::kStudy;
    const double chance = type() == RoomType::kKidsRoom ? 0.5 : book_.accent_chance;
    if (!may_differ || style_.walls.split > 0.0f || !rng_->Chance(chance)) return;
    style_.accent_edge = PickQuietEdge();
    style_.accent = {AccentSurface(), {}, 0.0f, false};
  }

  Surface AccentSurface() {
    if (type() == RoomType::kKidsRoom) {
      return {rng_->Pick(kKidsWallpapers), Mix(rng_->Pick(KidsColors()), kWhite, 0.25)};
    }
    if (rng_->Chance(book_.wallpaper_chance)) {
      return {rng_->Pick(book_.wallpapers), Mix(rng_->Pick(book_.colors), kWhite, 0.3)};
    }
    return rng_->Chance(0.5) ? rng_->Pick(book_.features) : Colored(0.0, 0.2);
  }

  int PickQuietEdge() {
    const auto& outline = plan_.rooms[static_cast<std::size_t>(room_)].outline;
    std::vector<double> weights;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const PlanPoint& p = outline[i];
      const PlanPoint& q = outline[(i + 1) % outline.size()];
      const auto length = static_cast<double>((q - p).norm());
      weights.push_back(HasPassage(p, q) ? 0.01 * length : length * length);
    }
    return static_cast<int>(rng_->Weighted(weights));
  }

  bool HasPassage(const PlanPoint& p, const PlanPoint& q) const {
    const PlanPoint along = (q - p).normalized();
    return std::any_of(plan_.openings.begin(), plan_.openings.end(), [&](const Opening& o) {
      const PlanPoint to = 0.5f * (o.a + o.b) - p;
      const float off = std::abs(to.dot(LeftOf(along)));
      const float at = to.dot(along);
      return o.IsPassage() && off < 0.5f * o.wall_thickness + 0.01f && at > 0.0f &&
             at < (q - p).norm();
    });
  }

  void AddCeilingWork() {
    const bool is_formal = type() == RoomType::kLivingRoom || type() == RoomType::kDiningRoom ||
                           type() == RoomType::kBedroom || type() == RoomType::kEntry ||
                           type() == RoomType::kCorridor || type() == RoomType::kStudy;
    if (is_formal && rng_->Chance(book_.crown_chance)) style_.crown = theme_.frame;
    const bool is_public = type() == RoomType::kLivingRoom || type() == RoomType::kDiningRoom;
    const bool is_high = plan_.ceiling >= 2.5f;
    if (is_public && is_high && !style_.crown && rng_->Chance(book_.beam_chance)) {
      style_.beams = theme_.wood;
    }
  }

  const StyleBook& book_;
  const HouseTheme& theme_;
  const FloorPlan& plan_;
  int room_;
  Rng* rng_;
  RoomStyle style_;
};

}  // namespace

HouseTheme DrawTheme(const StyleBook& book, Rng* rng) {
  HouseTheme theme;
  theme.main_floor = rng->Pick(book.main_floors);
  theme.bedroom_floor = rng->Pick(book.bedroom_floors);
  theme.ceiling = rng->Pick(book.ceilings);
  theme.frame = rng->Pick(book.frames);
  theme.wood = rng->Pick(book.woods);
  return theme;
}

RoomStyle DecorateRoom(const StyleBook& book, const HouseTheme& theme, const FloorPlan& plan,
                       int room, Rng* rng) {
  return Decorator(book, theme, plan, room, rng).Run();
}

}  // namespace bulletnav::sim::style
