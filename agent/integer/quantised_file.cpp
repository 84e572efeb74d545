// SPDX-License-Identifier: MIT
#include "agent/integer/quantised_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <string_view>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

using Tensor = TensorFile::Tensor;

constexpr std::string_view kWeight = ".weight";
constexpr std::string_view kStep = ".step";
constexpr std::int64_t kLargestSize = 1 << 20;  // of one dimension

StoredType NarrowestFor(const std::vector<std::int16_t>& weights) {
  const bool is_narrow = std::all_of(weights.begin(), weights.end(), [](std::int16_t weight) {
    return weight >= -128 && weight <= 127;
  });
  return is_narrow ? StoredType::kInt8 : StoredType::kInt16;
}

class Reader {
 public:
  Reader(const TensorFile& content, const std::filesystem::path& file)
      : content_(content), file_(file) {}

  QuantisedNet Read() const {
    QuantisedNet net;
    for (const auto& entry : content_.tensors) {
      const std::string& name = entry.first;
      const std::string_view prefix = kIntegerPrefix;
      if (!name.starts_with(prefix)) continue;
      const auto between = [&](std::string_view end) {
        return name.substr(prefix.size(), name.size() - prefix.size() - end.size());
      };
      if (name.ends_with(kStep)) net.scales[between(kStep)] = Floats(name, 1).front();
      if (name.ends_with(kWeight)) {
        const std::string layer = between(kWeight);
        net.layers[layer] = Layer(std::string(prefix) + layer);
      }
    }
    if (net.layers.empty()) {
      throw sim::FileError(file_, "", "holds no network in integers; quantise it first");
    }
    return net;
  }

 private:
  [[noreturn]] void Fail(const std::string& name, const std::string& what) const {
    throw sim::FileError(file_, name, what + "; quantise it again");
  }

  const Tensor& Find(const std::string& name) const {
    const auto found = content_.tensors.find(name);
    if (found == content_.tensors.end()) Fail(name, "is missing");
    return found->second;
  }

  std::vector<float> Floats(const std::string& name, std::int64_t count) const {
    const Tensor& tensor = Find(name);
    if (tensor.shape != std::vector<std::int64_t>{count}) Fail(name, "is not of the size needed");
    const auto is_finite = [](float value) {
      return std::isfinite(value);
    };
    if (!std::all_of(tensor.values.begin(), tensor.values.end(), is_finite)) {
      Fail(name, "holds numbers that are NaN or infinite");
    }
    return tensor.values;
  }

  QuantisedLayer Layer(const std::string& name) const {
    const std::string place = name + std::string(kWeight);
    const Tensor& weights = Find(place);
    const auto& shape = weights.shape;
    const auto is_good = [](std::int64_t size) {
      return size >= 1 && size <= kLargestSize;
    };
    if (!weights.stored_as || shape.size() != 3 ||
        !std::all_of(shape.begin(), shape.end(), is_good)) {
      Fail(place, "is not a layer's weights in integers");
    }
    QuantisedLayer layer;
    layer.outputs = static_cast<int>(shape[0]);
    layer.segments = static_cast<int>(shape[1]);
    layer.inputs = static_cast<int>(shape[2]);
    layer.weights.reserve(weights.values.size());
    for (const float value : weights.values) {
      layer.weights.push_back(static_cast<std::int16_t>(value));
    }
    layer.scale = Floats(name + ".scale", shape[0]);
    layer.bias = Floats(name + ".bias", shape[0]);
    return layer;
  }

  const TensorFile& content_;
  const std::filesystem::path& file_;
};

/// The narrowest type that keeps all numbers of a file as they are.
StoredType TypeOf(const TensorFile& content) {
  const auto is_short = [](float value) {
    return (std::bit_cast<std::uint32_t>(value) & 0xffffu) == 0;
  };
  const bool all_short =
      std::all_of(content.tensors.begin(), content.tensors.end(), [&](const auto& entry) {
        const auto& [name, tensor] = entry;
        return name.starts_with(kIntegerPrefix) ||
               std::all_of(tensor.values.begin(), tensor.values.end(), is_short);
      });
  return all_short ? StoredType::kBfloat16 : StoredType::kFloat32;
}

}  // namespace

void SetQuantised(const QuantisedNet& net, TensorFile* content) {
  std::erase_if(content->tensors, [](const auto& entry) {
    return entry.first.starts_with(kIntegerPrefix);
  });
  const std::string prefix = kIntegerPrefix;
  for (const auto& [name, layer] : net.layers) {
    content->tensors[prefix + name + ".weight"] = {
        {layer.outputs, layer.segments, layer.inputs},
        std::vector<float>(layer.weights.begin(), layer.weights.end()),
        NarrowestFor(layer.weights)};
    content->tensors[prefix + name + ".scale"] = {
        {layer.outputs}, layer.scale, StoredType::kFloat32};
    content->tensors[prefix + name + ".bias"] = {{layer.outputs}, layer.bias, StoredType::kFloat32};
  }
  for (const auto& [name, scale] : net.scales) {
    content->tensors[prefix + name + std::string(kStep)] = {{1}, {scale}, StoredType::kFloat32};
  }
}

void AddQuantised(const QuantisedNet& net, const std::filesystem::path& file,
                  const std::filesystem::path& out, std::span<const std::string> without) {
  TensorFile content = ReadTensorFile(file);
  const StoredType type = TypeOf(content);
  SetQuantised(net, &content);
  for (const std::string& name : without) content.tensors.erase(name);
  content.metadata.erase(kIntegerPart);
  WriteTensorFile(out, content, type);
}

void KeepIntegersAlone(const std::filesystem::path& file, const std::filesystem::path& out) {
  TensorFile content = ReadTensorFile(file);
  if (!HoldsIntegers(content)) {
    throw sim::FileError(file, "", "holds no whole network in integers; quantise it first");
  }
  const StoredType type = TypeOf(content);
  std::erase_if(content.tensors, [](const auto& entry) {
    return !entry.first.starts_with(kIntegerPrefix) && entry.second.shape.size() > 1;
  });
  for (auto& [name, tensor] : content.tensors) {
    // The trained weights may be short; scales are not.
    if (name.starts_with(kIntegerPrefix) && !tensor.stored_as)
      tensor.stored_as = StoredType::kFloat32;
  }
  content.metadata[kIntegersAlone] = "true";
  WriteTensorFile(out, content, type);
}

QuantisedNet ReadQuantised(const TensorFile& content, const std::filesystem::path& file) {
  return Reader(content, file).Read();
}

}  // namespace bulletnav::agent
