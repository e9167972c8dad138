#pragma once
// A profile of deploy/dds with its placeholders filled in: Cyclone's whole configuration as a string, so that
// CYCLONEDDS_URI from the environment can't widen it.

#include <string>

#include "idl/bus.h"

namespace prosector {

extern const char* const loopback_profile;
extern const char* const lan_profile;
extern const char* const wan_profile;

inline constexpr std::uint32_t max_domain = 230;
inline constexpr std::uint32_t servers_per_host = 10;

/// Returns the UDP port at which a server with this index listens (DDSI 2.3, 9.6.1.1).
constexpr std::uint32_t server_port(std::uint32_t domain, std::uint32_t index) {
  return 7410 + 250 * domain + 2 * index;
}

/// Returns the profile's text. Throws InputError for a profile that can't be read or lacks what it asks for,
/// and for values out of range.
std::string profile_xml(const BusConfig& config);

}  // namespace prosector
