#include "client/offer/offer_protocol.h"

#include <fmt/format.h>

#include "common/error.h"
#include "drivers/ports/byte_line.h"
#include "drivers/protocols/igtl_messages.h"
#include "drivers/protocols/vrpn_messages.h"

namespace prosector {

const std::vector<OfferProtocol>& offer_protocols() {
  static const std::vector<OfferProtocol> protocols = {{"vrpn", vrpn::default_port, make_vrpn_connection},
                                                       {"igtl", igtl::default_port, make_igtl_connection}};
  return protocols;
}

Offer parse_offer(const std::string& text) {
  const auto colon = text.find(':');
  for (const OfferProtocol& protocol : offer_protocols()) {
    if (text.substr(0, colon) != protocol.name) continue;
    Offer out;
    out.protocol = &protocol;
    std::string where = colon == std::string::npos ? out.address : text.substr(colon + 1);
    std::string beside;
    if (where.starts_with('[') && where.find(']') != std::string::npos) {  // an IPv6 address
      beside = where.substr(where.find(']') + 1);
      where = where.substr(1, where.find(']') - 1);
    } else if (const auto port = where.find(':'); port != std::string::npos) {
      beside = where.substr(port);
      where.resize(port);
    }
    const auto at = parse_host_port(where.empty() ? "" : "x" + beside, protocol.default_port);
    if (!at) break;
    out.address = where;
    out.port = static_cast<std::uint16_t>(std::stoul(at->port));
    return out;
  }
  throw InputError(
      fmt::format("--publish {}: must be vrpn or igtl, optionally followed by the address to listen at: "
                  "vrpn:ADDRESS:PORT, e.g. igtl:192.168.0.7:18944",
                  text));
}

}  // namespace prosector
