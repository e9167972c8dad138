#pragma once
// Measurements of a client's own session: JSON report and latency log.

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

#include "client/app/session/connection.h"
#include "client/xr/frame_pacing.h"

namespace prosector {

/// Log file for latency measurements: the times at which each participant's inputs first appeared in a state
/// received from the server. It is called on the network thread.
class ArrivalLog {
 public:
  /// Opens a CSV file with the columns arrived_ns, participant, sequence and tick. Throws InputError if it
  /// cannot be written.
  explicit ArrivalLog(const std::filesystem::path& file);
  void received(const Received& received);

 private:
  std::ofstream out_;
  std::map<ParticipantId, std::uint64_t> last_sequence_;
};

struct ClientReport {
  std::int64_t started_ns = 0, joined_ns = 0;
  std::optional<std::int64_t> complete_ns, first_picture_ns;
  std::uint64_t bytes_at_complete = 0;
  std::uint64_t pictures = 0;
  double drawing_seconds = 0;
  double longest_drawing_seconds = 0;  // of one frame, except the first, which compiles shaders
  std::string renderer;
  std::optional<FramePacing> pacing;  // frame pacing of a headset
};

void write_report(const ClientReport& report, Connection& connection, const std::filesystem::path& file);

}  // namespace prosector
