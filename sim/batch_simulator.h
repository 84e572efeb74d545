// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/simulator.h"

namespace bulletnav::sim {

/// Where an array of all lanes goes.
struct BatchArray {
  std::string name;            // "front.depth", as in SensorSet
  std::span<std::byte> bytes;  // [lanes, shape...]
};

/// Where the observations of all lanes go: the caller's memory, lane after lane.
struct BatchObservations {
  std::span<std::uint8_t> color;  // of the panorama: [lanes, rows, cols, 3]; empty if not wanted
  std::span<float> depth;         // [lanes, rows, cols]; empty if not wanted
  std::span<const BatchArray> arrays = {};  // of any sensors, those wanted alone

  bool empty() const { return color.empty() && depth.empty() && arrays.empty(); }
};

/// Told of a body that has moved, before what it sees is drawn; `place`: among the lanes that move.
/// Called from the threads, of several lanes at once.
using AfterMotion = std::function<void(std::size_t place, const Sensors& sensors)>;

/// N bodies over W threads, in one world or many, for training and evaluation. Lane i behaves bit
/// for bit like a Simulator of its own with the same world, spec and calls, whatever W is. The
/// spec's color and depth flags do not matter here: what is not wanted is not asked for. Threads
/// take lanes one after the other and draw straight into the caller's memory; on a graphics
/// processor they do the physics, and panoramas of neighbouring lanes of one world are drawn
/// together. Misuse throws Error that names the call, and nothing has happened then: a null world,
/// a lane that is not there or was not reset, memory that does not fit, an action that is none.
class BatchSimulator {
 public:
  /// One world per lane, none of them null; lanes may share worlds. `workers` < 1: one per
  /// processor.
  BatchSimulator(std::vector<std::shared_ptr<const World>> worlds, const SimulatorSpec& spec,
                 int workers);
  ~BatchSimulator();
  BatchSimulator(const BatchSimulator&) = delete;
  BatchSimulator& operator=(const BatchSimulator&) = delete;
  BatchSimulator(BatchSimulator&&) = delete;
  BatchSimulator& operator=(BatchSimulator&&) = delete;

  int lanes() const;
  /// Of the body's sensors, for one lane.
  const std::vector<ArraySpec>& arrays() const;

  /// Starts an episode in one lane. Throws PoseError and leaves the lane as it was.
  void Reset(int lane, const BodyPose& pose, const EpisodeKey& key = {});
  /// Moves a lane to another world, where it must be reset before the next Step or Observe.
  void SetWorld(int lane, std::shared_ptr<const World> world);

  /// One action a lane; writes every lane's sensors and observation. An exception in a lane is
  /// thrown here once all lanes have finished.
  void Step(std::span<const Action> actions, std::span<Sensors> sensors,
            const BatchObservations& out);
  /// The same for some lanes, in rising order: actions and sensors in their order, `out` still of
  /// all lanes. Empty spans in `out`: nothing is drawn. `after`: what the caller has to do for each
  /// lane that has moved; it may throw.
  void Step(std::span<const int> lanes, std::span<const Action> actions, std::span<Sensors> sensors,
            const BatchObservations& out, const AfterMotion& after = {});
  /// The observations alone, after resets: of all lanes, or of some.
  void Observe(const BatchObservations& out);
  void Observe(std::span<const int> lanes, const BatchObservations& out);
  /// What the panorama's camera would see anywhere in a lane's world, by the renderers that are
  /// there: one picture, without noise; `arrays` does not matter. `glass`: as PictureMemory::glass.
  void Render(int lane, const CameraPose& camera, const BatchObservations& out,
              std::span<std::uint8_t> glass = {});

  /// Ground truth of a lane.
  const SimulatedBody& body(int lane) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bulletnav::sim
