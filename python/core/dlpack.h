// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace bulletnav::python {

/// The part of DLPack's C interface (version 0) that CPU tensors need. Its layout is fixed by the
/// Python array API standard: a capsule of this name holds a DlManagedTensor; who takes it renames
/// the capsule and calls `deleter` in the end.
inline constexpr const char* kDlCapsule = "dltensor";
inline constexpr std::int32_t kDlCpu = 1;
inline constexpr std::uint8_t kDlInt = 0;
inline constexpr std::uint8_t kDlUint = 1;
inline constexpr std::uint8_t kDlFloat = 2;
inline constexpr std::uint8_t kDlBool = 6;

struct DlDevice {
  std::int32_t type;
  std::int32_t number;
};

struct DlDataType {
  std::uint8_t code;
  std::uint8_t bits;
  std::uint16_t lanes;
};

struct DlTensor {
  void* data;
  DlDevice device;
  std::int32_t dimensions;
  DlDataType type;
  std::int64_t* shape;
  std::int64_t* strides;  // in elements; null: no gaps
  std::uint64_t byte_offset;
};

struct DlManagedTensor {
  DlTensor tensor;
  void* context;
  void (*deleter)(DlManagedTensor* self);
};

}  // namespace bulletnav::python
