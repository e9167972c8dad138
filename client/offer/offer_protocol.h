#pragma once
// Protocols by which poses are offered.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/offer/offered.h"
#include "common/image.h"

namespace prosector {

/// Protocol state of the connection to one program that receives poses from this client.
class OfferConnection {
 public:
  using Bytes = std::vector<std::uint8_t>;

  virtual ~OfferConnection() = default;
  /// Processes bytes received from the program. Returns false if they violate the protocol.
  virtual bool hear(std::span<const std::uint8_t> bytes) = 0;
  /// Returns the bytes to send next: the poses of `things` and pending replies. `now_ns`: system time, ns
  /// since the Unix epoch. Empty: nothing to send now.
  virtual Bytes say(const std::vector<Offered>& things, std::int64_t now_ns) = 0;
  /// Returns the protocol's message with a camera image; the second argument is the system time, ns since the
  /// Unix epoch. Returns no bytes if the protocol has no images, as here by default.
  virtual Bytes show(const Image&, std::int64_t) { return {}; }
};

struct OfferProtocol {
  const char* name;
  const char* default_port;
  std::unique_ptr<OfferConnection> (*talk)();
};
const std::vector<OfferProtocol>& offer_protocols();

std::unique_ptr<OfferConnection> make_vrpn_connection();
std::unique_ptr<OfferConnection> make_igtl_connection();

/// Parsed option --publish, with the format PROTOCOL[:ADDRESS[:PORT]]: protocol and network address at which
/// this client publishes poses to other programs.
struct Offer {
  const OfferProtocol* protocol = nullptr;
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;
};
/// Parses the option --publish, PROTOCOL[:ADDRESS[:PORT]], by which this client publishes poses. Throws
/// InputError with the allowed format.
Offer parse_offer(const std::string& text);

}  // namespace prosector
