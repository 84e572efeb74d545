// SPDX-License-Identifier: MIT
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr std::array<std::string_view, 6> kPaintings = {"painting_abstract",  "painting_flowers",
                                                        "painting_geometric", "painting_landscape",
                                                        "painting_portrait",  "painting_sea"};

constexpr std::string_view kPhotos = "family_photos";

Surface PictureFrame(PieceMaker& m) {
  const std::array<Surface, 5> frames = {m.palette().wood, m.palette().other_wood, kBlackPaint,
                                         kWhitePaint, kBrass};
  return m.rng().Pick(frames);
}

/// A framed picture whose lower left corner is at `low`.
void Framed(PieceMaker& m, const Surface& frame, const Surface& picture, const Vec& low,
            const Vec2& size, float mat) {
  constexpr float kRim = 0.035f;
  Panel(m, frame, low, low + Vec(size.x(), size.y(), 0.03f));
  const Vec middle = low + Vec(0.5f * size.x(), 0, 0);
  if (mat > 0.0f)
    Sheet(m, kPaper, middle + Vec(0, kRim, 0.032f), size.x() - 2.0f * kRim, size.y() - 2.0f * kRim);
  const float rim = kRim + mat;
  const Vec at = middle + Vec(0, rim, 0.034f);
  const Vec2 inner = size - 2.0f * Vec2(rim, rim);
  if (picture.material == kPhotos) {
    FamilyPhoto(m, at, inner.x(), inner.y());
  } else {
    Sheet(m, picture, at, inner.x(), inner.y());
  }
}

void Triptych(PieceMaker& m) {
  static constexpr std::array<std::string_view, 4> kWide = {
      "painting_abstract", "painting_geometric", "painting_landscape", "painting_sea"};
  const Surface picture{m.rng().Pick(kWide)};
  const float width = m.Draw(0.32f, 0.4f);
  constexpr float kHigh = 0.85f;
  constexpr float kFront = 0.033f;
  for (int i = 0; i < 3; ++i) {
    const Vec low((static_cast<float>(i) - 1.5f) * (width + 0.05f), 0, 0);
    const float part = static_cast<float>(i) / 3.0f;
    m.Box(kWhitePaint, low, low + Vec(width, kHigh, 0.03f));
    m.Picture(picture, low + Vec(0, 0, kFront), low + Vec(width, 0, kFront),
              low + Vec(width, kHigh, kFront), low + Vec(0, kHigh, kFront),
              {Vec2(part, 0), Vec2(part + 1.0f / 3.0f, 1)});
  }
}

void Painting(PieceMaker& m) {
  const Surface frame = PictureFrame(m);
  const float mat = m.Chance(0.4) ? 0.06f : 0.0f;
  const Surface picture{m.rng().Pick(kPaintings)};
  switch (m.Below(4)) {
    case 0:
      return Triptych(m);
    case 1: {  // two beside each other
      const Vec2 size = m.Draw(Vec2(0.36f, 0.48f), Vec2(0.46f, 0.6f));
      Framed(m, frame, picture, {-size.x() - 0.05f, 0, 0}, size, mat);
      return Framed(m, frame, {m.rng().Pick(kPaintings)}, {0.05f, 0, 0}, size, mat);
    }
    case 2: {
      const Vec2 size = m.Draw(Vec2(0.8f, 0.55f), Vec2(1.25f, 0.85f));
      return Framed(m, frame, picture, {-0.5f * size.x(), 0, 0}, size, mat);
    }
    case 3: {
      const Vec2 size = m.Draw(Vec2(0.42f, 0.58f), Vec2(0.6f, 0.8f));
      return Framed(m, frame, picture, {-0.5f * size.x(), 0, 0}, size, mat);
    }
  }
}

/// Many small frames in two rows.
void PhotoGallery(PieceMaker& m) {
  const auto photo = [&](float x, float y, const Vec2& size) {
    const Surface frame = PictureFrame(m);
    const bool is_photo = m.Chance(0.6);
    const std::string_view painting = m.rng().Pick(kPaintings);
    Framed(m, frame, {is_photo ? kPhotos : painting}, {x, y, 0}, size, 0.03f);
  };
  float x = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const float width = m.Draw(0.24f, 0.4f);
    const float split = m.Draw(0.32f, 0.46f);
    photo(x, m.Draw(0.0f, 0.05f), {width, split - 0.05f});
    photo(x, split + 0.05f, {width, m.Draw(0.68f, 0.86f) - split});
    x += width + 0.06f;
  }
}

void Poster(PieceMaker& m) {
  static constexpr std::array<std::string_view, 5> kPosters = {
      "poster_animals", "poster_space", "world_map", "painting_geometric", "painting_abstract"};
  const std::string_view name = m.rng().Pick(kPosters);
  const bool is_wide = name == "world_map";
  const float width = is_wide ? m.Draw(0.9f, 1.2f) : m.Draw(0.5f, 0.65f);
  const float height = is_wide ? 0.62f * width : 1.4f * width;
  Panel(m, kPaper, {-0.5f * width, 0, 0}, {0.5f * width, height, 0.006f});
  Sheet(m, {name}, {0, 0.012f, 0.008f}, width - 0.024f, height - 0.024f);
}

void RoundMirror(PieceMaker& m, const Surface& frame_surface) {
  const float radius = m.Draw(0.28f, 0.42f);
  const float tall = m.Chance(0.5) ? 1.0f : 1.35f;
  const Frame frame(&m, Turned({0, tall * radius, 0}, 0.0f, kQuarterTurn) *
                            Eigen::Scaling(Vec(1.0f, 1.0f, tall)));
  m.Turn(frame_surface, {0, 0, 0}, {{radius, 0.0f}, {radius, 0.03f}, {0.9f * radius, 0.03f}}, 20);
  PictureDisc(m, kMirror, {0, 0.028f, 0}, 0.9f * radius, 20);
}

void Mirror(PieceMaker& m) {
  const Surface frame = PictureFrame(m);
  if (m.Chance(0.45)) return RoundMirror(m, frame);
  const Vec2 size = m.Draw(Vec2(0.45f, 0.7f), Vec2(0.7f, 1.2f));
  Framed(m, frame, kMirror, {-0.5f * size.x(), 0, 0}, size, 0.0f);
}

void WallClock(PieceMaker& m) {
  const float radius = m.Draw(0.14f, 0.2f);
  const Surface rim = PictureFrame(m);
  const bool is_dark = m.Chance(0.2);
  const Surface face = is_dark ? kBlackPlastic : kWhitePlastic;
  const Surface ink = is_dark ? kWhitePlastic : kDark;
  const Frame frame(&m, {0, radius, 0});
  {
    const Frame lying(&m, Turned({0, 0, 0}, 0.0f, kQuarterTurn));
    m.Turn(rim, {0, 0, 0},
           {{radius, 0.0f}, {radius, 0.04f}, {0.87f * radius, 0.04f}, {0.86f * radius, 0.035f}},
           20);
    Disc(m, face, {0, 0.035f, 0}, 0.88f * radius, 20);
  }
  const auto mark = [&](float angle, float from, float to, float width) {
    const Frame turned(&m, Turned({0, 0, 0.038f}, 0.0f, 0.0f, -angle));
    m.Quad(ink, {-width, from * radius, 0}, {width, from * radius, 0}, {width, to * radius, 0},
           {-width, to * radius, 0});
  };
  for (int i = 0; i < 12; ++i) {
    const float angle = kQuarterTurn / 3.0f * static_cast<float>(i);
    mark(angle, i % 3 == 0 ? 0.62f : 0.7f, 0.8f, i % 3 == 0 ? 0.009f : 0.005f);
  }
  const float hour = m.Draw(0.0f, 4.0f * kQuarterTurn);
  mark(hour, -0.1f, 0.45f, 0.01f);
  mark(12.0f * hour, -0.1f, 0.68f, 0.007f);
}

void WallShelf(PieceMaker& m) {
  const float half = 0.5f * m.Width(0.6f, 1.1f);
  const int boards = m.Between(1, 2);
  const Surface& wood = m.palette().wood;
  for (int i = 0; i < boards; ++i) {
    const float y = 0.38f * static_cast<float>(i);
    m.Box(wood, {-half, y, 0}, {half, y + 0.03f, 0.22f});
    const float split = m.Draw(-0.2f, 0.4f) * half;
    Books(m, {-half + 0.04f, y + 0.03f, 0.03f}, {split, y + 0.34f, 0.2f});
    Ornament(m, {0.5f * (split + half) - 0.1f, y + 0.03f, 0.11f}, {0.2f, 0.28f, 0.18f});
    if (half - split > 0.4f) Ornament(m, {half - 0.13f, y + 0.03f, 0.11f}, {0.2f, 0.28f, 0.18f});
  }
}

void PinBoard(PieceMaker& m) {
  const Vec2 size = m.Draw(Vec2(0.7f, 0.5f), Vec2(1.0f, 0.65f));
  Framed(m, m.palette().wood, {"cork"}, {-0.5f * size.x(), 0, 0}, size, 0.0f);
  for (int i = 0; i < 8; ++i) {
    const Vec2 at = m.Draw(Vec2(-0.4f, 0.12f), Vec2(0.4f, 0.6f)).cwiseProduct(size);
    const Vec note(at.x(), at.y(), 0.037f + 0.001f * static_cast<float>(i));  // over the last one
    const Frame frame(&m, Turned(note, 0.0f, 0.0f, m.Draw(-0.15f, 0.15f)));
    const Surface paper{"paper", m.Chance(0.5) ? kWhite : BrightColor(m)};
    const Vec2 sheet = m.Draw(Vec2(0.08f, 0.08f), Vec2(0.15f, 0.17f));
    Sheet(m, paper, {0, 0, 0}, sheet.x(), sheet.y());
  }
}

constexpr std::array kKinds = {
    FurnitureKind{"mirror", Placement::kOnWall, 0.0f, Mirror},
    FurnitureKind{"painting", Placement::kOnWall, 0.0f, Painting},
    FurnitureKind{"photo_gallery", Placement::kOnWall, 0.0f, PhotoGallery},
    FurnitureKind{"pin_board", Placement::kOnWall, 0.0f, PinBoard},
    FurnitureKind{"poster", Placement::kOnWall, 0.0f, Poster},
    FurnitureKind{"wall_clock", Placement::kOnWall, 0.0f, WallClock},
    FurnitureKind{"wall_shelf", Placement::kOnWall, 0.0f, WallShelf, 0.4f, 1.6f}};

}  // namespace

std::span<const FurnitureKind> WallArt() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
