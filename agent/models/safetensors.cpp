// SPDX-License-Identifier: MIT
#include "agent/models/safetensors.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
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

struct TypeEntry {
  StoredType type;
  const char* name;
  std::size_t size;  // bytes
};
constexpr std::array<TypeEntry, 4> kTypes = {{{StoredType::kFloat32, "F32", 4},
                                              {StoredType::kBfloat16, "BF16", 2},
                                              {StoredType::kInt8, "I8", 1},
                                              {StoredType::kInt16, "I16", 2}}};

const TypeEntry& EntryOf(StoredType type) {
  return *std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeEntry& entry) {
    return entry.type == type;
  });
}

template <class T>
void Put(T value, std::uint8_t* to) {
  std::memcpy(to, &value, sizeof(value));
}

template <class T>
T Get(const std::uint8_t* from) {
  T value{};
  std::memcpy(&value, from, sizeof(value));
  return value;
}

template <class T>
T ToInteger(float value) {
  BULLETNAV_CHECK(value >= std::numeric_limits<T>::min() && value <= std::numeric_limits<T>::max());
  BULLETNAV_CHECK_EQ(value, std::nearbyint(value));
  return static_cast<T>(value);
}

void PutAs(StoredType type, float value, std::uint8_t* to) {
  switch (type) {
    case StoredType::kFloat32:
      return Put(value, to);
    case StoredType::kBfloat16:
      return Put(ToBfloat16(value), to);
    case StoredType::kInt8:
      return Put(ToInteger<std::int8_t>(value), to);
    case StoredType::kInt16:
      return Put(ToInteger<std::int16_t>(value), to);
  }
}

float GetAs(StoredType type, const std::uint8_t* from) {
  switch (type) {
    case StoredType::kFloat32:
      return Get<float>(from);
    case StoredType::kBfloat16:
      return FromBfloat16(Get<std::uint16_t>(from));
    case StoredType::kInt8:
      return Get<std::int8_t>(from);
    case StoredType::kInt16:
      return Get<std::int16_t>(from);
  }
  return 0.0f;
}

void Append(const std::vector<float>& values, StoredType type, std::vector<std::uint8_t>* data) {
  const std::size_t begin = data->size();
  const std::size_t size = EntryOf(type).size;
  data->resize(begin + size * values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    PutAs(type, values[i], data->data() + begin + size * i);
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
    const auto* entry_of_type =
        std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeEntry& known) {
          return type == known.name;
        });
    if (entry_of_type == kTypes.end()) {
      Fail(name, "is of type " + type + ", not F32, BF16, I8 or I16");
    }
    const std::size_t size = entry_of_type->size;
    const std::optional<std::size_t> count = CountOf(tensor.shape);
    if (!count || range[0] > range[1] || range[1] > data_.size() ||
        range[1] - range[0] != size * *count) {
      Fail(name, "does not have the numbers that its shape asks for");
    }
    tensor.values = Values(data_.subspan(range[0], range[1] - range[0]), *entry_of_type);
    const bool is_whole =
        entry_of_type->type == StoredType::kInt8 || entry_of_type->type == StoredType::kInt16;
    if (is_whole) tensor.stored_as = entry_of_type->type;
    if (*count > 0) ranges->emplace_back(range[0], range[1]);
    return tensor;
  }

  static std::vector<float> Values(Bytes bytes, const TypeEntry& entry) {
    std::vector<float> values(bytes.size() / entry.size);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = GetAs(entry.type, bytes.data() + entry.size * i);
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
    const StoredType stored = tensor.stored_as.value_or(type);
    Append(tensor.values, stored, &data);
    header[name] = {{"dtype", EntryOf(stored).name},
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
