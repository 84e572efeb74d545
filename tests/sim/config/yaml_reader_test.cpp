// SPDX-License-Identifier: MIT
#include "sim/config/yaml_reader.h"

#include <gtest/gtest.h>

#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {

enum class Colour { kRed, kGreen };

template <>
struct EnumNames<Colour> {
  static constexpr std::array kNames = {std::pair{"red", Colour::kRed},
                                        std::pair{"green", Colour::kGreen}};
};

namespace {

struct Inner {
  double width = 1.0;
  double height = 0.0;
  template <class V>
  void Visit(V& v) {
    v.Required("width", width);
    v("height", height);
  }
  void Validate() const {
    if (width < 0.0) throw KeyError("width", "width must not be negative");
    if (height > width) throw Error("height must not exceed width");
  }
};

struct Config {
  int count = 3;
  std::uint8_t small = 0;
  bool flag = false;
  std::string name = "none";
  Colour colour = Colour::kRed;
  std::vector<double> list;
  std::array<int, 2> pair{};
  std::optional<double> maybe;
  std::map<std::string, Inner> inners;
  Inner inner;
  template <class V>
  void Visit(V& v) {
    v("count", count);
    v("small", small);
    v("flag", flag);
    v("name", name);
    v("colour", colour);
    v("list", list);
    v("pair", pair);
    v("maybe", maybe);
    v("inners", inners);
    v("inner", inner);
  }
};

Config Read(const std::string& text) {
  return LoadYamlText<Config>(text, "c.yaml");
}

std::string ErrorOf(const std::string& text) {
  try {
    Read(text);
  } catch (const FileError& e) {
    return e.what();
  }
  return "no error";
}

TEST(YamlReader, ReadsEveryKindOfValue) {
  const Config c = Read(
      "count: -7\nsmall: 255\nflag: true\nname: two words\ncolour: green\nlist: [1, 2.5e3]\n"
      "pair: [4, 5]\nmaybe: 0.5\ninners: {a: {width: 2}, b: {width: 3}}\ninner:\n  width: 9\n");
  EXPECT_EQ(c.count, -7);
  EXPECT_EQ(c.small, 255);
  EXPECT_TRUE(c.flag);
  EXPECT_EQ(c.name, "two words");
  EXPECT_EQ(c.colour, Colour::kGreen);
  EXPECT_EQ(c.list, (std::vector<double>{1.0, 2500.0}));
  EXPECT_EQ(c.pair, (std::array<int, 2>{4, 5}));
  EXPECT_EQ(c.maybe, 0.5);
  EXPECT_EQ(c.inners.at("b").width, 3.0);
  EXPECT_EQ(c.inner.width, 9.0);
}

TEST(YamlReader, WhatIsNotNamedKeepsItsDefault) {
  const Config c = Read("name: x\n");
  EXPECT_EQ(c.count, 3);
  EXPECT_FALSE(c.maybe.has_value());
}

struct BadInput {
  const char* name;
  const char* text;
  const char* error;
};

class BadInputTest : public testing::TestWithParam<BadInput> {};

TEST_P(BadInputTest, IsAnErrorAtItsPlace) {
  EXPECT_EQ(ErrorOf(GetParam().text), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadInputTest,
    testing::Values(
        BadInput{"typo", "name: x\ncuont: 3\n",
                 "c.yaml:2:1: unknown key 'cuont'; did you mean 'count'?"},
        BadInput{"unknown", "zzzzzzzzzz: 3\n",
                 "c.yaml:1:1: unknown key 'zzzzzzzzzz'; known here: count, small, flag, name, "
                 "colour, list, pair, maybe, inners, inner"},
        BadInput{"twice", "count: 3\ncount: 4\n", "c.yaml:2:1: key 'count' is given twice"},
        BadInput{"missing", "inner: {}\n", "c.yaml:1:8: key 'width' is missing"},
        BadInput{"misspelt_required", "inner: {widht: 1}\n",
                 "c.yaml:1:9: unknown key 'widht'; did you mean 'width'?"},
        BadInput{"not_a_number", "count: three\n", "c.yaml:1:8: 'three' is not a whole number"},
        BadInput{"not_whole", "count: 3.5\n", "c.yaml:1:8: '3.5' is not a whole number"},
        BadInput{"too_large", "small: 256\n", "c.yaml:1:8: 256 is outside 0 to 255"},
        BadInput{"not_finite", "list: [.nan]\n", "c.yaml:1:8: '.nan' is not a finite number"},
        BadInput{"not_bool", "flag: yes\n", "c.yaml:1:7: 'yes' is neither true nor false"},
        BadInput{"not_in_enum", "colour: blue\n", "c.yaml:1:9: 'blue' is not one of: red, green"},
        BadInput{"scalar_for_list", "list: 3\n", "c.yaml:1:7: expected a list here"},
        BadInput{"wrong_length", "pair: [1]\n", "c.yaml:1:7: expected a list of 2, got 1"},
        BadInput{"list_for_scalar", "count: [1]\n", "c.yaml:1:8: expected a single value here"},
        BadInput{"list_for_map", "inner: [1]\n",
                 "c.yaml:1:8: expected a block of 'key: value' lines here"},
        BadInput{"invalid", "inner: {width: -1}\n", "c.yaml:1:16: width must not be negative"},
        BadInput{"invalid_as_a_whole", "inner: {width: 5, height: 9}\n",
                 "c.yaml:1:8: height must not exceed width"}),
    [](const auto& bad) {
      return bad.param.name;
    });

TEST(YamlReader, BrokenSyntaxIsAnErrorAtItsPlace) {
  const std::string error = ErrorOf("count: [1, 2\nname: }\n");
  EXPECT_TRUE(error.starts_with("c.yaml:2:")) << error;
  EXPECT_NE(error.find("not valid YAML"), std::string::npos);
}

TEST(YamlReader, FilesAreNamed) {
  const tests::TemporaryFolder folder;
  const auto file = folder.Write("x.yaml", "count: many\n");
  try {
    LoadYaml<Config>(file);
    FAIL();
  } catch (const FileError& e) {
    EXPECT_TRUE(std::string(e.what()).starts_with(file.string() + ":1:8:"));
  }
  EXPECT_THROW(LoadYaml<Config>(folder.path() / "none.yaml"), FileError);
}

/// Broken input must end in an exception of ours, never in a crash: random edits of a good file.
TEST(YamlReader, SurvivesRandomDamage) {
  const std::string good =
      "count: 1\nlist: [1, 2, 3]\ninner: {width: 2}\ninners:\n  a: {width: 1}\npair: [1, 2]\n";
  Rng rng(1, "damage");
  const std::string alphabet = "{}[]:,-&*!|>'\"%@`# \n\t\\?aZ09.\xff";
  for (int i = 0; i < 3000; ++i) {
    std::string text = good;
    for (int k = 0; k <= rng.Below(4); ++k) {
      const auto at = static_cast<std::size_t>(rng.Below(static_cast<int>(text.size())));
      const char c = rng.Pick(alphabet);
      if (rng.Chance(0.4)) text.erase(at, static_cast<std::size_t>(rng.Below(5)));
      text.insert(std::min(at, text.size()), 1, c);
    }
    try {
      Read(text);
    } catch (const FileError&) {
    }
  }
}

TEST(YamlReader, DeepNestingIsRefused) {
  EXPECT_THROW(Read(std::string(100'000, '[')), FileError);
  EXPECT_THROW(Read("list: " + std::string(50'000, '[') + std::string(50'000, ']')), FileError);
}

TEST(NearestWord, FindsTyposAndGivesUpOnStrangers) {
  const std::vector<std::string> known = {"forward", "turn_left", "turn_right"};
  EXPECT_EQ(NearestWord("foward", known), "forward");
  EXPECT_EQ(NearestWord("turnleft", known), "turn_left");
  EXPECT_EQ(NearestWord("qqqqqqqqqqqqqqqqqqq", known), "");
}

}  // namespace
}  // namespace bulletnav::sim
