#pragma once
// DDS profiles (deploy/dds) with their placeholders filled in. The result is Cyclone's whole configuration as
// a string, so that CYCLONEDDS_URI in the environment can't extend it.

#include <string>

#include "idl/bus.h"

namespace prosector {

extern const char* const loopback_profile;
extern const char* const lan_profile;
extern const char* const wan_profile;

inline constexpr std::uint32_t max_domain = 230;
inline constexpr std::uint32_t servers_per_host = 10;

/// Returns the UDP port of the server with this index in a DDS domain (DDSI 2.3, 9.6.1.1).
constexpr std::uint32_t server_port(std::uint32_t domain, std::uint32_t index) {
  return 7410 + 250 * domain + 2 * index;
}

/// Returns the configuration of Cyclone DDS as XML: the network profile with the settings of `config` filled
/// in. Throws InputError if the profile can't be read, if a required setting is missing, or if a value is out
/// of range.
std::string profile_xml(const BusConfig& config);

}  // namespace prosector
