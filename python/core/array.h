// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "sim/sensors/array.h"

namespace bulletnav::python {

/// What an array is made of. kBool: bytes that are 0 or 1.
enum class Dtype { kBool, kUint8, kInt32, kFloat32, kFloat64 };

Dtype DtypeOf(sim::Element element);

/// Numbers in memory of ours, row by row without gaps, that Python looks into without a copy: by
/// the buffer protocol and by DLPack. `owner` keeps the memory alive for as long as anybody looks.
struct Array {
  std::shared_ptr<const void> owner;
  std::byte* data = nullptr;
  std::vector<pybind11::ssize_t> shape;
  Dtype type = Dtype::kUint8;
  std::string name;
  std::string units;  // "m"; empty where there are none
};

/// An array of its own memory, all zero.
Array MakeArray(const sim::ArraySpec& spec);

/// Adds the class Array.
void BindArray(pybind11::module_* module);

}  // namespace bulletnav::python
