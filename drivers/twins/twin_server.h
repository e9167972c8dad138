#pragma once
// Serves a twin on a pseudo-terminal, with the faults that real lines have.

#include <atomic>
#include <fstream>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "drivers/twins/twin.h"

namespace prosector {

/// A span of time, seconds since the server started.
struct FaultSpan {
  double from = 0, to = 0;
  bool contains(double t) const { return t >= from && t < to; }
};

struct TwinServerOptions {
  std::string link;    // symbolic link to the terminal, kept up to date; empty: none
  std::string log;     // CSV file of the records sent; empty: none
  double garbage = 0;  // probability that random bytes precede a record
  std::optional<FaultSpan> silence, unplug, babble;
  std::uint64_t seed = 1;
  bool hears_lines = false;  // each line on standard input is a Twin::go_on()
};

/// Serves the twin until `stop` becomes true. Calls `ready` with the terminal's path, again after each
/// unplugging. Throws InputError when a file or a terminal cannot be made.
///
/// A line of the log has time_ns (monotonic, just before the record's first byte is written), station (from
/// 1) and record. Then come the values exactly as sent, in the shortest decimal form that reads back as the
/// same float32.
void serve_twin(Twin& twin, const TwinServerOptions& options, const std::atomic<bool>& stop,
                const std::function<void(const std::string& path)>& ready);

}  // namespace prosector
