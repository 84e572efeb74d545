// SPDX-License-Identifier: MIT
#include "agent/slam/topology/online_sequences.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

/// A frame of a room: its direction, a little off.
PictureDescriptor FrameOf(int room, std::uint64_t time) {
  sim::Rng fixed(static_cast<std::uint64_t>(room), "room");
  sim::Rng noise(time, "noise");
  std::vector<std::int64_t> numbers(32);
  for (std::int64_t& number : numbers) {
    number = std::llround(1000.0 * fixed.Normal() + 200.0 * noise.Normal());
  }
  return DirectionOf(numbers);
}

OnlineSequences Drive(const std::vector<int>& rooms, const OnlineClusterSpec& spec = {}) {
  OnlineSequences sequences(spec);
  for (std::size_t i = 0; i < rooms.size(); ++i) sequences.Add(FrameOf(rooms[i], i));
  return sequences;
}

TEST(OnlineSequences, RoomsAreClustersAndStaysAreSequences) {
  const auto drive = Drive({1, 1, 1, 1, 2, 2, 2, 2, 1, 1, 1, 3, 3, 3});
  EXPECT_EQ(drive.clusters(), 3);
  ASSERT_EQ(drive.sequences().size(), 4u);
  EXPECT_EQ(drive.sequences()[2].cluster, drive.sequences()[0].cluster);
  EXPECT_EQ(drive.sequences()[1].first, 4);
  EXPECT_EQ(drive.sequences()[1].last, 7);
  EXPECT_GT(Cosine(drive.wholes()[0], drive.wholes()[2]), 0.95);
  EXPECT_LT(Cosine(drive.wholes()[0], drive.wholes()[1]), 0.6);
}

TEST(OnlineSequences, ShortStaysJoinTheOneBefore) {
  const auto drive = Drive({1, 1, 1, 1, 2, 1, 1, 1, 1, 3, 3, 3});
  ASSERT_EQ(drive.sequences().size(), 2u);
  EXPECT_EQ(drive.sequences()[0].last, 8);
}

/// In order, together all frames, at every moment; and no frame changes what came long before it.
TEST(OnlineSequences, AreWholeAtEveryMoment) {
  sim::Rng rng(5, "rooms");
  OnlineSequences sequences({});
  std::vector<Sequence> before;
  int room = 0;
  for (int frame = 0; frame < 200; ++frame) {
    if (rng.Chance(0.15)) room = rng.Below(6);
    sequences.Add(FrameOf(room, static_cast<std::uint64_t>(frame)));
    int next = 0;
    for (const Sequence& sequence : sequences.sequences()) {
      EXPECT_EQ(sequence.first, next);
      next = sequence.last + 1;
    }
    EXPECT_EQ(next, frame + 1);
    EXPECT_EQ(sequences.wholes().size(), sequences.sequences().size());
    // All but the last two stay.
    for (std::size_t i = 0; i + 2 < before.size(); ++i) {
      EXPECT_EQ(sequences.sequences()[i].last, before[i].last);
    }
    before = sequences.sequences();
  }
  EXPECT_LE(sequences.clusters(), 8);
}

TEST(OnlineSequences, BadSettingsAreRefused) {
  EXPECT_THROW((OnlineClusterSpec{.least_like = 2.0}.Validate()), sim::Error);
  EXPECT_THROW((OnlineClusterSpec{.stay = -1.0}.Validate()), sim::Error);
  EXPECT_THROW((OnlineClusterSpec{.shortest = 0}.Validate()), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
