// SPDX-License-Identifier: MIT
#include "benchmark/base/gzip.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

std::string Text() {
  std::string text;
  for (int i = 0; i < 40'000; ++i) text += std::to_string(i * i) + ", ";
  return text;
}

TEST(Gzip, UnpacksWhatItPacked) {
  for (const std::string& text : {std::string(), std::string("x"), Text()}) {
    const auto bytes = Compress(text);
    EXPECT_TRUE(IsGzip(bytes));
    EXPECT_EQ(Decompress(bytes), text);
    EXPECT_EQ(bytes, Compress(text));
  }
}

TEST(Gzip, HoldsNoDate) {
  const auto bytes = Compress("x");
  EXPECT_THAT(std::vector(bytes.begin() + 4, bytes.begin() + 8), testing::Each(0));
}

TEST(Gzip, ReadsMembersOneAfterTheOther) {
  auto bytes = Compress("one, ");
  const auto second = Compress("two");
  bytes.insert(bytes.end(), second.begin(), second.end());
  EXPECT_EQ(Decompress(bytes), "one, two");
}

TEST(Gzip, RefusesWhatIsCutOff) {
  const auto bytes = Compress(Text());
  for (const std::size_t size : {2ul, 9ul, 11ul, bytes.size() / 2, bytes.size() - 1}) {
    try {
      Decompress(std::span(bytes).first(size));
      ADD_FAILURE() << "accepted " << size << " bytes";
    } catch (const sim::Error& e) {
      EXPECT_THAT(e.what(), HasSubstr("cut off"));
    }
  }
}

TEST(Gzip, RefusesWhatIsDamaged) {
  const auto sound = Compress(Text());
  auto flipped = sound;
  flipped[flipped.size() / 2] ^= 0x55;
  EXPECT_THROW(Decompress(flipped), sim::Error);
  auto trailing = sound;
  trailing.insert(trailing.end(), {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  EXPECT_THROW(Decompress(trailing), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
