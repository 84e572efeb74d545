// SPDX-License-Identifier: MIT
#include "agent/models/safetensors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::agent {
namespace {

using Json = nlohmann::json;
using Bytes = std::span<const std::uint8_t>;

static_assert(std::endian::native == std::endian::little, "the format is little-endian");

constexpr const char* kMetadata = "__metadata__";
constexpr const char* kChecksum = "checksum";
constexpr const char* kRemedy = "; fetch or train it again";
constexpr std::size_t kLongestHeader = 100'000'000;  // bytes, as other readers of the format

std::uint16_t ToBfloat16(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  if (std::isnan(value)) return static_cast<std::uint16_t>((bits >> 16) | 0x40u);
  return static_cast<std::uint16_t>((bits + 0x7fffu + ((bits >> 16) & 1u)) >> 16);
}

float FromBfloat16(std::uint16_t half) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(half) << 16);
}

/// Over the header as it is without its checksum, and the numbers.
std::string Checksum(Json header, Bytes data) {
  header[kMetadata].erase(kChecksum);
  const std::string text = header.dump();
  uLong crc = crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
  crc = crc32_z(crc, data.data(), data.size());
  return "crc32:" + std::to_string(crc);
}

void Append(const std::vector<float>& values, StoredType type, std::vector<std::uint8_t>* data) {
  const std::size_t begin = data->size();
  if (type == StoredType::kFloat32) {
    data->resize(begin + 4 * values.size());
    if (!values.empty()) std::memcpy(data->data() + begin, values.data(), 4 * values.size());
    return;
  }
  data->resize(begin + 2 * values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::uint16_t half = ToBfloat16(values[i]);
    std::memcpy(data->data() + begin + 2 * i, &half, 2);
  }
}

/// Values of a shape; none if it is not one or has more than any memory.
std::optional<std::size_t> CountOf(const std::vector<std::int64_t>& shape) {
  std::size_t count = 1;
  for (const std::int64_t n : shape) {
    if (n < 0 || n > (std::int64_t{1} << 40)) return std::nullopt;
    count *= static_cast<std::size_t>(n);
    if (count > (std::size_t{1} << 40)) return std::nullopt;
  }
  return count;
}

/// A file's parts, and how to complain about them.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), bytes_(sim::ReadFile(file)) {
    std::uint64_t length = 0;
    if (bytes_.size() < sizeof(length)) Fail("", "is cut short");
    std::memcpy(&length, bytes_.data(), sizeof(length));
    if (length > kLongestHeader) Fail("", "is not a safetensors file");
    if (length > bytes_.size() - sizeof(length)) Fail("", "is cut short");
    const Bytes rest = Bytes(bytes_).subspan(sizeof(length));
    header_ = Json::parse(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(length), nullptr,
                          false);
    if (!header_.is_object()) Fail("", "is not a safetensors file");
    data_ = rest.subspan(length);
  }

  TensorFile Read() {
    TensorFile content;
    content.metadata = Metadata();
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    for (const auto& [name, entry] : header_.items()) {
      if (name != kMetadata) content.tensors[name] = ReadTensor(name, entry, &ranges);
    }
    std::sort(ranges.begin(), ranges.end());
    std::size_t end = 0;
    for (const auto& [begin, next] : ranges) {
      if (begin != end) Fail("", "has numbers that belong to no tensor or to two");
      end = next;
    }
    if (end != data_.size()) Fail("", "has another length than its header says");
    return content;
  }

 private:
  [[noreturn]] void Fail(const std::string& place, const std::string& what) const {
    throw sim::FileError(file_, place, what + kRemedy);
  }

  std::map<std::string, std::string> Metadata() const {
    std::map<std::string, std::string> words;
    const auto found = header_.find(kMetadata);
    if (found == header_.end() || !found->is_object() || !found->contains(kChecksum)) {
      Fail("", "has no checksum: it is not a file of this program");
    }
    for (const auto& [key, value] : found->items()) {
      if (!value.is_string()) Fail(kMetadata, "has a value that is not text");
      words[key] = value.get<std::string>();
    }
    if (words[kChecksum] != Checksum(header_, data_)) {
      Fail("", "does not agree with its checksum: it is damaged");
    }
    words.erase(kChecksum);
    return words;
  }

  TensorFile::Tensor ReadTensor(const std::string& name, const Json& entry,
                                std::vector<std::pair<std::size_t, std::size_t>>* ranges) const {
    TensorFile::Tensor tensor;
    std::string type;
    std::array<std::size_t, 2> range{};
    try {
      type = entry.at("dtype").get<std::string>();
      tensor.shape = entry.at("shape").get<std::vector<std::int64_t>>();
      range = entry.at("data_offsets").get<std::array<std::size_t, 2>>();
    } catch (const Json::exception&) {
      Fail(name, "is not described as a tensor is");
    }
    if (type != "F32" && type != "BF16") Fail(name, "is of type " + type + ", not F32 or BF16");
    const std::size_t size = type == "F32" ? 4 : 2;
    const std::optional<std::size_t> count = CountOf(tensor.shape);
    if (!count || range[0] > range[1] || range[1] > data_.size() ||
        range[1] - range[0] != size * *count) {
      Fail(name, "does not have the numbers that its shape asks for");
    }
    tensor.values = Values(data_.subspan(range[0], range[1] - range[0]), size);
    if (*count > 0) ranges->emplace_back(range[0], range[1]);
    return tensor;
  }

  static std::vector<float> Values(Bytes bytes, std::size_t size) {
    std::vector<float> values(bytes.size() / size);
    if (size == 4 && !values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    for (std::size_t i = 0; size == 2 && i < values.size(); ++i) {
      std::uint16_t half = 0;
      std::memcpy(&half, bytes.data() + 2 * i, 2);
      values[i] = FromBfloat16(half);
    }
    return values;
  }

  std::filesystem::path file_;
  std::vector<std::uint8_t> bytes_;
  Json header_;
  Bytes data_;
};

}  // namespace

void WriteTensorFile(const std::filesystem::path& file, const TensorFile& content,
                     StoredType type) {
  Json header = Json::object();
  header[kMetadata] = content.metadata;
  std::vector<std::uint8_t> data;
  for (const auto& [name, tensor] : content.tensors) {
    BULLETNAV_CHECK_EQ(CountOf(tensor.shape).value(), tensor.values.size());
    const std::size_t begin = data.size();
    Append(tensor.values, type, &data);
    header[name] = {{"dtype", type == StoredType::kFloat32 ? "F32" : "BF16"},
                    {"shape", tensor.shape},
                    {"data_offsets", {begin, data.size()}}};
  }
  header[kMetadata][kChecksum] = Checksum(header, data);
  std::string text = header.dump();
  text.resize((text.size() + 7) / 8 * 8, ' ');  // numbers begin at a multiple of eight
  const std::uint64_t length = text.size();
  std::vector<std::uint8_t> bytes(sizeof(length) + text.size() + data.size());
  std::memcpy(bytes.data(), &length, sizeof(length));
  std::memcpy(bytes.data() + sizeof(length), text.data(), text.size());
  if (!data.empty()) {
    std::memcpy(bytes.data() + sizeof(length) + text.size(), data.data(), data.size());
  }
  sim::WriteFileAtomically(file, bytes);
}

TensorFile ReadTensorFile(const std::filesystem::path& file) {
  return Reader(file).Read();
}

}  // namespace bulletnav::agent
