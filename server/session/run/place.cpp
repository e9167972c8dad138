#include "server/session/run/place.h"

#include <fmt/format.h>

#include <chrono>

#include "common/error.h"
#include "idl/cyclone_bus.h"

namespace prosector {
namespace {

constexpr std::chrono::milliseconds time_to_find{600};  // a running server is discovered in half of that time
constexpr std::chrono::seconds time_to_yield{10};       // time to discover servers that started together

/// Returns settings with the first free server index of this host, after making sure that no other server
/// hosts this session.
BusConfig find_place(const ServerOptions& options, const std::string& session,
                     const HostConflictMonitor& watch) {
  if (const auto other = watch.other(time_to_find))
    throw InputError(
        fmt::format("session \"{}\" is already hosted by another server (scene {}): join it, or choose "
                    "another name with --session",
                    session, other->scene));
  BusConfig config = options.bus();
  config.session = session;
  const auto index = options.index ? options.index : find_free_server_index(config);
  if (!index)
    throw InputError("all ten server indices of this host are in use: end a server, or use another --domain");
  config.server_index = *index;
  return config;
}

/// Returns the options that a client needs besides the session's name.
std::string more_words(const BusConfig& config) {
  std::string more = config.domain != 0 ? fmt::format(" --domain {}", config.domain) : "";
  if (config.profile == "lan") more += " --lan";
  if (config.profile == "wan") more += " --profile wan --lan --peer THIS_HOST";
  return more;
}

std::string is_open(const BusConfig& config) {
  const bool here = config.profile.empty() || config.profile == "loopback";
  return fmt::format("session \"{}\" is open {} (UDP port {})", config.session,
                     here ? "on this machine" : "on the network",
                     7410 + 250 * config.domain + 2 * config.server_index);
}

std::string to_watch(const BusConfig& config) {
  return fmt::format("  observe:      prosector-client observe --session {}{}", config.session,
                     more_words(config));
}

}  // namespace

std::unique_ptr<HostConflictMonitor> watch_for_others(const ServerOptions& options,
                                                      const std::string& session) {
  BusConfig config = options.bus();
  config.session = session;
  config.end = BusEnd::observer;
  return std::make_unique<HostConflictMonitor>(config);
}

// Another server may take the index between finding and opening it; then the next one is tried.
std::unique_ptr<Bus> open_bus(const ServerOptions& options, const std::string& session,
                              const HostConflictMonitor& watch, BusConfig& place) {
  constexpr int tries = 3;
  for (int left = tries - 1;; --left) {
    place = find_place(options, session, watch);
    try {
      return make_cyclone_bus(place);
    } catch (const InputError&) {
      if (options.index || left == 0) throw;
    }
  }
}

void guard_place(HostConflictMonitor& watch, std::uint64_t server_run,
                 const std::function<void(const SessionInfo& other)>& yield) {
  watch.guard(server_run, time_to_yield, yield);
}

void refuse_for(const SessionInfo& rival, const std::string& session) {
  throw InputError(
      fmt::format("another server started session \"{}\" at the same time and hosts it (scene {}): this one "
                  "exits; join it, or choose another name with --session",
                  session, rival.scene));
}

std::string how_to_join(const BusConfig& config) {
  return fmt::format("{}\n  participate:  prosector-client join --session {} --name NAME{}\n{}",
                     is_open(config), config.session, more_words(config), to_watch(config));
}

std::string how_to_watch(const BusConfig& config) {
  return fmt::format("{}\n{}\nplayback starts when the first client joins", is_open(config),
                     to_watch(config));
}

}  // namespace prosector
