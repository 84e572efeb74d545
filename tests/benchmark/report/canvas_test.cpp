// SPDX-License-Identifier: MIT
#include "benchmark/report/canvas.h"

#include <vector>

#include <gmock/gmock.h>

#include "tests/support/svg.h"

namespace bulletnav::bench {
namespace {

using Point = Canvas::Point;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr Paint kRed = {1.0, 0.0, 0.0};
constexpr Paint kBlue = {0.0, 0.0, 1.0};

std::vector<int> At(const Canvas& canvas, int x, int y) {
  const sim::Image image = canvas.ToImage();
  const std::uint8_t* p = image.at(x, y);
  return {p[0], p[1], p[2]};
}

sim::Image FourPixels() {
  sim::Image image(2, 2, 4);
  image.pixels = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 0, 0, 0, 0};
  return image;
}

void DrawOneOfEach(Canvas* canvas) {
  const std::vector<Point> triangle = {{5, 5}, {35, 5}, {20, 30}};
  canvas->Fill(triangle, kRed);
  canvas->Outline(triangle, {2.0, kBlue, {3.0, 1.0}});
  canvas->FillTriangles(triangle, kBlue.WithAlpha(0.5));
  canvas->Polyline(triangle, {1.0, kBlue, {}});
  canvas->Disc({10, 35}, 4.0, kRed);
  canvas->Ring({20, 35}, 4.0, {1.0, kRed, {}});
  canvas->Clip({Point(0, 0), Point(30, 30)});
  canvas->Picture(FourPixels(), Eigen::Affine2d(Eigen::Scaling(10.0)), false);
  canvas->Unclip();
  canvas->Text({20, 20}, "a < b & \"c\"", {.size = 8.0, .paint = kBlue, .halo = true});
}

TEST(Canvas, FillsWhatIsInsideAndNothingElse) {
  Canvas canvas(40, 40, kWhite);
  canvas.Fill(std::vector<Point>{{10, 10}, {30, 10}, {30, 30}, {10, 30}}, kRed);
  EXPECT_THAT(At(canvas, 20, 20), ElementsAre(255, 0, 0));
  EXPECT_THAT(At(canvas, 9, 20), ElementsAre(255, 255, 255));
}

TEST(Canvas, TrianglesBlendOnceAndWithoutSeamsWhateverTheirSense) {
  Canvas canvas(40, 40, kWhite);
  // A square of two triangles of opposite sense, then one of them again.
  const std::vector<Point> corners = {{0, 0},   {40, 0}, {40, 40}, {0, 0},  {0, 40},
                                      {40, 40}, {0, 0},  {40, 0},  {40, 40}};
  canvas.FillTriangles(corners, kBlue.WithAlpha(0.5));
  const std::vector<int> blended = At(canvas, 35, 5);
  for (const auto& [x, y] : {std::pair{20, 20}, {10, 10}, {5, 35}, {33, 33}}) {
    EXPECT_EQ(At(canvas, x, y), blended) << x << " " << y;
  }
}

TEST(Canvas, PicturesLieWhereTheirTransformPutsThem) {
  Canvas canvas(40, 40, kWhite);
  // A quarter turn: x of the picture goes down the canvas, y to the left.
  Eigen::Affine2d place;
  place.linear() << 0.0, -10.0, 10.0, 0.0;
  place.translation() << 30.0, 10.0;
  canvas.Picture(FourPixels(), place, false);
  EXPECT_THAT(At(canvas, 25, 15), ElementsAre(255, 0, 0));
  EXPECT_THAT(At(canvas, 25, 25), ElementsAre(0, 255, 0));
  EXPECT_THAT(At(canvas, 15, 15), ElementsAre(0, 0, 255));
  EXPECT_THAT(At(canvas, 15, 25), ElementsAre(255, 255, 255)) << "clear";
  EXPECT_THAT(At(canvas, 35, 35), ElementsAre(255, 255, 255)) << "outside";
}

TEST(Canvas, ScaleMakesMorePixelsOfTheSameDrawing) {
  Canvas canvas(40, 20, kWhite, Canvas::Kind::kPixels, 3.0);
  canvas.Disc({30, 10}, 5.0, kRed);
  EXPECT_EQ(canvas.ToImage().width, 120);
  EXPECT_EQ(canvas.ToImage().height, 60);
  EXPECT_THAT(At(canvas, 90, 30), ElementsAre(255, 0, 0));
}

TEST(Canvas, ClippedDrawingEndsAtTheBox) {
  Canvas canvas(40, 40, kWhite);
  canvas.Clip({Point(0, 0), Point(20, 40)});
  canvas.Line({0, 20}, {40, 20}, 6.0, kRed);
  canvas.Unclip();
  EXPECT_THAT(At(canvas, 10, 20), ElementsAre(255, 0, 0));
  EXPECT_THAT(At(canvas, 30, 20), ElementsAre(255, 255, 255));
}

TEST(Canvas, SvgIsWellFormedAndItsReferencesLeadSomewhere) {
  Canvas canvas(40, 40, kWhite, Canvas::Kind::kSvg);
  DrawOneOfEach(&canvas);
  const std::string svg = canvas.ToSvg();
  EXPECT_EQ(tests::SvgProblem(svg), "");
  EXPECT_THAT(svg, HasSubstr("<path"));
  EXPECT_THAT(svg, HasSubstr("<image"));
  EXPECT_THAT(svg, Not(HasSubstr("<text"))) << "outlines look the same everywhere";
}

TEST(Canvas, SameCallsGiveTheSameBytes) {
  std::vector<std::string> svgs;
  std::vector<std::vector<std::uint8_t>> images;
  for (int i = 0; i < 2; ++i) {
    Canvas svg(40, 40, kWhite, Canvas::Kind::kSvg);
    Canvas pixels(40, 40, kWhite);
    DrawOneOfEach(&svg);
    DrawOneOfEach(&pixels);
    svgs.push_back(svg.ToSvg());
    images.push_back(pixels.ToImage().pixels);
  }
  EXPECT_EQ(svgs[0], svgs[1]);
  EXPECT_EQ(images[0], images[1]);
}

}  // namespace
}  // namespace bulletnav::bench
