#pragma once
// Network interfaces of this machine, used if the user names none.

#include <string>
#include <vector>

namespace prosector {

struct NetworkInterface {
  std::string name, address;  // "eth0", "10.0.0.1"
};

/// Returns the network interfaces of this machine that are up and have an IPv4 address, except loopback.
std::vector<NetworkInterface> network_interfaces();

/// Returns the name of the only network interface in the list. Throws InputError that lists them if there are
/// several or none.
std::string only_interface(const std::vector<NetworkInterface>& interfaces);

}  // namespace prosector
