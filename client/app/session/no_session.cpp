#include "client/app/session/no_session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace prosector {
namespace {

std::string search_location(const BusConfig& config) {
  if (!config.peers.empty()) return fmt::format("queried {}", fmt::join(config.peers, ", "));
  if (config.profile.empty())
    return "searched this machine only (loopback); add a machine with --peer, or the local network with "
           "--lan";
  return fmt::format("searched with profile {}", config.profile);
}

}  // namespace

bool is_among(const BusConfig& config, std::span<const SessionInfo> found) {
  return std::ranges::find(found, config.session, &SessionInfo::session) != found.end();
}

std::string session_not_found_text(const BusConfig& config, std::chrono::milliseconds time_limit,
                                   std::span<const SessionInfo> found) {
  const double seconds = std::chrono::duration<double>(time_limit).count();
  if (is_among(config, found))
    return fmt::format(
        "session '{}' is running but did not answer within {:g} s: its server or the network is busy. Wait "
        "longer with --timeout {:g}",
        config.session, seconds, std::max(20., 4 * seconds));
  std::string others;
  for (const SessionInfo& s : found)
    others += fmt::format("{}'{}' (scene {})", others.empty() ? "" : ", ", s.session, s.scene);
  return fmt::format("no server found for session '{}' in DDS domain {}: {}. {}", config.session,
                     config.domain, search_location(config),
                     others.empty() ? "Start a server: prosector-server deploy/scenes/abdomen.toml"
                                    : "Running sessions: " + others + "; choose with --session");
}

}  // namespace prosector
