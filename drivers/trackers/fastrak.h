#pragma once
// Polhemus FASTRAK tracker: up to four receivers in a magnetic field, on a serial line.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "drivers/device/pose_chain.h"
#include "drivers/device/stream_device.h"
#include "drivers/protocols/fastrak_record.h"
#include "drivers/trackers/fastrak_config.h"

namespace prosector {

/// Returns the commands that configure a FASTRAK tracker, in the order in which the driver sends them after
/// the status query is answered. `stations` is the bit mask of active stations (receivers). The last command
/// starts continuous output. Units are centimetres; the output list of every station is 2, 11, 1 (position,
/// quaternion, CR LF).
std::vector<std::string> fastrak_commands(std::uint32_t stations, const FastrakConfig& config);

/// One step of a FASTRAK tracker's start-up sequence: bytes to send, then a time to wait.
struct FastrakStep {
  std::string bytes;
  std::int64_t wait_ns = 0;
};
/// Returns the steps that the driver performs before the status query, for start attempt number `attempt`,
/// from 1. The FASTRAK may be suspended, in the middle of another program's command, in extended mode or in
/// point mode. Later attempts recover it from more of these states. From the sixth attempt on the tracker
/// reinitialises, which takes 10 s.
std::vector<FastrakStep> fastrak_start(int attempt);

class FastrakDevice final : public StreamDevice {
 public:
  FastrakDevice(std::unique_ptr<DevicePort> port, const Placement& placement, const FastrakConfig& config);
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
  /// Returns the length in bytes of an error record for a refused command at the front of the buffer. Returns
  /// 0 if there is none, −1 if more bytes are needed.
  int error_record_length() const;
  DeviceSample sample(const fastrak::Record& record);

  PoseChain chain_;
  fastrak::Format format_;
  std::vector<std::string> commands_;
  Phase phase_ = Phase::stopping;
  int attempt_ = 0;  // start attempts since the device last answered
  std::vector<FastrakStep> steps_;
  std::size_t next_step_ = 0, next_command_ = 0;
  std::int64_t due_ns_ = 0;  // earliest time of the next step
  std::size_t run_ = 0;      // consecutive garbage bytes
  std::array<std::uint64_t, max_stations> records_{};
  bool answered_ = false;  // the device answered the status query since the port was opened
  std::uint64_t command_errors_ = 0;
  std::string command_error_;  // latest error record for a refused command
  std::array<char, max_stations> station_error_{' ', ' ', ' ', ' '};
};

std::unique_ptr<Device> open_fastrak(const std::string& path, const Placement& placement,
                                     const FastrakConfig& config);

}  // namespace prosector
