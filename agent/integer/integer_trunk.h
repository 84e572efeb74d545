// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agent/integer/dot_layer.h"
#include "agent/integer/pictures.h"
#include "agent/integer/quantised_layer.h"

namespace bulletnav::agent {

/// The convolutions of a trunk in integers. Scales are the real values of one eight-bit step, of
/// `shortcut` of one 16-bit step.
struct QuantisedTrunk {
  struct Block {
    QuantisedLayer first;
    QuantisedLayer second;
    std::optional<QuantisedLayer> shortcut;
    int stride = 1;
    float first_scale = 0.0f;
    float second_scale = 0.0f;
    float shortcut_scale = 0.0f;
    bool operator==(const Block&) const = default;
  };
  int rows = 0;           // of the input
  int cols = 0;           // 0: four times as many
  bool ends_meet = true;  // left and right, as in panoramas; else there are zeros beyond
  float in_scale = 0.0f;  // the input's zero is kInputZero
  QuantisedLayer stem;    // of kInputChannels
  float stem_scale = 0.0f;
  std::vector<Block> blocks;
  bool operator==(const QuantisedTrunk&) const = default;
};

/// From layers and scales named as in Trunk, after `prefix`: "stem", "stage1_1_first", and so on.
/// Throws Error if some are missing.
QuantisedTrunk TrunkOf(const QuantisedNet& net, const std::string& prefix, int rows);
/// Likewise, of flat pictures; the first `halvings` of stages two to four halve rows and columns.
QuantisedTrunk FlatTrunkOf(const QuantisedNet& net, const std::string& prefix, int rows, int cols,
                           int halvings);

inline constexpr int kInputChannels = 4;  // red, green, blue, depth
inline constexpr int kInputZero = 127;    // of 0 to 254
inline constexpr int kStemBorder = 3;

/// Trunk::Stages of pictures. Not for several threads at once. All work is done in
/// the calling thread; the same bits for any number of pictures at a time, on every processor.
class IntegerTrunk {
 public:
  static constexpr int kAtATime = 4;  // pictures

  /// Throws Error if the layers do not fit together.
  explicit IntegerTrunk(const QuantisedTrunk& trunk);

  /// To be filled: [rows, cols, kInputChannels], up to kAtATime of them.
  Pictures* input() { return &input_; }
  /// Runs the first `count` pictures.
  void Run(int count);

  /// What stage i, of four, came to: [count, rows, cols, channels] in fine values of stage_scale.
  const std::vector<std::int16_t>& fine(int stage) const { return ends_.at(IndexOf(stage)).fine; }
  /// The same in bytes.
  const Pictures& bytes(int stage) const { return ends_.at(IndexOf(stage)).out; }
  double stage_scale(int stage) const { return ends_.at(IndexOf(stage)).scale; }

  void Use(const IntegerKernels& kernels);

 private:
  /// A convolution with the memory it writes.
  struct Step {
    DotLayer layer;
    std::vector<std::int32_t> in_offsets;
    std::size_t pixels;  // of a picture
    int segment_stride;
  };
  struct End {
    Pictures out;
    std::vector<std::int16_t> fine;
    double scale;
    std::vector<std::int32_t> byte_offsets;
    std::vector<std::int32_t> fine_offsets;
  };
  struct Block {
    Step first;
    End middle;
    Step second;
    std::optional<Step> shortcut;
    std::vector<std::int16_t> shortcut_fine;
  };
  static std::size_t IndexOf(int stage);
  static Step MakeStep(const QuantisedLayer& layer, const Pictures& in, int stride,
                       const LayerScales& scales);
  static End MakeEnd(const PictureShape& in, int stride, int channels, double scale);
  void AddBlock(const QuantisedTrunk::Block& block);
  void RunStep(Step* step, const Pictures& in, int count, const KeptValues& kept, End* end) const;
  void RunBlock(std::size_t index, int count);

  bool ends_meet_;
  Pictures input_;
  Step stem_;
  End stem_end_;
  std::vector<End> ends_;  // of the pooling, then of the blocks
  std::vector<Block> blocks_;
};

}  // namespace bulletnav::agent
