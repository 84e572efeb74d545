// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

namespace bulletnav::bench {

/// Panoramas of one scene, 128 x 512, and the labels of all their ordered pairs: source a, goal b
/// is entry a * count + b. Labels as in Neural Topological SLAM, appendix B; directions count
/// counter-clockwise from straight ahead, as agent::kDirections says.
struct PairBatch {
  int count = 0;
  std::vector<std::uint8_t> color;       // [count, 128, 512, 3]
  std::vector<float> depth;              // [count, 128, 512] metres, 0 = no return; or empty
  std::vector<std::uint8_t> explorable;  // [count, 12] 0 or 1
  std::vector<std::uint8_t> same_node;   // [count, count] 0 or 1
  std::vector<std::int8_t> direction;    // [count, count] of pairs of one node; -1 = no label
  std::vector<float> distance_score;     // [count, count] 1 - d / 3 m of pairs of one node
  std::vector<float> scores;             // [count, count, 12] of other pairs; < 0 = no label

  /// Ends the program unless the sizes agree.
  void Check() const;
};

/// Where a training takes its batches from.
class BatchSource {
 public:
  BatchSource() = default;
  virtual ~BatchSource() = default;
  BatchSource(const BatchSource&) = delete;
  BatchSource& operator=(const BatchSource&) = delete;
  BatchSource(BatchSource&&) = delete;
  BatchSource& operator=(BatchSource&&) = delete;

  /// The same for the same number, whatever was asked before: so a training can be resumed. All
  /// batches of a source have the same count. May be called from several threads.
  virtual PairBatch Batch(std::uint64_t number) const = 0;
};

/// Turns panorama `index` as if its camera had turned counter-clockwise by `twelfths` of a circle:
/// columns roll by the nearest whole number, labels by so many directions.
void TurnPanorama(int index, int twelfths, PairBatch* batch);

}  // namespace bulletnav::bench
