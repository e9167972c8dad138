#pragma once
// Statistics of rendering, network and simulation as text for the user.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "client/language/catalogue.h"
#include "common/status_messages.h"
#include "idl/bus.h"

namespace prosector {

class Figures {
 public:
  explicit Figures(Catalogue words = {}) : words_(std::move(words)) {}

  /// Adds a frame that took `seconds` to render, with the network's present message counters and the server's
  /// status (null: none yet). `now_ns`: monotonic time.
  void take(std::int64_t now_ns, double seconds, const BusCounters& counters, const ServerStatus* status);
  /// Returns the statistics of the last complete half second as text for the user; empty before that.
  const std::string& text() const { return text_; }

 private:
  Catalogue words_;
  std::optional<std::int64_t> since_ns_;
  BusCounters counters_since_;
  int pictures_ = 0;
  double drawing_seconds_ = 0, longest_ = 0;  // s
  std::string text_;
};

}  // namespace prosector
