// SPDX-License-Identifier: MIT
#include "benchmark/slam/plots/sequence_figure.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>

#include "benchmark/report/chart.h"
#include "benchmark/report/palette.h"

namespace bulletnav::bench {
namespace {

constexpr double kPanel = 420.0;
constexpr double kTitle = 34.0;
constexpr double kGap = 16.0;

struct Drawing {
  std::vector<SequencePanel> panels;
  std::vector<Canvas::Point> way;  // world x, z
  std::optional<SceneMap> map;
  Eigen::AlignedBox2d extent;
};

/// World to canvas within a panel.
class PanelPlace {
 public:
  PanelPlace(const Eigen::AlignedBox2d& extent, const Eigen::AlignedBox2d& box) {
    const Eigen::Vector2d size = extent.sizes();
    scale_ = std::min(box.sizes().x() / size.x(), box.sizes().y() / size.y());
    offset_ = box.center() - scale_ * extent.center();
  }
  Canvas::Point At(const Eigen::Vector2d& world) const { return scale_ * world + offset_; }

 private:
  double scale_ = 1.0;
  Eigen::Vector2d offset_;
};

void DrawSequence(const Drawing& drawing, const agent::Sequence& sequence, const PanelPlace& place,
                  Canvas* canvas) {
  std::vector<Canvas::Point> points;
  // Up to the next one's first frame, so that the way has no gaps.
  const int last = std::min(sequence.last + 1, static_cast<int>(drawing.way.size()) - 1);
  for (int frame = sequence.first; frame <= last; ++frame) {
    points.push_back(place.At(drawing.way[static_cast<std::size_t>(frame)]));
  }
  if (points.empty()) return;
  const Paint paint = KindColor(sequence.cluster);
  canvas->Polyline(points, {2.5, paint, {}});
  canvas->Disc(points.front(), 3.0, paint);
}

/// Those that have a sequence: short ones join others.
std::size_t ClustersSeen(const agent::SequenceTrace& trace) {
  std::set<int> seen;
  for (const agent::Sequence& sequence : trace.sequences) seen.insert(sequence.cluster);
  return seen.size();
}

void DrawPanel(const Drawing& drawing, std::size_t number, Canvas* canvas) {
  const double left = kGap + static_cast<double>(number) * (kPanel + kGap);
  const Eigen::AlignedBox2d box(Eigen::Vector2d(left, kTitle),
                                Eigen::Vector2d(left + kPanel, kTitle + kPanel));
  const PanelPlace place(drawing.extent, box);
  canvas->Clip(box);
  if (drawing.map) {
    std::vector<Canvas::Point> corners;
    corners.reserve(drawing.map->walkable.size());
    for (const Eigen::Vector2f& corner : drawing.map->walkable) {
      corners.push_back(place.At(corner.cast<double>()));
    }
    canvas->FillTriangles(corners, kInk.WithAlpha(0.08));
  }
  const SequencePanel& panel = drawing.panels[number];
  for (const agent::Sequence& sequence : panel.trace.sequences) {
    DrawSequence(drawing, sequence, place, canvas);
  }
  canvas->Unclip();
  const std::string title = panel.title + ": " + std::to_string(panel.trace.sequences.size()) +
                            " sequences of " + std::to_string(ClustersSeen(panel.trace)) +
                            " clusters";
  canvas->Text({box.center().x(), kTitle / 2.0}, title,
               {14.0, kInk, true, Align::kCenter, false, false});
}

Chart::Series SpreadSeries(const SequencePanel& panel) {
  Chart::Series series{panel.title + ", chose " + std::to_string(ClustersOf(panel.trace)), {}};
  const agent::SequenceTrace& trace = panel.trace;
  series.chosen = ClustersOf(trace);
  for (std::size_t i = 0; i < trace.tried.size() && i < trace.spreads.size(); ++i) {
    const double first = trace.spreads.front();
    const double share = first > 0.0 ? std::clamp(trace.spreads[i] / first, 0.0, 1.0) : 0.0;
    series.values.push_back({static_cast<double>(trace.tried[i]), share, {share, share}});
  }
  return series;
}

}  // namespace

int ClustersOf(const agent::SequenceTrace& trace) {
  int most = -1;
  for (const agent::Sequence& sequence : trace.sequences) most = std::max(most, sequence.cluster);
  return most + 1;
}

Figure SequenceFigure(const std::vector<sim::BodyPose>& truth,
                      const std::vector<SequencePanel>& panels,
                      const std::optional<SceneMap>& map) {
  auto drawing = std::make_shared<Drawing>();
  drawing->panels = panels;
  drawing->map = map;
  for (const sim::BodyPose& pose : truth) {
    drawing->way.emplace_back(pose.position.x(), pose.position.z());
    drawing->extent.extend(drawing->way.back());
  }
  if (drawing->extent.isEmpty()) drawing->extent.extend(Eigen::Vector2d::Zero());
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(0.5);
  drawing->extent.extend(Eigen::Vector2d(drawing->extent.min() - margin));
  drawing->extent.extend(Eigen::Vector2d(drawing->extent.max() + margin));
  Figure figure;
  figure.width = static_cast<int>(kGap + static_cast<double>(panels.size()) * (kPanel + kGap));
  figure.height = static_cast<int>(kTitle + kPanel + kGap);
  figure.draw = [drawing](Canvas* canvas) {
    for (std::size_t i = 0; i < drawing->panels.size(); ++i) DrawPanel(*drawing, i, canvas);
  };
  return figure;
}

Figure ElbowFigure(const std::vector<SequencePanel>& panels) {
  Chart chart;
  chart.x_label = "Clusters";
  chart.y_label = "Spread, of that of the fewest";
  chart.has_marks = false;
  for (int tick = 0; tick <= 60; tick += 10) {
    chart.ticks.push_back({static_cast<double>(tick), std::to_string(tick)});
  }
  for (const SequencePanel& panel : panels) chart.series.push_back(SpreadSeries(panel));
  return ChartFigure({&chart, 1});
}

}  // namespace bulletnav::bench
