// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/seqvlad_net.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "agent/integer/quantised_file.h"
#include "agent/models/safetensors.h"
#include "agent/perception/layers.h"
#include "agent/perception/weights.h"
#include "agent/slam/descriptors/seqvlad.h"
#include "agent/slam/topology/clusters.h"
#include "sim/base/elementary.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

constexpr double kLeastLength = 1e-6;
/// How much more of a cell its nearest cluster gets than the next one, on the mean. Source:
/// NetVLAD's released code.
constexpr double kNearestShare = 100.0;
constexpr float kLargestByte = 127.0f;

/// Rows in 8 bits, each with a step of its own.
agent::QuantisedLayer InBytes(const torch::Tensor& rows) {
  agent::QuantisedLayer layer;
  layer.outputs = static_cast<int>(rows.size(0));
  layer.inputs = static_cast<int>(rows.size(1));
  layer.bias.resize(static_cast<std::size_t>(rows.size(0)));
  layer.weights.reserve(static_cast<std::size_t>(rows.numel()));
  for (std::int64_t i = 0; i < rows.size(0); ++i) {
    const torch::Tensor row = rows[i].contiguous();
    const float most = row.abs().max().item<float>();
    const float step = most > 0.0f ? most / kLargestByte : 1.0f;
    layer.scale.push_back(step);
    for (const float value :
         std::span(row.data_ptr<float>(), static_cast<std::size_t>(row.numel()))) {
      layer.weights.push_back(static_cast<std::int16_t>(std::lround(value / step)));
    }
  }
  return layer;
}

}  // namespace

torch::Tensor Directions(const torch::Tensor& x) {
  return x / x.norm(2, {-1}, true).clamp_min(kLeastLength);
}

SeqVladNet::SeqVladNet(const agent::SequenceConfig& config, std::uint64_t seed) : config_(config) {
  sim::Rng rng(seed, "seqvlad_net");
  const std::array<std::int64_t, 2> shape = {config.clusters, config.channels};
  assign_ = register_parameter("assign", agent::NormalTensor(shape, 1.0, &rng));
  centres_ = register_parameter("centres", Directions(agent::NormalTensor(shape, 1.0, &rng)));
}

void SeqVladNet::StartFrom(const Eigen::MatrixXf& cells, sim::Rng* rng) {
  const agent::Clusters clusters = agent::ClusterPoints(cells, config_.clusters, 1, rng);
  const torch::NoGradGuard no_grad;
  for (int k = 0; k < config_.clusters; ++k) {
    for (int i = 0; i < config_.channels; ++i) centres_[k][i] = clusters.centres(k, i);
  }
  // Differences of the squared distances to the nearest and the next middle, on the mean.
  const Eigen::MatrixXf products = cells * clusters.centres.transpose();
  const Eigen::VectorXf lengths = clusters.centres.rowwise().squaredNorm();
  double sum = 0.0;
  for (Eigen::Index row = 0; row < cells.rows(); ++row) {
    std::vector<float> distances;
    for (Eigen::Index k = 0; k < lengths.size(); ++k) {
      distances.push_back(lengths(k) - 2.0f * products(row, k));
    }
    std::partial_sort(distances.begin(), distances.begin() + 2, distances.end());
    sum += double{distances[1]} - distances[0];
  }
  const double mean = std::max(kLeastLength, sum / static_cast<double>(cells.rows()));
  const double alpha = sim::Log(kNearestShare) / mean;
  assign_.copy_(2.0 * alpha * centres_);
}

torch::Tensor SeqVladNet::forward(const torch::Tensor& cells) const {
  const torch::Tensor shares = at::softmax(at::matmul(cells, assign_.t()), 2);
  const torch::Tensor sums = at::matmul(shares.transpose(1, 2), cells);
  const torch::Tensor off = sums - shares.sum(1).unsqueeze(2) * centres_;
  return Directions(Directions(off).flatten(1));
}

torch::Tensor CellDirections(std::span<const std::uint8_t> bytes, int n, int channels) {
  const torch::Tensor whole = torch::empty(
      {n, static_cast<std::int64_t>(bytes.size()) / n / channels, channels}, torch::kUInt8);
  std::copy(bytes.begin(), bytes.end(), whole.data_ptr<std::uint8_t>());
  return Directions(whole.to(torch::kFloat32));
}

MainDirections MainDirectionsOf(const torch::Tensor& rows, int size) {
  const torch::Tensor mean = rows.mean(0);
  const torch::Tensor off = (rows - mean).to(torch::kFloat64);
  const auto [values, vectors] = at::linalg_eigh(at::matmul(off, off.t()));
  torch::Tensor projection = torch::zeros({size, rows.size(1)});
  const std::int64_t count = std::min<std::int64_t>(size, rows.size(0) - 1);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t at = rows.size(0) - 1 - i;  // they rise
    const double length = std::sqrt(std::max(0.0, values[at].item<double>()));
    if (length < kLeastLength) break;
    projection[i].copy_(at::matmul(vectors.select(1, at), off) / length);
  }
  return {mean, projection};
}

void SaveSeqVlad(const SeqVladNet& net, const MainDirections& directions,
                 std::map<std::string, std::string> notes, const std::filesystem::path& file) {
  agent::TensorFile content;
  notes[agent::kSequenceKey] = sim::ToYaml(net.config());
  content.metadata = std::move(notes);
  agent::AppendWeights(net, "", &content);
  content.tensors["mean"] = agent::ToStored(directions.mean);
  agent::QuantisedNet bytes;
  bytes.layers[agent::kProjection] = InBytes(directions.projection);
  agent::SetQuantised(bytes, &content);
  agent::WriteTensorFile(file, content, agent::StoredType::kBfloat16);
}

}  // namespace bulletnav::bench
