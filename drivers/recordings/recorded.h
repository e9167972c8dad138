#pragma once
// Device samples in a CSV file: SampleRecorder writes them, RecordedDevice replays them in real time.
//
// Columns: time (s), station, x y z (m, room frame), qw qx qy qz, thumb index middle ring little (0 open … 1
// closed), gesture (name), buttons. Empty pose or flexion cells: the sample has none.

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "drivers/device/device.h"

namespace prosector {

/// Appends samples to a file; time 0 is the first sample.
class SampleRecorder {
 public:
  /// Opens the file. Throws InputError if it is not writable.
  explicit SampleRecorder(const std::filesystem::path& file);
  /// Appends the samples. Returns false once writing fails (a full disk).
  bool write(const std::vector<DeviceSample>& samples);

 private:
  std::ofstream out_;
  std::optional<std::int64_t> start_ns_;
};

struct TimedSample {
  double time = 0;  // s
  DeviceSample sample;
};
/// Reads a recording. Throws InputError with file and line; times must not decrease.
std::vector<TimedSample> load_recording(const std::filesystem::path& file);

class RecordedDevice final : public Device {
 public:
  /// Replays from the first poll on. `loop` restarts after the last sample.
  RecordedDevice(const std::filesystem::path& file, bool loop);
  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  std::string path_;
  std::vector<TimedSample> samples_;
  bool loop_;
  std::size_t next_ = 0;
  std::optional<std::int64_t> start_ns_;
  std::uint64_t records_ = 0;
};

std::unique_ptr<Device> open_recorded(const std::string& path);
std::unique_ptr<Device> open_recorded_loop(const std::string& path);

}  // namespace prosector
