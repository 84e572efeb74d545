// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>

#include "agent/slam/loops/loop_registry.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Sequences of small grey pictures: each frame's difference to all earlier ones, made to stand out
/// among its neighbours in time, is added up along straight lines through the last frames; the line
/// that differs least, clearly less than any elsewhere, is a loop. It finds the way again that was
/// driven before in the same direction. Source: Milford and Wyeth, "SeqSLAM: visual route-based
/// navigation for sunny summer days and stormy winter nights", ICRA 2012; settings of section IV.
class SeqSlamDetector final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "seqslam";

  struct Config {
    int cols = 64;
    int rows = 32;
    int patch = 8;             // pixels of a side within which brightness is evened out
    int contrast_window = 10;  // frames to each side within which differences are evened out
    int length = 10;           // frames of a sequence
    double least_speed = 0.8;  // of now to that of then
    double most_speed = 1.2;
    double speed_step = 0.1;
    int elsewhere = 10;        // frames from the best line on which another counts as elsewhere
    double least_score = 1.5;  // mean deviations that a line lies below its neighbours
    double most_ratio = 0.9;   // of the best line's difference to that of the best elsewhere

    template <class V>
    void Visit(V& v) {
      v("cols", cols);
      v("rows", rows);
      v("patch", patch);
      v("contrast_window", contrast_window);
      v("length", length);
      v("least_speed", least_speed);
      v("most_speed", most_speed);
      v("speed_step", speed_step);
      v("elsewhere", elsewhere);
      v("least_score", least_score);
      v("most_ratio", most_ratio);
    }
    void Validate() const {
      if (patch < 1 || cols < patch || rows < patch || cols % patch != 0 || rows % patch != 0) {
        throw sim::Error("cols and rows must be multiples of patch, which is at least 1");
      }
      if (contrast_window < 1 || length < 1 || elsewhere < 1) {
        throw sim::Error("contrast_window, length and elsewhere must be at least 1");
      }
      if (!(least_speed > 0.0 && most_speed >= least_speed && speed_step > 0.0)) {
        throw sim::Error("expected 0 < least_speed <= most_speed and a positive speed_step");
      }
    }
  };

  SeqSlamDetector(const Config& config, const LoopContext& /*context*/) : config_(config) {}

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    pictures_.push_back(Normalised(Shrunk(frame)));
    columns_.push_front(Enhanced(Differences(frame.comparable)));
    if (columns_.size() > static_cast<std::size_t>(config_.length)) columns_.pop_back();
    std::vector<LoopCandidate> candidates;
    if (columns_.size() < static_cast<std::size_t>(config_.length)) return candidates;
    candidates.reserve(static_cast<std::size_t>(frame.comparable));
    for (int earlier = 0; earlier < frame.comparable; ++earlier) {
      const double difference = LeastDifference(earlier);
      if (std::isfinite(difference)) {
        candidates.push_back({frame.number, earlier, -difference, false});
      }
    }
    Propose(&candidates);
    return candidates;
  }

 private:
  using Picture = std::vector<float>;

  /// Means of grey values over the pixels of each cell.
  Picture Shrunk(const LoopFrame& frame) const {
    const auto cols = static_cast<std::size_t>(config_.cols);
    const std::size_t cells = cols * static_cast<std::size_t>(config_.rows);
    Picture sums(cells, 0.0f);
    std::vector<int> counts(cells, 0);
    std::size_t byte = 0;
    for (int y = 0; y < frame.height_px; ++y) {
      const auto row = static_cast<std::size_t>(y * config_.rows / frame.height_px);
      for (int x = 0; x < frame.width_px; ++x, byte += 3) {
        const auto cell = row * cols + static_cast<std::size_t>(x * config_.cols / frame.width_px);
        sums[cell] += static_cast<float>(frame.color[byte]) +
                      static_cast<float>(frame.color[byte + 1]) +
                      static_cast<float>(frame.color[byte + 2]);
        ++counts[cell];
      }
    }
    for (std::size_t i = 0; i < cells; ++i) {
      sums[i] /= static_cast<float>(3 * std::max(1, counts[i]));
    }
    return sums;
  }

  /// Each patch with mean 0 and deviation 1.
  Picture Normalised(Picture picture) const {
    for (int row = 0; row < config_.rows; row += config_.patch) {
      for (int col = 0; col < config_.cols; col += config_.patch) {
        NormalisePatch(row, col, &picture);
      }
    }
    return picture;
  }

  void NormalisePatch(int row, int col, Picture* picture) const {
    const auto cols = static_cast<std::size_t>(config_.cols);
    const auto each = [&](const auto& take) {
      for (int i = 0; i < config_.patch * config_.patch; ++i) {
        const int y = row + i / config_.patch;
        const int x = col + i % config_.patch;
        take(&(*picture)[static_cast<std::size_t>(y) * cols + static_cast<std::size_t>(x)]);
      }
    };
    const auto count = static_cast<float>(config_.patch * config_.patch);
    float mean = 0.0f;
    float square = 0.0f;
    each([&](const float* value) {
      mean += *value / count;
    });
    each([&](const float* value) {
      square += (*value - mean) * (*value - mean) / count;
    });
    constexpr float kBlank = 1.0f;  // grey values: a blank patch stays blank
    const float deviation = std::max(kBlank, std::sqrt(square));
    each([&](float* value) {
      *value = (*value - mean) / deviation;
    });
  }

  /// Mean absolute differences of the newest picture to the first so many.
  std::vector<double> Differences(int count) const {
    std::vector<double> differences;
    differences.reserve(static_cast<std::size_t>(count));
    const Picture& now = pictures_.back();
    for (int i = 0; i < count; ++i) {
      const Picture& then = pictures_[static_cast<std::size_t>(i)];
      float sum = 0.0f;
      for (std::size_t p = 0; p < now.size(); ++p) sum += std::abs(now[p] - then[p]);
      differences.push_back(static_cast<double>(sum) / static_cast<double>(now.size()));
    }
    return differences;
  }

  /// How many deviations each is above the mean of its neighbours in time.
  std::vector<double> Enhanced(const std::vector<double>& differences) const {
    std::vector<double> enhanced;
    enhanced.reserve(differences.size());
    const int count = static_cast<int>(differences.size());
    for (int i = 0; i < count; ++i) {
      const int first = std::max(0, i - config_.contrast_window);
      const int last = std::min(count - 1, i + config_.contrast_window);
      double mean = 0.0;
      double square = 0.0;
      for (int j = first; j <= last; ++j) mean += differences[static_cast<std::size_t>(j)];
      mean /= last - first + 1;
      for (int j = first; j <= last; ++j) {
        const double off = differences[static_cast<std::size_t>(j)] - mean;
        square += off * off;
      }
      constexpr double kLeast = 1e-3;  // else a still body divides by nothing
      const double deviation = std::max(kLeast, std::sqrt(square / (last - first + 1)));
      enhanced.push_back((differences[static_cast<std::size_t>(i)] - mean) / deviation);
    }
    return enhanced;
  }

  /// Over all speeds, of the line that ends at a frame now; infinite if none lies within.
  double LeastDifference(int earlier) const {
    double least = std::numeric_limits<double>::infinity();
    const int speeds = 1 + static_cast<int>(std::lround((config_.most_speed - config_.least_speed) /
                                                        config_.speed_step));
    for (int i = 0; i < speeds; ++i) {
      least = std::min(least, AlongLine(earlier, config_.least_speed + i * config_.speed_step));
    }
    return least;
  }

  double AlongLine(int earlier, double speed) const {
    double sum = 0.0;
    for (std::size_t back = 0; back < columns_.size(); ++back) {
      const auto at =
          static_cast<std::ptrdiff_t>(std::lround(earlier - speed * static_cast<double>(back)));
      if (at < 0 || at >= static_cast<std::ptrdiff_t>(columns_[back].size())) {
        return std::numeric_limits<double>::infinity();
      }
      sum += columns_[back][static_cast<std::size_t>(at)];
    }
    return sum / static_cast<double>(columns_.size());
  }

  /// Marks the best if nothing elsewhere is nearly as good. Differences are in deviations, about
  /// -1 to -3 for good ones, so that the smaller number is the better and ratios are of sizes.
  void Propose(std::vector<LoopCandidate>* candidates) const {
    if (candidates->empty()) return;
    const auto is_less = [](const LoopCandidate& a, const LoopCandidate& b) {
      return a.score < b.score;
    };
    const auto best = std::max_element(candidates->begin(), candidates->end(), is_less);
    double second = 0.0;
    int others = 0;
    for (const LoopCandidate& other : *candidates) {
      if (std::abs(other.earlier - best->earlier) <= config_.elsewhere) continue;
      second = std::max(second, other.score);
      ++others;
    }
    // Where there is nearly nothing else, nothing is as good by chance.
    best->is_proposed = best->score >= config_.least_score && others > 2 * config_.elsewhere &&
                        second <= config_.most_ratio * best->score;
  }

  Config config_;
  std::vector<Picture> pictures_;
  std::deque<std::vector<double>> columns_;  // enhanced differences, the newest first
};

const LoopDetectorRegistration<SeqSlamDetector> registration;

}  // namespace
}  // namespace bulletnav::agent
