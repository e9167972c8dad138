#pragma once
// Serves a twin on a pseudo-terminal or at a socket, with the faults of real connections.

#include <atomic>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "twins/base/twin.h"

namespace prosector {

struct TwinServerOptions {
  std::optional<std::uint16_t> port;  // TCP port on this machine; 0: a free one; none: no TCP
  std::string socket;                 // Unix socket; empty: none. Without port and socket: a pseudo-terminal
  std::string link;                   // symbolic link to the terminal, updated when it is reopened; empty:
                                      // none
  std::string log;                    // CSV file of the sent records; empty: none
  double garbage = 0;                 // probability that random bytes precede a record
  std::optional<FaultSpan> silence, unplug, babble;  // since the server started
  std::uint64_t seed = 1;
  bool reads_stdin_lines = false;  // each line on standard input calls Twin::go_on()
};

/// Connects the simulated device to clients until `stop` becomes true. Calls `ready` with the address for
/// clients, and again after each simulated unplugging. Throws InputError if a file or a terminal cannot be
/// created.
///
/// The log is the CSV file of `options`. A line per record: time_ns (monotonic, just before its first byte is
/// written), station (from 1), record number (from 0), values. The values are as sent, in the shortest
/// decimal form that parses to the same float32.
void serve_twin(Twin& twin, const TwinServerOptions& options, const std::atomic<bool>& stop,
                const std::function<void(const std::string& path)>& ready);

}  // namespace prosector
