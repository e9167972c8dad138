#pragma once
// The line to a VRPN server: bytes each way, and nothing that waits.

#include <memory>
#include <span>
#include <string>

#include "drivers/vrpn_messages.h"

namespace prosector::vrpn {

class Line {
 public:
  virtual ~Line() = default;
  /// Appends what arrived. Returns false when the line is gone; error() says why.
  virtual bool receive(Bytes& out) = 0;
  /// Sends bytes. While earlier ones wait for their way out, newer ones are dropped, as a whole.
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  virtual const std::string& error() const = 0;
};

/// Connects by TCP; that may take two seconds. Throws InputError with the reason where it can't.
std::unique_ptr<Line> connect_line(const std::string& host, const std::string& port);

}  // namespace prosector::vrpn
