#pragma once
// Motion of a simulated device's wearer: keyframes from a CSV file, interpolated smoothly.
//
// Columns: time (s), station (from 1; default 1), x y z (m), qw qx qy qz in the room frame, thumb index
// middle ring little (0 open … 1 closed). A row may contain a pose, flexions or both.

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

#include "common/math.h"
#include "drivers/device/device.h"

namespace prosector {

class MotionScript {
 public:
  /// Reads a motion script, a CSV file of keyframes for a simulated device's wearer. Throws InputError with
  /// file and line; times must increase within a station.
  static MotionScript load(const std::filesystem::path& file);

  void add(std::size_t station, double time, const Pose& pose) { poses_[station].push_back({time, pose}); }
  void add(std::size_t station, double time, const std::array<double, fingers>& flexion) {
    flexions_[station].push_back({time, flexion});
  }

  /// Returns the pose (room frame) of `station` (index from 0) at `time`, s. Interpolates between keyframes a
  /// and b by x = a + s·(b − a), s = 6u⁵ − 15u⁴ + 10u³, which is at rest at each keyframe; rotations by
  /// slerp. The pose is constant before the first and after the last keyframe, and the identity for a station
  /// without keyframes. With `loop`, time restarts after the last keyframe of all stations.
  Pose pose(std::size_t station, double time, bool loop) const;
  std::array<double, fingers> flexion(std::size_t station, double time, bool loop) const;
  double duration() const;

 private:
  template <class T>
  struct Key {
    double time;
    T value;
  };
  double wrapped(double time, bool loop) const;

  std::array<std::vector<Key<Pose>>, max_stations> poses_;
  std::array<std::vector<Key<std::array<double, fingers>>>, max_stations> flexions_;
};

}  // namespace prosector
