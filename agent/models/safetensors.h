// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bulletnav::agent {

/// How numbers are stored. kBfloat16 rounds to the nearest, ties to even, and halves the file;
/// kInt8 and kInt16 are for whole numbers of this range.
enum class StoredType { kFloat32, kBfloat16, kInt8, kInt16 };

/// Named arrays of numbers, and words about them.
struct TensorFile {
  struct Tensor {
    std::vector<std::int64_t> shape;
    std::vector<float> values;                 // row-major; as many as the shape says
    std::optional<StoredType> stored_as = {};  // instead of the file's type; set on reading if
                                               // they are integers
    bool operator==(const Tensor&) const = default;
  };
  std::map<std::string, Tensor> tensors;
  std::map<std::string, std::string> metadata;
};

/// Writes a .safetensors file, which holds data and nothing that runs: 8 bytes of the header's
/// length (little-endian), the header in JSON, the numbers. A checksum over header and numbers goes
/// into its metadata under "checksum". Atomic; throws FileError. Expects: sizes that agree with the
/// shapes, and whole numbers in range where integers are stored (checked). Format:
/// huggingface.co/docs/safetensors.
void WriteTensorFile(const std::filesystem::path& file, const TensorFile& content,
                     StoredType type = StoredType::kFloat32);

/// Reads what WriteTensorFile wrote. Throws FileError if it is missing, cut short, damaged, holds
/// other types than F32, BF16, I8 and I16, or has no checksum.
TensorFile ReadTensorFile(const std::filesystem::path& file);

}  // namespace bulletnav::agent
