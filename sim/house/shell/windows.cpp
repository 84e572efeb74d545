// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/house/shell/faces.h"
#include "sim/house/shell/openings.h"

namespace bulletnav::sim::shell {
namespace {

constexpr float kBehind = 0.001f;  // reveals stand this far behind the hole's edges
constexpr float kFrameWidth = 0.055f;
constexpr float kFrameDepth = 0.06f;
constexpr float kBarWidth = 0.022f;
constexpr float kViewMetres = 3.4f;  // what the whole picture of the outside would cover
constexpr float kHorizon = 0.45f;    // of the picture's height, from its foot
constexpr float kEyeHeight = 1.45f;

class WindowBuilder {
 public:
  WindowBuilder(const HouseStyle& style, const Opening& window, MeshBuilder* builder)
      : style_(style),
        room_(style.rooms[static_cast<std::size_t>(window.room_a)]),
        window_(window),
        builder_(builder) {}

  void Build() {
    const PlanPoint inwards = LeftOf((window_.b - window_.a).normalized());
    const PlanPoint to_face = 0.5f * window_.wall_thickness * inwards;
    const MeshBuilder::Frame frame(builder_, FaceFrame(window_.b + to_face, window_.a + to_face));
    AddReveal(RevealSurface(),
              {.hole = {0.0f, window_.bottom, width(), window_.top},
               .z0 = 0.0f,
               .z1 = -window_.wall_thickness - kBehind,
               .by = kBehind,
               .has_bottom = true},
              builder_);
    if (window_.bottom > 0.3f) AddSill();
    AddFrame();
    AddView(inwards);
  }

 private:
  float width() const { return window_.width(); }

  /// Painted like the wall if the wall is painted, else white; bathrooms tile them.
  Surface RevealSurface() const {
    const Surface& wall = 0.5f * (window_.bottom + window_.top) < room_.walls.split
                              ? room_.walls.lower
                              : room_.walls.upper;
    const MaterialFamily family = FindMaterial(wall.material).family;
    const bool runs_on = family == MaterialFamily::kPaint || family == MaterialFamily::kTile;
    return runs_on ? wall : Surface{"plaster_smooth"};
  }

  void AddSill() {
    const float depth = 0.55f * window_.wall_thickness;
    AddBoard(style_.window_sill,
             {-0.05f, window_.bottom - 0.03f, width() + 0.05f, window_.bottom + 0.004f}, 0.0f,
             0.035f, Grain::kLevel, builder_);
    builder_->Quad(style_.window_sill, {0.0f, window_.bottom + 0.004f, 0.0f},
                   {width(), window_.bottom + 0.004f, 0.0f},
                   {width(), window_.bottom + 0.004f, -depth},
                   {0.0f, window_.bottom + 0.004f, -depth}, Vec::UnitZ());
  }

  void AddFrame() {
    const float back = -0.75f * window_.wall_thickness;
    const MeshBuilder::Frame frame(builder_, Vec(0.0f, 0.0f, back));
    const float low = window_.bottom;
    const float high = window_.top;
    const bool is_terrace = low < 0.1f;
    const float rail = is_terrace ? 0.12f : kFrameWidth;
    AddFrameBoard({0.0f, low, kFrameWidth, high}, Grain::kUpright);
    AddFrameBoard({width() - kFrameWidth, low, width(), high}, Grain::kUpright);
    AddFrameBoard({kFrameWidth, low, width() - kFrameWidth, low + rail}, Grain::kLevel);
    AddFrameBoard({kFrameWidth, high - kFrameWidth, width() - kFrameWidth, high}, Grain::kLevel);
    const int lights = width() < 0.85f ? 1 : (width() < 1.75f ? 2 : 3);
    const float share = width() / static_cast<float>(lights);
    for (int i = 1; i < lights; ++i) {
      const float x = share * static_cast<float>(i);
      AddFrameBoard({x - 0.04f, low + rail, x + 0.04f, high - kFrameWidth}, Grain::kUpright);
    }
    if (style_.has_glazing_bars) AddBars(lights, low + rail);
  }

  void AddFrameBoard(const Panel& panel, Grain grain) {
    AddBoard(style_.window_frame, panel, 0.0f, kFrameDepth, grain, builder_);
  }

  /// Level bars through all lights.
  void AddBars(int lights, float low) {
    const float high = window_.top - kFrameWidth;
    const int rows = std::max(1, static_cast<int>(std::lround((high - low) / 0.5f)));
    for (int i = 1; i < rows; ++i) {
      const float y = low + (high - low) * static_cast<float>(i) / static_cast<float>(rows);
      AddBoard(style_.window_frame,
               {kFrameWidth, y - 0.5f * kBarWidth, width() - kFrameWidth, y + 0.5f * kBarWidth},
               0.0f, 0.6f * kFrameDepth, Grain::kLevel, builder_);
    }
    for (int i = 0; i < lights; ++i) {
      const float x = width() * (static_cast<float>(i) + 0.5f) / static_cast<float>(lights);
      AddBoard(style_.window_frame, {x - 0.5f * kBarWidth, low, x + 0.5f * kBarWidth, high}, 0.0f,
               0.6f * kFrameDepth, Grain::kUpright, builder_);
    }
  }

  /// A part of the picture, so that the horizon is at eye height and neighbouring windows differ.
  void AddView(const PlanPoint& inwards) {
    const float z = -window_.wall_thickness;
    const float x0 = -kOverlap;
    const float x1 = width() + kOverlap;
    const float y0 = window_.bottom - kOverlap;
    const float y1 = window_.top + kOverlap;
    const float part = std::min(1.0f, (x1 - x0) / kViewMetres);
    const float along = std::abs(window_.a.x() - window_.a.y()) * 0.37f;
    const float u = (1.0f - part) * (along - std::floor(along));
    const auto v = [](float y) {
      return std::clamp(kHorizon + (y - kEyeHeight) / kViewMetres, 0.0f, 1.0f);
    };
    builder_->SetGlow(Glow::kSky);
    builder_->Picture(ViewTowards(-inwards), {x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z},
                      {Eigen::Vector2f(u, v(y0)), Eigen::Vector2f(u + part, v(y1))});
    builder_->SetGlow(Glow::kNone);
  }

  const Surface& ViewTowards(const PlanPoint& out) const {
    if (std::abs(out.x()) > std::abs(out.y())) return style_.views[out.x() < 0.0f ? 0 : 1];
    return style_.views[out.y() < 0.0f ? 2 : 3];
  }

  const HouseStyle& style_;
  const RoomStyle& room_;
  const Opening& window_;
  MeshBuilder* builder_;
};

}  // namespace

void AddWindow(const HouseStyle& style, const Opening& window, MeshBuilder* builder) {
  WindowBuilder(style, window, builder).Build();
}

}  // namespace bulletnav::sim::shell
