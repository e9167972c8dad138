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

/// Recorder of device samples to a CSV file. The time in the file is in s and starts at 0 with the first
/// sample.
class SampleRecorder {
 public:
  /// Creates the recording's CSV file and writes its header. Throws InputError if the file is not writable.
  explicit SampleRecorder(const std::filesystem::path& file);
  /// Appends the samples to the recording's file. Returns false once writing has failed, for example on a
  /// full disk.
  bool write(const std::vector<DeviceSample>& samples);

 private:
  std::ofstream out_;
  std::optional<std::int64_t> start_ns_;
};

struct TimedSample {
  double time = 0;  // s
  DeviceSample sample;
};
/// Reads the samples of a recording (CSV file) in order of time. Throws InputError with file and line; times
/// must not decrease.
std::vector<TimedSample> load_recording(const std::filesystem::path& file);

class RecordedDevice final : public Device {
 public:
  /// Reads a recording of device samples. The replay starts with the first poll(); `loop` restarts it after
  /// the last sample. Throws InputError if the file is invalid.
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
