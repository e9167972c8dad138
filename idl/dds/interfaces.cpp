#include "idl/dds/interfaces.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <algorithm>
#include <array>
#include <memory>

#include "common/error.h"

namespace prosector {

std::vector<NetworkInterface> network_interfaces() {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(first, freeifaddrs);
  std::vector<NetworkInterface> out;
  for (const ifaddrs* i = first; i != nullptr; i = i->ifa_next) {
    const bool up = (i->ifa_flags & IFF_UP) != 0 && (i->ifa_flags & IFF_LOOPBACK) == 0;
    if (!up || i->ifa_addr == nullptr || i->ifa_addr->sa_family != AF_INET) continue;
    const bool known = std::ranges::any_of(out, [i](const auto& other) { return other.name == i->ifa_name; });
    if (known) continue;  // another address of the same interface
    std::array<char, INET_ADDRSTRLEN> text{};
    inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(i->ifa_addr)->sin_addr, text.data(),
              text.size());
    out.push_back({i->ifa_name, text.data()});
  }
  return out;
}

std::string only_interface(const std::vector<NetworkInterface>& interfaces) {
  if (interfaces.size() == 1) return interfaces.front().name;
  if (interfaces.empty())
    throw InputError("no network interface except loopback is up: omit --lan to stay on this machine");
  std::string list;
  for (const NetworkInterface& i : interfaces)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", i.name, i.address);
  throw InputError(
      fmt::format("several network interfaces are up; choose one of these with --lan NAME: {}", list));
}

}  // namespace prosector
