// SPDX-License-Identifier: MIT
#include "sim/config/yaml_writer.h"

#include <limits>

#include <gtest/gtest.h>

#include "sim/math/rng.h"

namespace bulletnav::sim {

enum class Mode { kFast, kSlow };

template <>
struct EnumNames<Mode> {
  static constexpr std::array kNames = {std::pair{"fast", Mode::kFast},
                                        std::pair{"slow", Mode::kSlow}};
};

namespace {

struct Part {
  double width = 0.1;
  std::vector<std::string> words;
  template <class V>
  void Visit(V& v) {
    v.Required("width", width);
    v("words", words);
  }
  bool operator==(const Part&) const = default;
};

struct Whole {
  std::int64_t count = 3;
  std::uint8_t small = 0;
  float single = 0.1F;
  bool flag = false;
  std::string name = "none";
  Mode mode = Mode::kSlow;
  std::vector<Mode> modes;
  std::array<double, 2> pair{};
  std::optional<double> maybe;
  std::map<std::string, Part> parts;
  std::vector<Part> list;
  template <class V>
  void Visit(V& v) {
    v("count", count);
    v("small", small);
    v("single", single);
    v("flag", flag);
    v("name", name);
    v("mode", mode);
    v("modes", modes);
    v("pair", pair);
    v("maybe", maybe);
    v("parts", parts);
    v("list", list);
  }
  bool operator==(const Whole&) const = default;
};

std::string RandomText(Rng* rng) {
  const std::string alphabet = "ab Z09._-/:#,{}[]&*!|>'\"%@`~\\\n\t?=";
  std::string text;
  for (int i = rng->Below(8); i >= 0; --i) text += rng->Pick(alphabet);
  return text;
}

Whole RandomWhole(Rng* rng) {
  Whole whole;
  whole.count = static_cast<std::int64_t>(rng->Next()) * (rng->Chance(0.5) ? -1'000'003 : 1);
  whole.small = static_cast<std::uint8_t>(rng->Below(256));
  whole.single = static_cast<float>(rng->Normal());
  whole.flag = rng->Chance(0.5);
  whole.name = RandomText(rng);
  whole.modes.assign(static_cast<std::size_t>(rng->Below(3)), Mode::kFast);
  whole.pair = {rng->Normal() * 1e-9, rng->Normal() * 1e18};
  if (rng->Chance(0.5)) whole.maybe = rng->Uniform();
  for (int i = rng->Below(3); i > 0; --i) {
    whole.parts["key" + std::to_string(i)] = {rng->Normal(), {RandomText(rng)}};
    whole.list.push_back({rng->Normal(), {RandomText(rng), RandomText(rng)}});
  }
  return whole;
}

TEST(YamlWriter, WhatIsWrittenReadsBackTheSame) {
  Rng rng(1, "yaml");
  for (int i = 0; i < 500; ++i) {
    const Whole whole = RandomWhole(&rng);
    const std::string text = ToYaml(whole);
    EXPECT_EQ(LoadYamlText<Whole>(text, "w.yaml"), whole) << text;
    EXPECT_EQ(ToYaml(LoadYamlText<Whole>(text, "w.yaml")), text);
  }
}

TEST(YamlWriter, WordsThatYamlWouldTakeForOthersStayWords) {
  for (const char* name : {"", "~", "null", "true", "12", "- a", "a: b", "*x", "# no"}) {
    Whole whole;
    whole.name = name;
    EXPECT_EQ(LoadYamlText<Whole>(ToYaml(whole), "w.yaml").name, name);
  }
}

TEST(YamlWriter, ExtremesKeepTheirBits) {
  Whole whole;
  whole.pair = {std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::max()};
  whole.count = std::numeric_limits<std::int64_t>::min();
  whole.single = std::numeric_limits<float>::min();
  EXPECT_EQ(LoadYamlText<Whole>(ToYaml(whole), "w.yaml"), whole);
}

TEST(YamlWriter, TextIsPlain) {
  Whole whole;
  whole.modes = {Mode::kFast, Mode::kSlow};
  whole.list = {{2.5, {"a b"}}};
  EXPECT_EQ(ToYaml(whole),
            "count: 3\nsmall: 0\nsingle: 0.1\nflag: false\nname: none\nmode: slow\n"
            "modes: [fast, slow]\npair: [0, 0]\nparts:\n  {}\nlist:\n  - width: 2.5\n    words:\n"
            "      - a b\n");
}

TEST(YamlWriter, AfterAnEmptyListLinesGoOn) {
  Whole whole;
  whole.list = {{2.5, {"a b"}}};
  EXPECT_EQ(ToYaml(whole),
            "count: 3\nsmall: 0\nsingle: 0.1\nflag: false\nname: none\nmode: slow\n"
            "modes: []\npair: [0, 0]\nparts:\n  {}\nlist:\n  - width: 2.5\n    words:\n"
            "      - a b\n");
}

struct Open {
  std::optional<YamlNode> anything;
  template <class V>
  void Visit(V& v) {
    v("anything", anything);
  }
};

TEST(YamlWriter, NodesForOthersPassThrough) {
  const auto open = LoadYamlText<Open>("anything:\n  b: [1, x]\n  a: 2\n", "o.yaml");
  const std::string text = ToYaml(open);
  EXPECT_EQ(text, "anything:\n  b: [1, x]\n  a: 2\n");
  EXPECT_EQ(ToYaml(LoadYamlText<Open>("{}", "o.yaml")), "{}\n");
}

}  // namespace
}  // namespace bulletnav::sim
