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

/// Protocol state of one connected program.
class OfferConnection {
 public:
  using Bytes = std::vector<std::uint8_t>;

  virtual ~OfferConnection() = default;
  /// Processes received bytes. Returns false if they violate the protocol.
  virtual bool hear(std::span<const std::uint8_t> bytes) = 0;
  /// Returns the bytes to send next; `now_ns`: ns since the epoch. Empty: none.
  virtual Bytes say(const std::vector<Offered>& things, std::int64_t now_ns) = 0;
  /// Returns the message with an image; `now_ns`: ns since the epoch. Empty: the protocol has no images.
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

/// Address of an offer: PROTOCOL[:ADDRESS[:PORT]].
struct Offer {
  const OfferProtocol* protocol = nullptr;
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;
};
/// Parses an offer. Throws InputError with the allowed format.
Offer parse_offer(const std::string& text);

}  // namespace prosector
