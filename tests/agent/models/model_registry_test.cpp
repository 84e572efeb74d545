// SPDX-License-Identifier: MIT
#include "agent/models/model_registry.h"

#include <gmock/gmock.h>

#include "agent/models/model_slot.h"
#include "agent/models/safetensors.h"
#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A model that knows one number, kept in its file.
class Number : public virtual Model {
 public:
  static constexpr std::string_view kWhat = "number";
  explicit Number(float value) : value_(value) {}
  float value() const { return value_; }

 private:
  float value_;
};

class Word : public virtual Model {
 public:
  static constexpr std::string_view kWhat = "word";
};

std::shared_ptr<Model> LoadNumber(const std::filesystem::path& weights, const Rig& rig) {
  if (!rig.has_depth) throw sim::Error("a number takes depth");
  return std::make_shared<Number>(ReadTensorFile(weights).tensors.at("value").values.at(0));
}

const ModelRegistration registration("number", LoadNumber);

class ModelRegistryTest : public testing::Test {
 protected:
  std::filesystem::path Write(std::map<std::string, std::string> metadata) const {
    TensorFile content;
    content.tensors["value"] = {{1}, {2.5f}};
    content.metadata = std::move(metadata);
    const std::filesystem::path file = folder_.path() / "a.safetensors";
    WriteTensorFile(file, content);
    return file;
  }
  template <class Call>
  static std::string Complaint(const Call& call) {
    try {
      call();
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "none";
  }

 private:
  tests::TemporaryFolder folder_;
};

TEST_F(ModelRegistryTest, AFileTellsWhichKindOfModelItHolds) {
  const auto model = LoadModel(Write({{"number", "{}"}}), {});
  const auto number = std::dynamic_pointer_cast<Number>(model);
  ASSERT_NE(number, nullptr);
  EXPECT_EQ(number->value(), 2.5f);
}

TEST_F(ModelRegistryTest, AnUnknownKindIsRefusedOnceMoreKindsWereAskedFor) {
  const auto file = Write({{"verse", "{}"}});
  int asked = 0;
  SetMoreModelKinds([&] {
    ++asked;
  });
  for (int i = 0; i < 2; ++i) {
    EXPECT_THAT(Complaint([&] {
                  LoadModel(file, {});
                }),
                AllOf(HasSubstr("a.safetensors"), HasSubstr("(number)")));
  }
  EXPECT_EQ(asked, 1);
}

TEST_F(ModelRegistryTest, KindsThatComeLaterAreFound) {
  const auto file = Write({{"later", "{}"}});
  SetMoreModelKinds([] {
    internal::RegisterModel("later", NumberForm::kTrained, LoadNumber);
  });
  EXPECT_NE(LoadModel(file, {}), nullptr);
}

TEST_F(ModelRegistryTest, WhatAModelNeedsIsItsLoadersWord) {
  const auto file = Write({{"number", "{}"}});
  Rig blind;
  blind.has_depth = false;
  EXPECT_THAT(Complaint([&] {
                LoadModel(file, blind);
              }),
              HasSubstr("takes depth"));
}

TEST_F(ModelRegistryTest, FramesAreReadNotReckonedButInOldFiles) {
  EXPECT_EQ(FramesTrained(Write({{"frames", "1234567890123"}})), 1234567890123);
  EXPECT_EQ(FramesTrained(Write({{"step", "10"}, {"training", "scenes: 4\npanoramas: 16\n"}})),
            640);
  EXPECT_EQ(FramesTrained(Write({{"step", "10"}})), std::nullopt);
  EXPECT_THAT(Complaint([&] {
                FramesTrained(Write({{"frames", "many"}}));
              }),
              HasSubstr("is no number"));
}

TEST(Models, AreFoundByWhatTheyCanBeAsked) {
  Models models;
  models.Set("count", std::make_shared<Number>(3.0f));
  EXPECT_EQ(models.Need<Number>("count")->value(), 3.0f);
  EXPECT_EQ(models.Find<Word>("count"), nullptr);
  EXPECT_EQ(models.Find<Number>("other"), nullptr);
  EXPECT_THROW(models.Need<Word>("count"), sim::Error);
  const ModelSlot slot = OptionalSlot<Number>("count", "counted");
  EXPECT_FALSE(slot.is_needed);
  EXPECT_EQ(slot.interface, "number");
  EXPECT_TRUE(slot.accepts(Number(1.0f)));
  EXPECT_FALSE(slot.accepts(Word()));
}

}  // namespace
}  // namespace bulletnav::agent
