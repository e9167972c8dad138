#include "idl/dds/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "common/error.h"
#include "common/regular_file.h"
#include "idl/dds/interfaces.h"

namespace prosector {
namespace {

std::string read_profile(const std::string& profile) {
  if (profile.empty() || profile == "loopback") return loopback_profile;
  if (profile == "lan") return lan_profile;
  if (profile == "wan") return wan_profile;
  if (!std::filesystem::exists(profile))
    throw InputError(fmt::format(
        "network profile \"{}\" does not exist: use loopback, lan, wan or a file such as deploy/dds/lan.xml",
        profile));
  constexpr std::size_t max_bytes = 1 << 20;
  return read_regular_file(profile, max_bytes);
}

/// Throws InputError for text that could break out of an XML attribute.
void require_address(const std::string& text, const char* what) {
  const bool ok = !text.empty() && text.size() < 256 && std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) || c == '.' || c == ':' || c == '-' || c == '_' || c == '[' || c == ']';
  });
  if (!ok)
    throw InputError(fmt::format(
        "{} \"{}\" is not a host name, address or interface name; allowed: letters, digits and . : - _ [ ]",
        what, text));
}

bool is_ipv4(const std::string& text) {
  return std::ranges::count(text, '.') == 3 &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) || c == '.'; });
}

std::string interface_attribute(const std::string& interface) {
  if (interface.empty()) return fmt::format("name=\"{}\"", only_interface(network_interfaces()));
  require_address(interface, "interface");
  return fmt::format("{}=\"{}\"", is_ipv4(interface) ? "address" : "name", interface);
}

void append_peer(std::string& xml, const std::string& host, std::uint32_t port) {
  xml += fmt::format("<Peer Address=\"{}:{}\"/>", host, port);
}

/// Returns the peers as XML. A peer without a port is queried at the ports of all servers that fit on a host.
std::string peer_elements(const BusConfig& config, bool loopback) {
  if (config.end == BusEnd::server) return "";
  std::vector<std::string> peers = config.peers;
  if (peers.empty() && loopback) peers.emplace_back("127.0.0.1");
  std::string xml;
  for (const std::string& peer : peers) {
    require_address(peer, "peer");
    if (peer.find(':') != std::string::npos) {
      xml += fmt::format("<Peer Address=\"{}\"/>", peer);
    } else {
      for (std::uint32_t index = 0; index < servers_per_host; ++index)
        append_peer(xml, peer, server_port(config.domain, index));
    }
  }
  return xml;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

/// Removes XML comments, so that the one that explains the placeholders isn't filled in.
void remove_comments(std::string& xml) {
  for (std::size_t begin = xml.find("<!--"); begin != std::string::npos; begin = xml.find("<!--")) {
    const std::size_t end = xml.find("-->", begin);
    xml.erase(begin, end == std::string::npos ? end : end + 3 - begin);
  }
}

}  // namespace

std::string profile_xml(const BusConfig& config) {
  if (config.domain > max_domain)
    throw InputError(
        fmt::format("DDS domain {} is out of range; allowed: 0 to {}", config.domain, max_domain));
  if (config.server_index >= servers_per_host)
    throw InputError(fmt::format("server index {} is out of range; allowed: 0 to {}", config.server_index,
                                 servers_per_host - 1));
  std::string xml = read_profile(config.profile);
  remove_comments(xml);
  const bool loopback = config.profile.empty() || config.profile == "loopback";
  if (xml.find("@INTERFACE@") != std::string::npos)
    replace_all(xml, "@INTERFACE@", interface_attribute(config.interface));
  replace_all(xml, "@DOMAIN@", std::to_string(config.domain));
  replace_all(xml, "@INDEX@",
              config.end == BusEnd::server ? std::to_string(config.server_index) : std::string("none"));
  replace_all(xml, "@PEERS@", peer_elements(config, loopback));
  return xml;
}

}  // namespace prosector
