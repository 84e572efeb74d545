// SPDX-License-Identifier: MIT
#include "agent/models/safetensors.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;

TensorFile Sample() {
  TensorFile content;
  content.metadata = {{"model", "width: 16\n"}, {"note", "a \"quoted\" word"}};
  content.tensors["b.weight"] = {{2, 3}, {1.0f, -2.5f, 3.25f, 0.0f, 1e-30f, 7.0f}};
  content.tensors["a.scalar"] = {{}, {42.0f}};
  content.tensors["c.empty"] = {{0, 4}, {}};
  return content;
}

/// The message of the FileError that reading these bytes gives.
std::string Complaint(const std::string& bytes) {
  const tests::TemporaryFolder folder;
  const auto file = folder.Write("x.safetensors", bytes);
  try {
    ReadTensorFile(file);
  } catch (const sim::FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("x.safetensors"));
    EXPECT_THAT(e.what(), HasSubstr("; fetch or train it again"));
    return e.what();
  }
  return "no complaint";
}

std::string Written(const TensorFile& content) {
  const tests::TemporaryFolder folder;
  WriteTensorFile(folder.path() / "w", content);
  return sim::ReadTextFile(folder.path() / "w");
}

std::string WithHeader(const std::string& header, const std::string& data) {
  std::string bytes(8, '\0');
  const std::uint64_t length = header.size();
  std::memcpy(bytes.data(), &length, 8);
  return bytes + header + data;
}

TEST(Safetensors, ComesBackAsItWas) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "new" / "model.safetensors";
  WriteTensorFile(file, Sample());
  const TensorFile read = ReadTensorFile(file);
  EXPECT_EQ(read.tensors, Sample().tensors);
  EXPECT_EQ(read.metadata, Sample().metadata);
}

TEST(Safetensors, HasTheDocumentedLayout) {
  const std::string bytes = Written(Sample());
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data(), 8);
  EXPECT_EQ(length % 8, 0u);
  EXPECT_EQ(bytes[8], '{');
  EXPECT_EQ(bytes.size(), 8 + length + 7 * 4);
  EXPECT_THAT(bytes, HasSubstr(R"("a.scalar":{"data_offsets":[0,4],"dtype":"F32","shape":[]})"));
  float scalar = 0.0f;
  std::memcpy(&scalar, bytes.data() + 8 + length, 4);
  EXPECT_EQ(scalar, 42.0f);
}

TEST(Safetensors, Bfloat16RoundsToTheNearestAndHalvesTheNumbers) {
  const tests::TemporaryFolder folder;
  TensorFile content;
  const float infinity = std::numeric_limits<float>::infinity();
  content.tensors["x"] = {{6}, {1.0f, 3.14159265f, -1e20f, 1.00390625f, infinity, std::nanf("")}};
  WriteTensorFile(folder.path() / "w", content, StoredType::kBfloat16);
  const std::vector<float> read = ReadTensorFile(folder.path() / "w").tensors["x"].values;
  EXPECT_EQ(read[0], 1.0f);
  EXPECT_EQ(read[1], 3.140625f);
  EXPECT_NEAR(read[2], -1e20f, 1e20f / 256);
  EXPECT_EQ(read[3], 1.0f);  // half way: the even one
  EXPECT_EQ(read[4], infinity);
  EXPECT_TRUE(std::isnan(read[5]));
}

TEST(Safetensors, KeepsIntegersOfATypeOfTheirOwn) {
  const tests::TemporaryFolder folder;
  TensorFile content;
  content.tensors["byte"] = {{4}, {-128.0f, -1.0f, 0.0f, 127.0f}, StoredType::kInt8};
  content.tensors["exact"] = {{1}, {0.1f}, StoredType::kFloat32};
  content.tensors["half"] = {{1}, {0.1f}};
  content.tensors["short"] = {{2, 1}, {-32768.0f, 32767.0f}, StoredType::kInt16};
  WriteTensorFile(folder.path() / "w", content, StoredType::kBfloat16);
  const TensorFile read = ReadTensorFile(folder.path() / "w");
  EXPECT_EQ(read.tensors.at("byte"), content.tensors["byte"]);
  EXPECT_EQ(read.tensors.at("short"), content.tensors["short"]);
  EXPECT_EQ(read.tensors.at("exact").values.front(), 0.1f);
  EXPECT_FALSE(read.tensors.at("exact").stored_as.has_value());
  EXPECT_NE(read.tensors.at("half").values.front(), 0.1f);
}

TEST(SafetensorsDeathTest, RefusesIntegersThatDoNotFit) {
  const tests::TemporaryFolder folder;
  TensorFile content;
  content.tensors["x"] = {{1}, {128.0f}, StoredType::kInt8};
  EXPECT_DEATH(WriteTensorFile(folder.path() / "w", content), "");
  content.tensors["x"] = {{1}, {0.5f}, StoredType::kInt16};
  EXPECT_DEATH(WriteTensorFile(folder.path() / "w", content), "");
}

TEST(Safetensors, RefusesWhatIsCutShortAnywhere) {
  const std::string bytes = Written(Sample());
  for (std::size_t n = 0; n < bytes.size(); n += 7) {
    EXPECT_NE(Complaint(bytes.substr(0, n)), "no complaint") << n;
  }
  EXPECT_NE(Complaint(bytes + "more"), "no complaint");
}

TEST(Safetensors, RefusesAnyChangedByte) {
  const std::string bytes = Written(Sample());
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    if (bytes[i] == ' ') continue;  // padding of the header
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_NE(Complaint(changed), "no complaint") << i;
  }
}

TEST(Safetensors, SaysWhatIsWrong) {
  EXPECT_THAT(Complaint(""), HasSubstr("cut short"));
  EXPECT_THAT(Complaint(std::string(8, '\xff') + "{}"), HasSubstr("not a safetensors file"));
  EXPECT_THAT(Complaint(WithHeader("no json", "")), HasSubstr("not a safetensors file"));
  EXPECT_THAT(Complaint(WithHeader("[]", "")), HasSubstr("not a safetensors file"));
  EXPECT_THAT(Complaint(WithHeader("{}", "")), HasSubstr("no checksum"));
  EXPECT_THAT(Complaint(WithHeader(R"({"__metadata__":{"checksum":"crc32:1"}})", "")),
              HasSubstr("damaged"));
  std::string changed = Written(Sample());
  changed.back() = static_cast<char>(changed.back() ^ 1);
  EXPECT_THAT(Complaint(changed), HasSubstr("damaged"));
  EXPECT_THROW(ReadTensorFile("/nowhere/x.safetensors"), sim::FileError);
}

}  // namespace
}  // namespace bulletnav::agent
