// SPDX-License-Identifier: MIT
#include "benchmark/report/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string_view>

#include <cairo/cairo-svg.h>
#include <cairo/cairo.h>

#include "sim/base/check.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;

constexpr double kBaseline = 0.36;  // of the size: how far it is below the middle of capitals

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

using Surface = std::unique_ptr<cairo_surface_t, Destroy>;

cairo_status_t Append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// Where the next name of a part begins in an SVG, at `from` or later.
std::size_t NextName(const std::string& svg, std::size_t from) {
  std::size_t next = std::string::npos;
  for (const std::string_view before : {" id=\"", "xlink:href=\"#", "url(#"}) {
    const std::size_t found = svg.find(before, from);
    if (found != std::string::npos) next = std::min(next, found + before.size());
  }
  return next;
}

/// Cairo numbers the parts of an SVG from a counter of the whole process: counts them anew, by
/// first appearance, so that the same picture is the same text.
std::string Renumber(const std::string& svg) {
  std::string text;
  std::map<std::string, std::size_t> numbers;
  std::size_t rest = 0;
  for (std::size_t at = NextName(svg, 0); at != std::string::npos; at = NextName(svg, rest)) {
    const std::size_t end = svg.find_first_of("\")", at);
    const std::string name = svg.substr(at, end - at);
    const std::size_t number = numbers.try_emplace(name, numbers.size() + 1).first->second;
    text.append(svg, rest, at - rest).append("part").append(std::to_string(number));
    rest = end;
  }
  return text.append(svg, rest);
}

Surface MakeSurface(Canvas::Kind kind, const Eigen::Vector2d& size, double scale,
                    std::string* svg) {
  if (kind == Canvas::Kind::kPixels) {
    return Surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                              static_cast<int>(std::lround(scale * size.x())),
                                              static_cast<int>(std::lround(scale * size.y()))));
  }
  Surface surface(cairo_svg_surface_create_for_stream(Append, svg, size.x(), size.y()));
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  return surface;
}

std::uint32_t* Row(cairo_surface_t* surface, int y) {
  unsigned char* data = cairo_image_surface_get_data(surface);
  return reinterpret_cast<std::uint32_t*>(
      data + std::ptrdiff_t{cairo_image_surface_get_stride(surface)} * y);
}

/// A pixel as cairo keeps it: colour multiplied by opacity.
std::uint32_t ToArgb(const std::uint8_t* p, std::uint32_t alpha) {
  const auto times_alpha = [&](std::uint32_t value) {
    return (value * alpha + 127) / 255;
  };
  return alpha << 24 | times_alpha(p[0]) << 16 | times_alpha(p[1]) << 8 | times_alpha(p[2]);
}

Surface ToSurface(const sim::Image& image) {
  BULLETNAV_CHECK(image.channels == 3 || image.channels == 4);
  const bool has_alpha = image.channels == 4;
  Surface surface(cairo_image_surface_create(has_alpha ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
                                             image.width, image.height));
  for (int y = 0; y < image.height; ++y) {
    std::uint32_t* row = Row(surface.get(), y);
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      row[x] = ToArgb(p, has_alpha ? p[3] : 255);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

}  // namespace

struct Canvas::Impl {
  Impl(const Eigen::Vector2d& size, Kind canvas_kind, double scale)
      : kind(canvas_kind),
        surface(MakeSurface(kind, size, scale, &svg)),
        context(cairo_create(surface.get())) {
    BULLETNAV_CHECK_EQ(cairo_status(context.get()), CAIRO_STATUS_SUCCESS);
    if (kind == Kind::kPixels) cairo_scale(context.get(), scale, scale);
  }

  void Use(const Paint& paint) const {
    cairo_set_source_rgba(context.get(), paint.red, paint.green, paint.blue, paint.alpha);
  }

  void Trace(std::span<const Point> points) const {
    for (const Point& p : points) cairo_line_to(context.get(), p.x(), p.y());
  }

  void Draw(const Stroke& stroke) const {
    cairo_t* c = context.get();
    Use(stroke.paint);
    cairo_set_line_width(c, stroke.width);
    cairo_set_line_cap(c, stroke.dashes.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(c, stroke.dashes.data(), static_cast<int>(stroke.dashes.size()), 0.0);
    cairo_stroke(c);
    cairo_set_dash(c, nullptr, 0, 0.0);
  }

  cairo_text_extents_t Measure(const std::string& text, double size, bool bold) const {
    cairo_select_font_face(context.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(context.get(), text.c_str(), &extents);
    return extents;
  }

  Kind kind;
  std::string svg;  // outlives the surface, which writes it
  Surface surface;
  std::unique_ptr<cairo_t, Destroy> context;
};

Canvas::Canvas(int width, int height, const Paint& background, Kind kind, double scale)
    : impl_(std::make_unique<Impl>(Point(width, height), kind, scale)) {
  impl_->Use(background);
  cairo_paint(impl_->context.get());
}

Canvas::Canvas(const sim::Image& image)
    : impl_(std::make_unique<Impl>(Point(image.width, image.height), Kind::kPixels, 1.0)) {
  BULLETNAV_CHECK_EQ(image.channels, 3);
  Picture(image, Eigen::Affine2d::Identity(), false);
}

Canvas::~Canvas() = default;

void Canvas::Fill(std::span<const Point> polygon, const Paint& paint) {
  cairo_t* c = impl_->context.get();
  impl_->Trace(polygon);
  cairo_close_path(c);
  impl_->Use(paint);
  cairo_fill(c);
}

void Canvas::FillTriangles(std::span<const Point> corners, const Paint& paint) {
  cairo_t* c = impl_->context.get();
  // One path, all triangles with the same sense: what they share is inside, not a border.
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Point& p = corners[i];
    const Point u = corners[i + 1] - p;
    const Point v = corners[i + 2] - p;
    const bool turned = u.x() * v.y() < u.y() * v.x();
    const Point& q = corners[i + (turned ? 2 : 1)];
    const Point& r = corners[i + (turned ? 1 : 2)];
    cairo_move_to(c, p.x(), p.y());
    cairo_line_to(c, q.x(), q.y());
    cairo_line_to(c, r.x(), r.y());
    cairo_close_path(c);
  }
  impl_->Use(paint);
  cairo_fill(c);
}

void Canvas::Line(const Point& a, const Point& b, double width, const Paint& paint) {
  const Point ends[] = {a, b};
  Polyline(ends, {width, paint, {}});
}

void Canvas::Polyline(std::span<const Point> points, const Stroke& stroke) {
  impl_->Trace(points);
  impl_->Draw(stroke);
}

void Canvas::Outline(std::span<const Point> polygon, const Stroke& stroke) {
  impl_->Trace(polygon);
  cairo_close_path(impl_->context.get());
  impl_->Draw(stroke);
}

void Canvas::Disc(const Point& centre, double radius, const Paint& paint) {
  cairo_t* c = impl_->context.get();
  cairo_arc(c, centre.x(), centre.y(), radius, 0.0, 2.0 * sim::kPi);
  impl_->Use(paint);
  cairo_fill(c);
}

void Canvas::Ring(const Point& centre, double radius, const Stroke& stroke) {
  cairo_arc(impl_->context.get(), centre.x(), centre.y(), radius, 0.0, 2.0 * sim::kPi);
  impl_->Draw(stroke);
}

void Canvas::Picture(const sim::Image& image, const Eigen::Affine2d& place, bool smooth) {
  cairo_t* c = impl_->context.get();
  const Surface picture = ToSurface(image);
  const Eigen::Matrix2d& a = place.linear();
  const cairo_matrix_t matrix = {
      a(0, 0), a(1, 0), a(0, 1), a(1, 1), place.translation().x(), place.translation().y()};
  cairo_save(c);
  cairo_transform(c, &matrix);
  cairo_set_source_surface(c, picture.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(c), smooth ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
  cairo_paint(c);
  cairo_restore(c);
}

void Canvas::Clip(const Eigen::AlignedBox2d& box) {
  cairo_t* c = impl_->context.get();
  cairo_save(c);
  cairo_rectangle(c, box.min().x(), box.min().y(), box.sizes().x(), box.sizes().y());
  cairo_clip(c);
}

void Canvas::Unclip() {
  cairo_restore(impl_->context.get());
}

Canvas::Point Canvas::TextSize(const std::string& text, double size, bool bold) const {
  const cairo_text_extents_t extents = impl_->Measure(text, size, bold);
  return {extents.width, extents.height};
}

void Canvas::Text(const Point& at, const std::string& text, const TextStyle& style) {
  cairo_t* c = impl_->context.get();
  const cairo_text_extents_t extents = impl_->Measure(text, style.size, style.bold);
  const double shift = style.align == Align::kLeft ? 0.0 : style.align == Align::kRight ? 1.0 : 0.5;
  cairo_save(c);
  cairo_translate(c, at.x(), at.y());
  if (style.upwards) cairo_rotate(c, -0.5 * sim::kPi);
  cairo_move_to(c, -extents.x_bearing - shift * extents.width, kBaseline * style.size);
  cairo_text_path(c, text.c_str());
  if (style.halo) {
    impl_->Use(kWhite.WithAlpha(0.8));
    cairo_set_line_width(c, 0.25 * style.size);
    cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke_preserve(c);
  }
  impl_->Use(style.paint);
  cairo_fill(c);
  cairo_restore(c);
}

void Canvas::Text(const Point& at, const std::string& text, double size, const Paint& paint) {
  Text(at, text, {.size = size, .paint = paint, .bold = true, .halo = true});
}

sim::Image Canvas::ToImage() const {
  BULLETNAV_CHECK(impl_->kind == Kind::kPixels);
  cairo_surface_flush(impl_->surface.get());
  sim::Image image(cairo_image_surface_get_width(impl_->surface.get()),
                   cairo_image_surface_get_height(impl_->surface.get()), 3);
  for (int y = 0; y < image.height; ++y) {
    const std::uint32_t* row = Row(impl_->surface.get(), y);
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t* p = image.at(x, y);
      p[0] = static_cast<std::uint8_t>(row[x] >> 16);
      p[1] = static_cast<std::uint8_t>(row[x] >> 8);
      p[2] = static_cast<std::uint8_t>(row[x]);
    }
  }
  return image;
}

std::string Canvas::ToSvg() {
  BULLETNAV_CHECK(impl_->kind == Kind::kSvg);
  cairo_surface_finish(impl_->surface.get());
  BULLETNAV_CHECK_EQ(cairo_surface_status(impl_->surface.get()), CAIRO_STATUS_SUCCESS);
  return Renumber(impl_->svg);
}

}  // namespace bulletnav::bench
