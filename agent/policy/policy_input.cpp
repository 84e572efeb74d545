// SPDX-License-Identifier: MIT
#include "agent/policy/policy_input.h"

#include <algorithm>

#include "agent/integer/integer_trunk.h"
#include "sim/base/check.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {
namespace {

constexpr double kStepMetres = 0.25;
constexpr double kTurnDegrees = 10.0;

}  // namespace

void WritePolicyNumbers(const Observation& observation, std::optional<sim::Action> last,
                        int step_limit, std::span<float> numbers) {
  BULLETNAV_CHECK_EQ(numbers.size(), std::size_t{kPolicyNumbers});
  std::fill(numbers.begin(), numbers.end(), 0.0f);
  if (last) numbers[static_cast<std::size_t>(*last)] = 1.0f;
  numbers[4] = static_cast<float>(observation.odometry.x / kStepMetres);
  numbers[5] = static_cast<float>(observation.odometry.y / kStepMetres);
  numbers[6] = static_cast<float>(observation.odometry.yaw / sim::DegToRad(kTurnDegrees));
  numbers[7] =
      static_cast<float>(std::min(observation.step, step_limit)) / static_cast<float>(step_limit);
}

PolicyPictures::PolicyPictures(int rows, int panorama_rows)
    : with_depth_(rows, true, panorama_rows),
      color_alone_(rows, false, panorama_rows),
      pictures_({rows, 4 * rows, kInputChannels, 0}, 1) {}

void PolicyPictures::Write(const Panorama& panorama, std::span<std::uint8_t> out) {
  BULLETNAV_CHECK_EQ(out.size(), bytes());
  std::fill(pictures_.bytes.begin(), pictures_.bytes.end(), std::uint8_t{0});
  (panorama.depth.empty() ? color_alone_ : with_depth_).Prepare(panorama, 0, &pictures_);
  std::copy(pictures_.bytes.begin(), pictures_.bytes.end(), out.begin());
}

}  // namespace bulletnav::agent
