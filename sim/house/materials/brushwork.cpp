// SPDX-License-Identifier: MIT
#include "sim/house/materials/brushwork.h"

#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {

void PaintOver(Canvas* canvas, const Brush& brush, Rng* rng) {
  const Canvas sketch = *canvas;
  for (int i = 0; i < brush.strokes; ++i) {
    const Point at = Anywhere(*rng);
    const float angle =
        brush.angle + brush.sway * (Noise(at, {4, 4, 7}) + Between(*rng, -0.3f, 0.3f));
    const Point half = Turned({0.5f * brush.length * Between(*rng, 0.6f, 1.3f), 0.0f}, angle);
    const float tone = Between(*rng, 0.93f, 1.07f);
    const Color tint = {Between(*rng, -5.0f, 5.0f), Between(*rng, -5.0f, 5.0f),
                        Between(*rng, -5.0f, 5.0f)};
    const Stroke stroke = {at - half, at + half, brush.width * Between(*rng, 0.6f, 1.2f)};
    canvas->Paint(stroke, sketch.At(at) * tone + tint, {0.85f, 0.006f});
  }
}

void Write(Canvas* canvas, const Writing& writing, Rng* rng) {
  const Box& box = writing.box;
  const float pitch = (box.high.y - box.low.y) / static_cast<float>(writing.lines);
  const float space = 1.6f * writing.width;
  for (int line = 0; line < writing.lines; ++line) {
    const float y = box.low.y + (static_cast<float>(line) + 0.5f) * pitch;
    const float end = line + 1 == writing.lines ? Mix(box.low.x, box.high.x, 0.6f) : box.high.x;
    float x = box.low.x;
    while (x < end) {
      const float word = std::min(Between(*rng, 2.0f, 7.0f) * writing.width, end - x);
      canvas->Paint(Rect{{x, y - 0.5f * writing.width}, {x + word, y + 0.5f * writing.width}},
                    writing.ink, {0.8f, 0.0f});
      x += word + space;
    }
  }
}

}  // namespace bulletnav::sim::materials
