// SPDX-License-Identifier: MIT
#include "benchmark/report/canvas.h"

#include <cstddef>

#include <cairo/cairo.h>

#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

}  // namespace

struct Canvas::Impl {
  Impl(int width, int height)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
        context(cairo_create(surface.get())) {
    CHECK_EQ(cairo_status(context.get()), CAIRO_STATUS_SUCCESS);
  }

  void Use(const Paint& paint) const {
    cairo_set_source_rgba(context.get(), paint.red, paint.green, paint.blue, paint.alpha);
  }

  cairo_text_extents_t Measure(const std::string& text, double size) const {
    cairo_select_font_face(context.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_BOLD);
    cairo_set_font_size(context.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(context.get(), text.c_str(), &extents);
    return extents;
  }

  std::uint32_t* row(int y) const {
    unsigned char* data = cairo_image_surface_get_data(surface.get());
    return reinterpret_cast<std::uint32_t*>(
        data + std::ptrdiff_t{cairo_image_surface_get_stride(surface.get())} * y);
  }

  std::unique_ptr<cairo_surface_t, Destroy> surface;
  std::unique_ptr<cairo_t, Destroy> context;
};

Canvas::Canvas(int width, int height, const Paint& background)
    : impl_(std::make_unique<Impl>(width, height)) {
  impl_->Use(background);
  cairo_paint(impl_->context.get());
}

Canvas::Canvas(const sim::Image& image) : impl_(std::make_unique<Impl>(image.width, image.height)) {
  CHECK_EQ(image.channels, 3);
  for (int y = 0; y < image.height; ++y) {
    std::uint32_t* row = impl_->row(y);
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.at(x, y);
      row[x] = std::uint32_t{p[0]} << 16 | std::uint32_t{p[1]} << 8 | p[2];
    }
  }
  cairo_surface_mark_dirty(impl_->surface.get());
}

Canvas::~Canvas() = default;

void Canvas::Fill(std::span<const Point> polygon, const Paint& paint) {
  cairo_t* c = impl_->context.get();
  for (const Point& p : polygon) cairo_line_to(c, p.x(), p.y());
  cairo_close_path(c);
  impl_->Use(paint);
  cairo_fill(c);
}

void Canvas::FillTriangles(std::span<const Point> corners, const Paint& paint) {
  cairo_t* c = impl_->context.get();
  cairo_push_group(c);
  cairo_set_antialias(c, CAIRO_ANTIALIAS_NONE);
  impl_->Use({paint.red, paint.green, paint.blue, 1.0});
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) cairo_line_to(c, corners[i + k].x(), corners[i + k].y());
    cairo_close_path(c);
    cairo_fill(c);
  }
  cairo_pop_group_to_source(c);
  cairo_paint_with_alpha(c, paint.alpha);
}

void Canvas::Line(const Point& a, const Point& b, double width, const Paint& paint) {
  cairo_t* c = impl_->context.get();
  impl_->Use(paint);
  cairo_set_line_width(c, width);
  cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
  cairo_move_to(c, a.x(), a.y());
  cairo_line_to(c, b.x(), b.y());
  cairo_stroke(c);
}

Canvas::Point Canvas::TextSize(const std::string& text, double size) const {
  const cairo_text_extents_t extents = impl_->Measure(text, size);
  return {extents.width, extents.height};
}

void Canvas::Text(const Point& at, const std::string& text, double size, const Paint& paint) {
  cairo_t* c = impl_->context.get();
  const cairo_text_extents_t extents = impl_->Measure(text, size);
  cairo_move_to(c, at.x() - extents.x_bearing - 0.5 * extents.width,
                at.y() - extents.y_bearing - 0.5 * extents.height);
  cairo_text_path(c, text.c_str());
  impl_->Use({1.0, 1.0, 1.0, 0.8});
  cairo_set_line_width(c, 0.25 * size);
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  cairo_stroke_preserve(c);
  impl_->Use(paint);
  cairo_fill(c);
}

sim::Image Canvas::ToImage() const {
  cairo_surface_flush(impl_->surface.get());
  sim::Image image(cairo_image_surface_get_width(impl_->surface.get()),
                   cairo_image_surface_get_height(impl_->surface.get()), 3);
  for (int y = 0; y < image.height; ++y) {
    const std::uint32_t* row = impl_->row(y);
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t* p = image.at(x, y);
      p[0] = static_cast<std::uint8_t>(row[x] >> 16);
      p[1] = static_cast<std::uint8_t>(row[x] >> 8);
      p[2] = static_cast<std::uint8_t>(row[x]);
    }
  }
  return image;
}

}  // namespace bulletnav::bench
