#pragma once
// The protocols by which poses are offered.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/offer/offered.h"
#include "common/image.h"

namespace prosector {

/// What is said to one program that came, and what it says.
class OfferTalk {
 public:
  using Bytes = std::vector<std::uint8_t>;

  virtual ~OfferTalk() = default;
  /// Takes what it says. Returns false when that is not this protocol.
  virtual bool hear(std::span<const std::uint8_t> bytes) = 0;
  /// Returns what to say next, `now_ns` after the epoch; empty: nothing.
  virtual Bytes say(const std::vector<Offered>& things, std::int64_t now_ns) = 0;
  /// Returns what shows a picture, `now_ns` after the epoch; empty: this protocol has none.
  virtual Bytes show(const Image&, std::int64_t) { return {}; }
};

struct OfferProtocol {
  const char* name;
  const char* usual_port;
  std::unique_ptr<OfferTalk> (*talk)();
};
const std::vector<OfferProtocol>& offer_protocols();

std::unique_ptr<OfferTalk> talk_vrpn();
std::unique_ptr<OfferTalk> talk_igtl();

/// An offer as people ask for it: PROTOCOL[:ADDRESS[:PORT]].
struct Offer {
  const OfferProtocol* protocol = nullptr;
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;
};
/// Reads an offer. Throws InputError with what is allowed.
Offer parse_offer(const std::string& text);

}  // namespace prosector
