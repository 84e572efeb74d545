// SPDX-License-Identifier: MIT
#include "agent/perception/weights.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "agent/integer/quantised_file.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

std::string ShapeText(at::IntArrayRef shape) {
  std::ostringstream out;
  out << shape;
  return out.str();
}

std::map<std::string, torch::Tensor> NamedWeights(const torch::nn::Module& net) {
  std::map<std::string, torch::Tensor> weights;
  for (const auto& item : net.named_parameters()) weights[item.key()] = item.value();
  for (const auto& item : net.named_buffers()) weights[item.key()] = item.value();
  return weights;
}

void RequireFinite(const TensorFile::Tensor& tensor, const std::filesystem::path& file,
                   const std::string& name) {
  const auto is_finite = [](float value) {
    return std::isfinite(value);
  };
  if (std::all_of(tensor.values.begin(), tensor.values.end(), is_finite)) return;
  throw sim::FileError(file, name, "holds numbers that are NaN or infinite; train it again");
}

}  // namespace

TensorFile::Tensor ToStored(const torch::Tensor& tensor) {
  const torch::Tensor flat =
      tensor.detach().to(torch::kCPU, torch::kFloat32).contiguous(at::MemoryFormat::Contiguous);
  const float* data = flat.data_ptr<float>();
  return {tensor.sizes().vec(), std::vector<float>(data, data + flat.numel())};
}

torch::Tensor FromStored(const TensorFile::Tensor& stored) {
  torch::Tensor tensor = torch::empty(stored.shape, torch::kFloat32);
  std::copy(stored.values.begin(), stored.values.end(), tensor.data_ptr<float>());
  return tensor;
}

void AppendWeights(const torch::nn::Module& net, const std::string& prefix, TensorFile* content) {
  for (const auto& [name, tensor] : NamedWeights(net)) {
    content->tensors[prefix + name] = ToStored(tensor);
  }
}

void SetWeights(const TensorFile& content, const std::string& prefix,
                const std::filesystem::path& file, torch::nn::Module* net) {
  const torch::NoGradGuard no_grad;
  const std::map<std::string, torch::Tensor> weights = NamedWeights(*net);
  for (const auto& [name, tensor] : weights) {
    const auto found = content.tensors.find(prefix + name);
    if (found == content.tensors.end()) {
      throw sim::FileError(
          file, prefix + name,
          content.metadata.contains(kIntegersAlone)
              ? "was left out: the file holds its network in integers alone, which "
                "acts, but is not trained on"
              : "is missing: these are weights of another model");
    }
    if (at::IntArrayRef(found->second.shape) != tensor.sizes()) {
      throw sim::FileError(file, prefix + name,
                           "has shape " + ShapeText(found->second.shape) + ", but the model has " +
                               ShapeText(tensor.sizes()) + ": these are weights of another model");
    }
    RequireFinite(found->second, file, prefix + name);
    torch::Tensor(tensor).copy_(FromStored(found->second));
  }
  for (const auto& [name, tensor] : content.tensors) {
    if (name.starts_with(kIntegerPrefix)) continue;  // beside the ones they are made from
    if (name.starts_with(prefix) && weights.count(name.substr(prefix.size())) == 0) {
      throw sim::FileError(file, name, "is not in the model: these are weights of another one");
    }
  }
}

void SaveWeights(const torch::nn::Module& net, std::map<std::string, std::string> notes,
                 StoredType type, const std::filesystem::path& file) {
  TensorFile content;
  content.metadata = std::move(notes);
  AppendWeights(net, "", &content);
  WriteTensorFile(file, content, type);
}

}  // namespace bulletnav::agent
