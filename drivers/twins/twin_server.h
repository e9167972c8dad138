#pragma once
// Serves a twin on a pseudo-terminal or at a socket, with the faults that real lines have.

#include <atomic>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "drivers/twins/twin.h"

namespace prosector {

struct TwinServerOptions {
  std::optional<std::uint16_t> port;  // TCP, on this machine; 0: one that is free; none: no TCP
  std::string socket;                 // Unix; empty: none. Without either: a pseudo-terminal
  std::string link;                   // symbolic link to the terminal, kept up to date; empty: none
  std::string log;                    // CSV file of the records sent; empty: none
  double garbage = 0;                 // probability that random bytes precede a record
  std::optional<FaultSpan> silence, unplug, babble;  // since the server started
  std::uint64_t seed = 1;
  bool hears_lines = false;  // each line on standard input is a Twin::go_on()
};

/// Serves the twin until `stop` becomes true. Calls `ready` with where clients find it, again after each
/// unplugging. Throws InputError when a file or a terminal cannot be made.
///
/// A line of the log has time_ns (monotonic, just before the record's first byte is written), station (from
/// 1) and record. Then come the values exactly as sent, in the shortest decimal form that reads back as the
/// same float32.
void serve_twin(Twin& twin, const TwinServerOptions& options, const std::atomic<bool>& stop,
                const std::function<void(const std::string& path)>& ready);

}  // namespace prosector
