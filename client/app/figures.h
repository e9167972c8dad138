#pragma once
// What pictures, network and simulation take, in words for who looks at them.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "client/language/catalogue.h"
#include "common/messages.h"
#include "idl/bus.h"

namespace prosector {

class Figures {
 public:
  explicit Figures(Catalogue words = {}) : words_(std::move(words)) {}

  /// Takes that a picture was drawn, which took `seconds`; `counters` and `status` (null: none yet) as they
  /// are.
  void take(std::int64_t now_ns, double seconds, const BusCounters& counters, const ServerStatus* status);
  /// Returns the lines of the last half second that is over; empty before that.
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
