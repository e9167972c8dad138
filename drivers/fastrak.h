#pragma once
// The Polhemus FASTRAK tracker: up to four receivers in a magnetic field, on a serial line.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "drivers/fastrak_record.h"
#include "drivers/pose_chain.h"
#include "drivers/stream_device.h"

namespace prosector {

/// Returns what the driver sends, in order, after the device has answered the status question. The last
/// command starts continuous output. Centimetres; output list 2, 11, 1 (position, quaternion, CR LF) for
/// every station.
std::vector<std::string> fastrak_commands(const DeviceConfig& config);

/// One step of the start-up dialogue: bytes to send, then a time to wait.
struct FastrakStep {
  std::string bytes;
  std::int64_t wait_ns = 0;
};
/// Returns what the driver sends before it asks for the status, at the attempt of that number, from 1 on. A
/// tracker may be suspended, amid another program's command, in extended or in point mode: later attempts
/// free it from more of these. From the sixth one on the tracker initialises itself, which takes 10 s.
std::vector<FastrakStep> fastrak_start(int attempt);

class FastrakDevice final : public StreamDevice {
 public:
  FastrakDevice(std::unique_ptr<DevicePort> port, const DeviceConfig& config);
  DeviceStatus status() const override;

 private:
  enum class Phase { stopping, asked, configuring, streaming };

  void started(std::int64_t now_ns) override;
  void advance(std::int64_t now_ns) override;
  void parse(std::int64_t now_ns, std::vector<DeviceSample>& out) override;
  std::string silent_hint() const override;
  std::string babble_hint() const override;

  void restart(std::int64_t now_ns);
  void parse_status();
  void parse_records(std::int64_t now_ns, std::vector<DeviceSample>& out);
  /// Returns the length of a command error record at the front: 0 when there is none, −1 when more bytes are
  /// needed.
  int error_record_length() const;
  DeviceSample sample(const fastrak::Record& record);

  DeviceConfig config_;
  PoseChain chain_;
  fastrak::Format format_;
  std::vector<std::string> commands_;
  Phase phase_ = Phase::stopping;
  int attempt_ = 0;  // to start it, since it last answered
  std::vector<FastrakStep> steps_;
  std::size_t next_step_ = 0, next_command_ = 0;
  std::int64_t due_ns_ = 0;  // when the phase moves on
  std::size_t run_ = 0;      // garbage bytes of the current run
  std::array<std::uint64_t, max_stations> records_{};
  bool answered_ = false;  // the status question, since the port was opened
  std::uint64_t command_errors_ = 0;
  std::string command_error_;  // the device's last refusal
  std::array<char, max_stations> station_error_{' ', ' ', ' ', ' '};
};

std::unique_ptr<Device> open_fastrak(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
