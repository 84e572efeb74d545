// SPDX-License-Identifier: MIT
#include "benchmark/slam/plots/room_figure.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>

#include <fmt/core.h>

#include "benchmark/report/palette.h"
#include "benchmark/report/room_labels.h"

namespace bulletnav::bench {
namespace {

constexpr double kPanel = 420.0;
constexpr double kTitle = 34.0;
constexpr double kGap = 16.0;
constexpr double kNames = 150.0;  // the rooms' names below the panels
constexpr double kNumbers = 24.0;

const sim::Room* RoomOf(const sim::FloorPlan& plan, const sim::BodyPose& pose) {
  return RoomAt(plan,
                {static_cast<float>(pose.position.x()), static_cast<float>(pose.position.z())});
}

std::ptrdiff_t MostIn(const std::vector<int>& frames) {
  return std::max_element(frames.begin(), frames.end()) - frames.begin();
}

/// Clusters with frames in rooms, those of the first room first, the largest of a room first.
std::vector<std::size_t> OrderOf(const RoomCounts& counts) {
  std::vector<std::size_t> order;
  for (std::size_t cluster = 0; cluster < counts.frames.size(); ++cluster) {
    const std::vector<int>& frames = counts.frames[cluster];
    if (std::accumulate(frames.begin(), frames.end(), 0) > 0) order.push_back(cluster);
  }
  std::stable_sort(order.begin(), order.end(), [&counts](std::size_t a, std::size_t b) {
    const std::vector<int>& first = counts.frames[a];
    const std::vector<int>& second = counts.frames[b];
    if (MostIn(first) != MostIn(second)) return MostIn(first) < MostIn(second);
    return *std::max_element(first.begin(), first.end()) >
           *std::max_element(second.begin(), second.end());
  });
  return order;
}

double PurityOf(const std::vector<std::vector<int>>& clusters) {
  int in_rooms = 0;
  int in_best = 0;
  for (const std::vector<int>& frames : clusters) {
    if (frames.empty()) continue;
    in_rooms += std::accumulate(frames.begin(), frames.end(), 0);
    in_best += *std::max_element(frames.begin(), frames.end());
  }
  return in_rooms == 0 ? 0.0 : static_cast<double>(in_best) / in_rooms;
}

struct Panel {
  std::string title;
  RoomCounts counts;
  std::vector<std::size_t> order;
};

void DrawRow(const std::vector<int>& frames, const Eigen::AlignedBox2d& row, Canvas* canvas) {
  const double all = std::accumulate(frames.begin(), frames.end(), 0);
  const double width = row.sizes().x() / static_cast<double>(frames.size());
  for (std::size_t room = 0; room < frames.size(); ++room) {
    if (frames[room] == 0) continue;
    const double left = row.min().x() + static_cast<double>(room) * width;
    const std::vector<Canvas::Point> cell = {{left, row.min().y()},
                                             {left + width, row.min().y()},
                                             {left + width, row.max().y()},
                                             {left, row.max().y()}};
    canvas->Fill(cell, kBlue.WithAlpha(frames[room] / all));
  }
}

void DrawPanel(const Panel& panel, double left, Canvas* canvas) {
  canvas->Text({left + kPanel / 2.0, kTitle / 2.0}, panel.title,
               {14.0, kInk, true, Align::kCenter, false, false});
  const double height = kPanel / static_cast<double>(std::max<std::size_t>(1, panel.order.size()));
  for (std::size_t i = 0; i < panel.order.size(); ++i) {
    const double top = kTitle + static_cast<double>(i) * height;
    DrawRow(panel.counts.frames[panel.order[i]],
            {Eigen::Vector2d(left, top), Eigen::Vector2d(left + kPanel, top + height)}, canvas);
    canvas->Text({left - 4.0, top + height / 2.0}, std::to_string(panel.order[i]),
                 {std::min(11.0, height), kInk, false, Align::kRight, false, false});
  }
  const std::size_t rooms = panel.counts.rooms.size();
  const double width = kPanel / static_cast<double>(std::max<std::size_t>(1, rooms));
  for (std::size_t room = 0; room < rooms; ++room) {
    // Names take turns in height, so that long ones do not run into each other.
    const double below = kTitle + kPanel + 12.0 + 14.0 * static_cast<double>(room % 8);
    const double middle = left + (static_cast<double>(room) + 0.5) * width;
    canvas->Line({middle, kTitle + kPanel}, {middle, below - 6.0}, 0.5, kInk.WithAlpha(0.5));
    canvas->Text({middle, below}, panel.counts.rooms[room],
                 {11.0, kInk, false, Align::kCenter, false, false});
  }
  const std::vector<Canvas::Point> frame = {{left, kTitle},
                                            {left + kPanel, kTitle},
                                            {left + kPanel, kTitle + kPanel},
                                            {left, kTitle + kPanel}};
  canvas->Outline(frame, {1.0, kInk, {}});
}

}  // namespace

RoomCounts CountRooms(const agent::SequenceTrace& trace, const std::vector<sim::BodyPose>& truth,
                      const sim::FloorPlan& plan) {
  RoomCounts counts;
  // [room][cluster]
  std::vector<std::vector<int>> all(
      plan.rooms.size(), std::vector<int>(static_cast<std::size_t>(ClustersOf(trace)), 0));
  for (const agent::Sequence& sequence : trace.sequences) {
    const int last = std::min(sequence.last, static_cast<int>(truth.size()) - 1);
    for (int frame = sequence.first; frame <= last; ++frame) {
      const sim::Room* room = RoomOf(plan, truth[static_cast<std::size_t>(frame)]);
      int* count = room == nullptr ? &counts.between
                                   : &all[static_cast<std::size_t>(room - plan.rooms.data())]
                                         [static_cast<std::size_t>(sequence.cluster)];
      ++*count;
    }
  }
  counts.frames.resize(static_cast<std::size_t>(ClustersOf(trace)));
  for (std::size_t room = 0; room < all.size(); ++room) {
    if (std::accumulate(all[room].begin(), all[room].end(), 0) == 0) continue;
    counts.rooms.push_back(plan.rooms[room].name);
    for (std::size_t i = 0; i < all[room].size(); ++i) counts.frames[i].push_back(all[room][i]);
  }
  counts.purity = PurityOf(counts.frames);
  return counts;
}

Figure RoomFigure(const std::vector<sim::BodyPose>& truth, const std::vector<SequencePanel>& panels,
                  const sim::FloorPlan& plan) {
  auto drawn = std::make_shared<std::vector<Panel>>();
  for (const SequencePanel& panel : panels) {
    Panel& added = drawn->emplace_back();
    added.counts = CountRooms(panel.trace, truth, plan);
    added.order = OrderOf(added.counts);
    added.title =
        fmt::format("{}: {} clusters, {} rooms, purity {:.2f}", panel.title,
                    added.counts.frames.size(), added.counts.rooms.size(), added.counts.purity);
  }
  Figure figure;
  figure.width =
      static_cast<int>(kGap + static_cast<double>(drawn->size()) * (kNumbers + kPanel + kGap));
  figure.height = static_cast<int>(kTitle + kPanel + kNames);
  figure.draw = [drawn](Canvas* canvas) {
    double left = kGap + kNumbers;
    for (const Panel& panel : *drawn) {
      DrawPanel(panel, left, canvas);
      left += kNumbers + kPanel + kGap;
    }
  };
  return figure;
}

}  // namespace bulletnav::bench
