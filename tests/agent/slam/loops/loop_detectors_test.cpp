// SPDX-License-Identifier: MIT
// All detectors, each on a made-up drive that comes by the same places twice.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/retrieval/picture_descriptor.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kPlaces = 60;
constexpr int kApart = 20;
constexpr int kWidth = 64;
constexpr int kHeight = 32;

struct Seen {
  OrbFeatures features;
  std::vector<std::uint8_t> color;
  PictureDescriptor descriptor;
};

constexpr int kDescriptorSize = 64;

/// A direction of a place, a little different each time; that of ten places in a row, a room, is
/// much the same.
PictureDescriptor DescriptorOf(int place, sim::Rng* noise) {
  sim::Rng own(static_cast<std::uint64_t>(place), "own");
  sim::Rng room(static_cast<std::uint64_t>(place / 10), "room");
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < kDescriptorSize; ++i) {
    numbers.push_back(
        std::llround(1000.0 * room.Normal() + 700.0 * own.Normal() + 100.0 * noise->Normal()));
  }
  return DirectionOf(numbers);
}

/// Twenty descriptors of a place, a little different each time.
void AddDescriptors(int place, sim::Rng* noise, Seen* seen) {
  sim::Rng fixed(static_cast<std::uint64_t>(place), "descriptors");
  for (int i = 0; i < 20; ++i) {
    BinaryDescriptor descriptor{};
    for (std::uint64_t& word : descriptor) {
      word = (static_cast<std::uint64_t>(fixed.Next()) << 32) | fixed.Next();
    }
    for (int bit = 0; bit < 5; ++bit) {
      descriptor[static_cast<std::size_t>(noise->Below(4))] ^= std::uint64_t{1} << noise->Below(64);
    }
    seen->features.descriptors.push_back(descriptor);
    seen->features.corners.push_back({});
  }
}

/// A place: blocks of grey of its own, and descriptors, half of which the next place has too.
Seen See(int place, int time) {
  sim::Rng fixed(static_cast<std::uint64_t>(place), "place");
  sim::Rng noise(static_cast<std::uint64_t>(time), "noise");
  Seen seen;
  AddDescriptors(place, &noise, &seen);
  AddDescriptors(place + 1, &noise, &seen);
  seen.descriptor = DescriptorOf(place, &noise);
  std::vector<int> blocks(32 * 16);
  for (int& block : blocks) block = fixed.Between(20, 230);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const int grey = blocks[static_cast<std::size_t>(y / 2 * 32 + x / 2)] + noise.Between(-8, 8);
      seen.color.insert(seen.color.end(), 3, static_cast<std::uint8_t>(grey));
    }
  }
  return seen;
}

std::shared_ptr<const Vocabulary> SomeVocabulary() {
  std::vector<std::vector<BinaryDescriptor>> pictures;
  for (int place = 0; place < kPlaces; ++place) {
    pictures.push_back(See(place, 1000 + place).features.descriptors);
  }
  return std::make_shared<const Vocabulary>(pictures, VocabularySpec{.branches = 5, .levels = 4});
}

/// The sum of the last pictures with some weights.
class WeighedPictures final : public SequenceFilter {
 public:
  explicit WeighedPictures(std::vector<int> weights) : weights_(std::move(weights)) {}
  int length() const override { return static_cast<int>(weights_.size()); }
  int size() const override { return kDescriptorSize; }
  PictureDescriptor Describe(std::span<const PictureDescriptor> pictures) const override {
    std::vector<std::int64_t> sum(kDescriptorSize, 0);
    for (std::size_t k = 0; k < pictures.size(); ++k) {
      const int weight = weights_[weights_.size() - pictures.size() + k];
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * pictures[k][i];
    }
    return DirectionOf(sum);
  }

 private:
  std::vector<int> weights_;
};

/// Takes panoramas for of one node by the cosine of their codes, which are descriptors here.
class CosineModel final : public SemanticModel {
 public:
  std::vector<PanoramaCode> Encode(std::span<const Panorama> panoramas) override {
    return std::vector<PanoramaCode>(panoramas.size());
  }
  std::array<float, kDirections> Explorable(const PanoramaCode& /*source*/) override { return {}; }
  std::vector<PairPrediction> Compare(std::span<const PanoramaCode* const> sources,
                                      const PanoramaCode& goal) override {
    std::vector<PairPrediction> said(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const double cosine = std::inner_product(goal.begin(), goal.end(), sources[i]->begin(), 0.0);
      said[i].same_node = static_cast<float>(cosine / (1.0 * kDescriptorUnit * kDescriptorUnit));
    }
    return said;
  }
};

bool NeedsDescriptors(const std::string& name) {
  return name.starts_with("gem_") || name.starts_with("hut") || name.starts_with("seqnet");
}

/// Settings under which places of one room are not taken for one another.
std::string NeedsLikeness(const std::string& name) {
  if (name == "hut_online") return "{least_frame: 0.95, least_sequence: 0.7, sequence_weight: 0}";
  return name.starts_with("hut") ? "{least_frame: 0.95, least_sequence: 0.7, sequence_weight: 0, "
                                   "window_weight: 0}"
                                 : "{least_frame: 0.95}";
}

std::unique_ptr<LoopDetector> Make(
    const std::string& name, const std::string& other,
    std::shared_ptr<const SequenceFilter> filter = std::make_shared<WeighedPictures>(std::vector{
        1, 1, 1, 1, 1})) {
  // Frames are half like their neighbours here, less than in drives, to which likeness is compared.
  std::optional<sim::YamlNode> parameters;
  if (name == "words_hierarchy") parameters = sim::ParseYaml("{least_frame: 1.0}", "test");
  if (NeedsDescriptors(name)) {
    parameters = sim::ParseYaml(NeedsLikeness(name), "test");
  }
  if (name == "same_node") parameters = sim::ParseYaml("{least: 0.95, window: 1}", "test");
  if (name == "orbslam_like") parameters = sim::ParseYaml("{common_words: 10}", "test");
  // Pictures are too small here for corners.
  if (name == "rtabmap_like") parameters = sim::ParseYaml("{own_corners: false}", "test");
  if (!other.empty()) parameters = sim::ParseYaml(other, "test");
  return ConfigureLoopDetector(sim::ParseYaml(name, "test"),
                               parameters)({SomeVocabulary(), kDescriptorSize, nullptr,
                                            std::move(filter), std::make_shared<CosineModel>()});
}

/// Places in turn, twice, or each only once.
std::vector<LoopCandidate> DriveWith(LoopDetector* detector, bool is_twice) {
  std::vector<LoopCandidate> all;
  const int frames = is_twice ? 2 * kPlaces : kPlaces;
  for (int i = 0; i < frames; ++i) {
    const Seen seen = See(i % kPlaces, i);
    LoopFrame frame;
    frame.number = i;
    frame.width_px = kWidth;
    frame.height_px = kHeight;
    frame.color = seen.color;
    frame.features = &seen.features;
    frame.descriptor = seen.descriptor;
    const PanoramaCode code(seen.descriptor.begin(), seen.descriptor.end());
    frame.code = &code;
    frame.odometry = {5.0 * (i % kPlaces), 0.0, 0.0};
    frame.comparable = std::max(0, i - kApart);
    const auto found = detector->Add(frame);
    all.insert(all.end(), found.begin(), found.end());
  }
  const auto late = detector->Finish();
  all.insert(all.end(), late.begin(), late.end());
  return all;
}

/// `parameters`, if there are any, instead of usual ones.
std::vector<LoopCandidate> Drive(const std::string& name, bool is_twice,
                                 const std::string& parameters = {}) {
  return DriveWith(Make(name, parameters).get(), is_twice);
}

class AllDetectors : public ::testing::TestWithParam<std::string> {};

TEST_P(AllDetectors, ProposesTheSamePlacesAndNoOthers) {
  int proposed = 0;
  for (const LoopCandidate& pair : Drive(GetParam(), true)) {
    EXPECT_LT(pair.earlier, pair.later - kApart);
    EXPECT_GE(pair.earlier, 0);
    if (!pair.is_proposed) continue;
    ++proposed;
    EXPECT_NEAR(pair.later - pair.earlier, kPlaces, 2) << pair.later;
  }
  EXPECT_GT(proposed, kPlaces / 2);
}

TEST_P(AllDetectors, ProposesNothingWhereAllIsNew) {
  for (const LoopCandidate& pair : Drive(GetParam(), false)) {
    EXPECT_FALSE(pair.is_proposed) << pair.later << " " << pair.earlier;
  }
}

TEST_P(AllDetectors, RightPairsScoreHigher) {
  std::vector<double> right;
  std::vector<double> wrong;
  for (const LoopCandidate& pair : Drive(GetParam(), true)) {
    if (pair.later < kPlaces + 20) continue;
    (pair.later - pair.earlier == kPlaces ? right : wrong).push_back(pair.score);
  }
  ASSERT_FALSE(right.empty());
  const double least = *std::min_element(right.begin(), right.end());
  const auto above = std::count_if(wrong.begin(), wrong.end(), [least](double score) {
    return score > least;
  });
  EXPECT_LE(above, static_cast<std::ptrdiff_t>(wrong.size() / 20));
}

TEST_P(AllDetectors, AnswersTheSameEachTime) {
  const auto first = Drive(GetParam(), true);
  const auto second = Drive(GetParam(), true);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].earlier, second[i].earlier);
    EXPECT_EQ(first[i].score, second[i].score);
    EXPECT_EQ(first[i].is_proposed, second[i].is_proposed);
  }
}

INSTANTIATE_TEST_SUITE_P(LoopDetectors, AllDetectors, ::testing::ValuesIn(LoopDetectorNames()),
                         [](const auto& detector) {
                           return detector.param;
                         });

TEST(SameNode, NeedsAModelOfPlaces) {
  EXPECT_THAT(
      [] {
        ConfigureLoopDetector(sim::ParseYaml("same_node", "test"), std::nullopt)({});
      },
      ThrowsMessage<sim::Error>(HasSubstr("'places'")));
}

TEST(SameNode, ScoresAreMeansOverFramesAround) {
  const auto scores = [](const std::string& parameters) {
    std::map<std::pair<int, int>, double> by_pair;
    for (const LoopCandidate& one : Drive("same_node", true, parameters)) {
      by_pair[{one.later, one.earlier}] = one.score;
    }
    return by_pair;
  };
  const auto alone = scores("{window: 1}");
  for (const auto& [pair, score] : scores("{window: 3}")) {
    double sum = 0.0;
    int count = 0;
    for (int later = pair.first - 2; later <= pair.first; ++later) {
      for (int earlier = pair.second - 1; earlier <= pair.second + 1; ++earlier) {
        const auto found = alone.find({later, earlier});
        if (found == alone.end()) continue;
        sum += found->second;
        ++count;
      }
    }
    EXPECT_NEAR(score, sum / count, 1e-6);
  }
}

TEST(SameNode, OdometrySpeaksAgainstPairsThatItHasFarApart) {
  const auto alone = Drive("same_node", true, "{window: 1}");
  const auto told = Drive("same_node", true, "{window: 1, odometry_weight: 0.1}");
  ASSERT_EQ(told.size(), alone.size());
  int lower = 0;
  for (std::size_t i = 0; i < told.size(); ++i) {
    // Places in turn are 5 m apart, and nothing is against the same one.
    if ((told[i].later - told[i].earlier) % kPlaces == 0) {
      EXPECT_EQ(told[i].score, alone[i].score);
    } else {
      EXPECT_LE(told[i].score, alone[i].score);
      lower += told[i].score < alone[i].score ? 1 : 0;
    }
  }
  EXPECT_GT(lower, static_cast<int>(told.size() / 2));
}

TEST(LoopFrame, WhatNeedsAFlatCameraSaysSoOfPanoramas) {
  const auto detector = Make("orbslam_like", "{native_gates: true}");
  const Seen seen = See(1, 1);
  LoopFrame frame;
  frame.color = seen.color;
  frame.features = &seen.features;
  EXPECT_THAT(
      [&] {
        detector->Add(frame);
      },
      ThrowsMessage<sim::Error>(AllOf(HasSubstr("native_gates"), HasSubstr("panorama"))));
}

TEST(LoopRegistry, AnUnknownDetectorIsToldWithTheKnownOnes) {
  const auto configure = [] {
    ConfigureLoopDetector(sim::ParseYaml("bwo", "c.yaml"), std::nullopt);
  };
  EXPECT_THAT(configure,
              ThrowsMessage<sim::FileError>(AllOf(HasSubstr("bow, "), HasSubstr("seqslam"))));
  EXPECT_THAT(LoopDetectorNames(), Contains("bow"));
}

TEST(LoopRegistry, ParametersAreCheckedAtTheirPlace) {
  const auto configure = [] {
    ConfigureLoopDetector(sim::ParseYaml("seqslam", "c.yaml"),
                          sim::ParseYaml("{cols: 63}", "c.yaml"));
  };
  EXPECT_THAT(configure, ThrowsMessage<sim::FileError>(HasSubstr("multiples of patch")));
  EXPECT_THAT(ResolveLoopConfig(sim::ParseYaml("bow", "c.yaml"), std::nullopt),
              HasSubstr("least_score: 0.3"));
}

TEST(LoopRegistry, DetectorsThatNeedDescriptorsSaySo) {
  for (const std::string& name : LoopDetectorNames()) {
    if (!NeedsDescriptors(name)) continue;
    const auto make = ConfigureLoopDetector(sim::ParseYaml(name, "c.yaml"), std::nullopt);
    EXPECT_THAT(
        [&] {
          make({});
        },
        ThrowsMessage<sim::Error>(HasSubstr("needs descriptors")));
  }
  EXPECT_THAT(ResolveLoopConfig(sim::ParseYaml("hut_fixed5", "c.yaml"), std::nullopt),
              HasSubstr("length: 5"));
}

/// What a hierarchy names is part of what comparing all with all names, with the same scores.
TEST(Hierarchies, NamePairsOfTheFlatComparison) {
  std::map<std::pair<int, int>, double> flat;
  for (const LoopCandidate& pair : Drive("gem_flat", true)) {
    flat[{pair.later, pair.earlier}] = pair.score;
  }
  for (const char* name : {"hut", "hut_fixed5", "hut_online"}) {
    const auto pairs = Drive(name, true);
    EXPECT_LT(pairs.size(), flat.size() / 2) << name;
    for (const LoopCandidate& pair : pairs) {
      const auto found = flat.find({pair.later, pair.earlier});
      ASSERT_NE(found, flat.end()) << name;
      EXPECT_EQ(found->second, pair.score) << name;
    }
  }
}

/// A pair's score has the best pair of the frames around, as much as it is told to.
TEST(Hierarchies, WindowsAreAPartOfTheScore) {
  const std::string alike = "{least_sequence: 0.7, sequence_weight: 0, window: 2, window_weight: ";
  std::map<std::pair<int, int>, double> pictures;
  std::map<std::pair<int, int>, double> best;
  for (const LoopCandidate& pair : Drive("hut", true, alike + "0}")) {
    pictures[{pair.later, pair.earlier}] = pair.score;
  }
  for (const LoopCandidate& pair : Drive("hut", true, alike + "1}")) {
    best[{pair.later, pair.earlier}] = pair.score;
  }
  const auto both = Drive("hut", true, alike + "0.5}");
  ASSERT_EQ(both.size(), pictures.size());
  for (const LoopCandidate& pair : both) {
    const std::pair<int, int> key = {pair.later, pair.earlier};
    EXPECT_GE(best.at(key), pictures.at(key) - 1e-6);
    EXPECT_NEAR(pair.score, 0.5 * pictures.at(key) + 0.5 * best.at(key), 1e-6);
  }
}

/// Only pairs that odometry has far apart lose, the more the farther, and the same in all
/// detectors.
TEST(Hierarchies, OdometrySpeaksAgainstPairsFarApart) {
  const std::string odometry = "odometry_weight: 0.05, odometry_reach_m: 12}";
  std::map<std::pair<int, int>, double> lost;
  std::map<std::pair<int, int>, double> pictures;
  for (const LoopCandidate& pair : Drive("gem_flat", true, "{least_frame: 0.95}")) {
    pictures[{pair.later, pair.earlier}] = pair.score;
  }
  for (const LoopCandidate& pair : Drive("gem_flat", true, "{least_frame: 0.95, " + odometry)) {
    const double less = pictures.at({pair.later, pair.earlier}) - pair.score;
    lost[{pair.later, pair.earlier}] = less;
    // Places are 5 m apart.
    const int apart = std::abs(pair.later % kPlaces - pair.earlier % kPlaces);
    EXPECT_EQ(less > 0.0, apart > 2) << pair.later << " " << pair.earlier;
  }
  const std::string alike = "{least_sequence: -1, sequence_weight: 0, window_weight: 0";
  for (const LoopCandidate& pair : Drive("hut", true, alike + ", " + odometry)) {
    const std::pair<int, int> key = {pair.later, pair.earlier};
    EXPECT_NEAR(pair.score, pictures.at(key) - lost.at(key), 1e-12);
  }
}

TEST(ProposeBest, TakesAtMostThreeLoopsAFrameThatAreApart) {
  std::map<int, std::vector<int>> proposed;
  for (const LoopCandidate& pair : Drive("gem_flat", true, "{least_frame: -1}")) {
    if (pair.is_proposed) proposed[pair.later].push_back(pair.earlier);
  }
  std::size_t most = 0;
  for (const auto& [later, earlier] : proposed) {
    most = std::max(most, earlier.size());
    for (std::size_t i = 1; i < earlier.size(); ++i) {
      EXPECT_GE(earlier[i] - earlier[i - 1], 20) << later;
    }
  }
  EXPECT_EQ(most, 3u);
}

/// Pairs that are named lie in one sequence or in two that the trace tells to be joined.
TEST(Hierarchies, TheirTracesTellWhatIsCompared) {
  for (const char* name : {"hut", "hut_fixed5", "words_hierarchy"}) {
    const auto detector = Make(name, "");
    const auto pairs = DriveWith(detector.get(), true);
    const SequenceTrace trace = detector->Trace();
    std::vector<int> sequence_of;
    for (std::size_t i = 0; i < trace.sequences.size(); ++i) {
      EXPECT_EQ(trace.sequences[i].first, static_cast<int>(sequence_of.size())) << name;
      sequence_of.resize(static_cast<std::size_t>(trace.sequences[i].last) + 1,
                         static_cast<int>(i));
    }
    ASSERT_EQ(sequence_of.size(), 2u * kPlaces) << name;
    EXPECT_FALSE(trace.tried.empty()) << name;
    std::set<std::pair<int, int>> named;
    for (const LoopCandidate& pair : pairs) {
      const std::pair<int, int> of = {sequence_of[static_cast<std::size_t>(pair.later)],
                                      sequence_of[static_cast<std::size_t>(pair.earlier)]};
      if (of.first != of.second) named.insert(of);
    }
    const std::set<std::pair<int, int>> joined(trace.joined.begin(), trace.joined.end());
    EXPECT_FALSE(named.empty()) << name;
    EXPECT_TRUE(std::includes(joined.begin(), joined.end(), named.begin(), named.end())) << name;
  }
}

/// What it names: the short list of sequences most alike, as gem_mean has them, with the scores
/// that gem_cat gives.
TEST(SeqNetEven, OrdersTheSequencesMostAlikeByTheirPictures) {
  constexpr int kShortlist = 3;
  std::map<std::pair<int, int>, double> ordered;
  for (const LoopCandidate& pair : Drive("gem_cat", true)) {
    ordered[{pair.later, pair.earlier}] = pair.score;
  }
  std::map<int, std::vector<LoopCandidate>> alike;
  for (const LoopCandidate& pair : Drive("gem_mean", true)) alike[pair.later].push_back(pair);
  std::map<int, std::vector<int>> named;
  for (const LoopCandidate& pair : Drive("seqnet_even", true, "{shortlist: 3}")) {
    EXPECT_EQ(pair.score, ordered.at({pair.later, pair.earlier}));
    named[pair.later].push_back(pair.earlier);
  }
  for (auto& [later, pairs] : alike) {
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
      return a.score > b.score;
    });
    std::vector<int> most;
    for (std::size_t i = 0; i < pairs.size() && i < kShortlist; ++i) {
      most.push_back(pairs[i].earlier);
    }
    EXPECT_THAT(named[later], ::testing::UnorderedElementsAreArray(most)) << later;
  }
}

/// Weighing all pictures alike it is seqnet_even; else the filter chooses other sequences.
TEST(SeqNet, AsksItsFilterWhichSequencesAreAlike) {
  const std::string few = "{shortlist: 3}";
  const auto even = Drive("seqnet_even", true, few);
  const auto same = Drive("seqnet", true, few);
  ASSERT_EQ(same.size(), even.size());
  for (std::size_t i = 0; i < same.size(); ++i) {
    EXPECT_EQ(same[i].earlier, even[i].earlier);
    EXPECT_EQ(same[i].score, even[i].score);
  }
  const auto last = std::make_shared<WeighedPictures>(std::vector{0, 0, 0, 0, 1});
  const auto others = DriveWith(Make("seqnet", few, last).get(), true);
  EXPECT_NE(std::count_if(others.begin(), others.end(),
                          [&](const LoopCandidate& pair) {
                            return std::none_of(even.begin(), even.end(), [&](const auto& other) {
                              return other.later == pair.later && other.earlier == pair.earlier;
                            });
                          }),
            0);
}

TEST(SeqNet, AFilterThatIsMissingOrOfOtherDescriptorsIsToldOf) {
  EXPECT_THAT(
      [] {
        Make("seqnet", "", nullptr);
      },
      ThrowsMessage<sim::Error>(AllOf(HasSubstr("'filter'"), HasSubstr("seqnet_even"))));
  EXPECT_THAT(
      [] {
        ConfigureLoopDetector(sim::ParseYaml("seqnet", "test"), std::nullopt)(
            {nullptr, 32, nullptr, std::make_shared<WeighedPictures>(std::vector{1}), nullptr});
      },
      ThrowsMessage<sim::Error>(HasSubstr("64 numbers, and 'descriptors' have 32")));
}

TEST(LoopRegistry, DetectorsThatNeedAVocabularySaySo) {
  for (const char* name : {"bow", "orbslam_like", "words_hierarchy"}) {
    const auto make = ConfigureLoopDetector(sim::ParseYaml(name, "c.yaml"), std::nullopt);
    EXPECT_THAT(
        [&] {
          make({});
        },
        ThrowsMessage<sim::Error>(HasSubstr("needs a vocabulary")));
  }
}

}  // namespace
}  // namespace bulletnav::agent
