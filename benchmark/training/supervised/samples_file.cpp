// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/samples_file.h"

#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <type_traits>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

static_assert(std::endian::native == std::endian::little);

using sim::FileError;

constexpr std::array<char, 8> kMagic = {'B', 'N', 'L', 'A', 'B', 'E', 'L', 'S'};
constexpr std::uint32_t kVersion = 1;

struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t points = 0;
  std::uint64_t key = 0;
  std::uint64_t checksum = 0;  // of what follows
};
static_assert(sizeof(Header) == 32);

using PoseRow = std::array<double, 4>;

constexpr std::size_t BodySize(std::size_t n) {
  return n * (sizeof(PoseRow) + sizeof(std::uint16_t) + sizeof(SceneSamples::Reach)) +
         n * n * sizeof(PairLabel);
}

template <class T>
void Append(const std::vector<T>& items, std::vector<std::uint8_t>* bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto* from = reinterpret_cast<const std::uint8_t*>(items.data());
  bytes->insert(bytes->end(), from, from + items.size() * sizeof(T));
}

/// Cuts `count` items off the front of the bytes, which are enough.
template <class T>
std::vector<T> Take(std::size_t count, std::span<const std::uint8_t>* bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  BULLETNAV_CHECK_LE(count * sizeof(T), bytes->size());
  std::vector<T> items(count);
  if (count > 0) std::memcpy(items.data(), bytes->data(), count * sizeof(T));
  *bytes = bytes->subspan(count * sizeof(T));
  return items;
}

/// Why bytes are no samples of this key; empty if they are.
std::string ProblemOf(std::span<const std::uint8_t> bytes, std::uint64_t key) {
  Header header;
  if (bytes.size() < sizeof(header)) return "ends early";
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (header.magic != kMagic) return "is no file of labels";
  if (header.version != kVersion) return "is of another version of the program";
  if (header.key != key) return "was made from another scene or config";
  const auto body = bytes.subspan(sizeof(header));
  if (body.size() != BodySize(header.points)) return "has not the size that it should have";
  if (sim::Hash64(body) != header.checksum) return "is damaged: its checksum does not fit";
  return {};
}

}  // namespace

void WriteSamples(const std::filesystem::path& file, const SceneSamples& samples,
                  std::uint64_t key) {
  std::vector<PoseRow> rows;
  for (const sim::BodyPose& pose : samples.poses) {
    rows.push_back({pose.position.x(), pose.position.y(), pose.position.z(), pose.yaw});
  }
  std::vector<std::uint8_t> bytes(sizeof(Header));
  Append(rows, &bytes);
  Append(samples.explorable, &bytes);
  Append(samples.reach, &bytes);
  Append(samples.pairs, &bytes);
  BULLETNAV_CHECK_EQ(bytes.size(), sizeof(Header) + BodySize(samples.poses.size()));
  Header header;
  header.points = static_cast<std::uint32_t>(samples.count());
  header.key = key;
  header.checksum = sim::Hash64(std::span<const std::uint8_t>(bytes).subspan(sizeof(Header)));
  std::memcpy(bytes.data(), &header, sizeof(header));
  sim::WriteFileAtomically(file, bytes);
}

SceneSamples ReadSamples(const std::filesystem::path& file, std::uint64_t key) {
  const std::vector<std::uint8_t> bytes = sim::ReadFile(file);
  if (const std::string problem = ProblemOf(bytes, key); !problem.empty()) {
    throw FileError(file, "", problem);
  }
  Header header;
  std::memcpy(&header, bytes.data(), sizeof(header));
  const std::size_t n = header.points;
  std::span<const std::uint8_t> left = std::span<const std::uint8_t>(bytes).subspan(sizeof(header));
  SceneSamples samples;
  for (const PoseRow& row : Take<PoseRow>(n, &left)) {
    samples.poses.push_back({Eigen::Vector3d(row[0], row[1], row[2]), row[3]});
  }
  samples.explorable = Take<std::uint16_t>(n, &left);
  samples.reach = Take<SceneSamples::Reach>(n, &left);
  samples.pairs = Take<PairLabel>(n * n, &left);
  return samples;
}

}  // namespace bulletnav::bench
