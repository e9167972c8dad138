#include "client/setup/session_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "common/error.h"
#include "common/role_words.h"
#include "idl/cyclone_bus.h"

namespace prosector {
namespace {

constexpr std::chrono::milliseconds listening{600}, asking{400}, resting{1500};

/// Returns the users in a session, by receiving from its server for a moment.
std::vector<std::string> users_in_session(BusConfig where, const std::string& session) {
  where.end = BusEnd::observer;
  where.session = session;
  const auto bus = make_cyclone_bus(where);
  std::map<ParticipantId, RosterEntry> roster;
  std::vector<Received> received;
  const auto end = std::chrono::steady_clock::now() + asking;
  while (std::chrono::steady_clock::now() < end) {
    bus->wait(std::chrono::milliseconds(50));
    bus->take(received);
    for (const Received& r : received) {
      const auto* entry = std::get_if<RosterEntry>(&r.message);
      if (entry == nullptr) continue;
      if (r.liveness == Liveness::alive)
        roster[entry->participant] = *entry;
      else
        roster.erase(entry->participant);
    }
  }
  std::vector<std::string> out;
  for (const auto& [id, entry] : roster)
    out.push_back(fmt::format("{} ({})", entry.name, role_word(entry.role)));
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

SessionSearch::SessionSearch(const BusConfig& where) : where_(where) {
  thread_ = std::jthread([this](std::stop_token stop) { run(std::move(stop)); });
}

SessionSearch::~SessionSearch() {
  thread_.request_stop();
  changed_.notify_all();
}

void SessionSearch::search(const BusConfig& where) {
  const std::lock_guard lock(mutex_);
  where_ = where;
  result_ = {};
  ++asked_;
  changed_.notify_all();
}

SearchResult SessionSearch::result() const {
  const std::lock_guard lock(mutex_);
  return result_;
}

void SessionSearch::run(std::stop_token stop) {
  while (!stop.stop_requested()) {
    BusConfig where;
    std::uint64_t asked = 0;
    {
      const std::lock_guard lock(mutex_);
      where = where_;
      asked = asked_;
    }
    SearchResult found;
    try {
      for (SessionInfo& info : list_sessions(where, listening)) {
        FoundSession& session = found.sessions.emplace_back();
        session.info = std::move(info);
        if (session.speaks_our_version() && !stop.stop_requested())
          session.people = users_in_session(where, session.info.session);
      }
    } catch (const InputError& error) {
      found.problem = error.what();
    }
    std::unique_lock lock(mutex_);
    if (asked != asked_) continue;
    found.rounds = result_.rounds + 1;
    result_ = std::move(found);
    changed_.wait_for(lock, stop, resting, [&] { return asked != asked_; });
  }
}

}  // namespace prosector
