#include "client/app/no_session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace prosector {
namespace {

std::string where_we_looked(const BusConfig& config) {
  if (!config.peers.empty()) return fmt::format("asked {}", fmt::join(config.peers, ", "));
  if (config.profile.empty())
    return "looked on this machine only (loopback); name a machine with --peer, or a network with --lan";
  return fmt::format("looked where {} says", config.profile);
}

}  // namespace

bool is_among(const BusConfig& config, std::span<const SessionInfo> found) {
  return std::ranges::find(found, config.session, &SessionInfo::session) != found.end();
}

std::string no_session_text(const BusConfig& config, std::chrono::milliseconds patience,
                            std::span<const SessionInfo> found) {
  const double seconds = std::chrono::duration<double>(patience).count();
  if (is_among(config, found))
    return fmt::format(
        "session '{}' runs, but did not answer within {:g} s: its server or the network is busy. "
        "Wait for longer: --patience {:g}",
        config.session, seconds, std::max(20., 4 * seconds));
  std::string others;
  for (const SessionInfo& s : found)
    others += fmt::format("{}'{}' (scene {})", others.empty() ? "" : ", ", s.session, s.scene);
  return fmt::format("no server found for session '{}' in domain {}: {}. {}", config.session, config.domain,
                     where_we_looked(config),
                     others.empty() ? "Start one: prosector-server deploy/scenes/abdomen.toml"
                                    : "Sessions that do run: " + others + "; choose with --session");
}

}  // namespace prosector
