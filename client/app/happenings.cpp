#include "client/app/happenings.h"

#include <fmt/format.h>

#include <algorithm>

namespace prosector {
namespace {

constexpr double stroke_seconds = 1;    // cuts of one body by one person so close together are one stroke
constexpr double trouble_seconds = 10;  // a trouble that was away for so long is news again
constexpr double calm_seconds = 3;      // without any: told to be over

std::string_view role_name(Role role) {
  switch (role) {
    case Role::observer:
      return "an observer";
    case Role::dissector:
      return "a dissector";
    case Role::host:
      return "the host";
  }
  return "somebody else";
}

std::string_view did(TopologyCause cause) {
  switch (cause) {
    case TopologyCause::cut:
      return "cut";
    case TopologyCause::undo:
      return "took back a cut of";
    case TopologyCause::rewind:
      return "rewound";
    case TopologyCause::compiled:
      break;
  }
  return "changed";
}

/// Returns a trouble without its figures, which change while it stays the same one.
std::string kind_of(std::string trouble) {
  std::erase_if(trouble, [](char c) { return c >= '0' && c <= '9'; });
  return trouble;
}

/// Returns the entries of a list that is told as one line: "liver reset: …, kidney …".
std::vector<std::string> entries_of(const std::string& list) {
  std::vector<std::string> out;
  for (std::size_t from = 0; from < list.size();) {
    const std::size_t comma = std::min(list.find("; ", from), list.size());
    out.push_back(list.substr(from, comma - from));
    from = comma + 2;
  }
  return out;
}

/// Returns what is worth a message of an entry: without solves that stopped early, which is everyday where
/// somebody touches and stands among the figures.
std::string worth_telling(const std::string& entry) {
  constexpr std::string_view everyday = " not converged";
  std::string out;
  for (std::size_t from = 0; from < entry.size();) {
    const std::size_t comma = std::min(entry.find(", ", from), entry.size());
    const std::string part = entry.substr(from, comma - from);
    if (!part.ends_with(everyday) && part != "…") out += (out.empty() ? "" : ", ") + part;
    from = comma + 2;
  }
  return out;
}

}  // namespace

std::vector<std::string> Happenings::look(const Replica& replica, double now) {
  std::vector<std::string> out;
  look_at_people(replica, out);
  look_at_time(replica, out);
  look_at_cuts(replica, now, out);
  if (!looked_) out.clear();
  look_at_troubles(replica, now, out);
  looked_ = true;
  return out;
}

void Happenings::look_at_people(const Replica& replica, std::vector<std::string>& out) {
  for (const auto& [who, entry] : replica.roster()) {
    const auto known = people_.find(who);
    if (known == people_.end() && who != self_)
      out.push_back(fmt::format("{} joined as {}", entry.name, role_name(entry.role)));
    else if (known != people_.end() && who != self_ && known->second.role != entry.role)
      out.push_back(fmt::format("{} is {} now", entry.name, role_name(entry.role)));
  }
  for (const auto& [who, entry] : people_)
    if (who != self_ && !replica.roster().contains(who)) out.push_back(entry.name + " left");
  people_ = replica.roster();
}

void Happenings::look_at_time(const Replica& replica, std::vector<std::string>& out) {
  if (replica.pace() == pace_) return;
  pace_ = replica.pace();
  if (replica.recording()) return;  // its bar tells
  if (pace_ == 0)
    out.push_back("the host stopped time");
  else
    out.push_back(pace_ == 1 ? "time goes on" : fmt::format("slow motion: {:g} of real time", pace_));
}

void Happenings::look_at_cuts(const Replica& replica, double now, std::vector<std::string>& out) {
  if (!replica.scene()) return;
  const auto& bodies = replica.scene()->bodies;
  for (BodyId body = 0; body < bodies.size(); ++body) {
    const TopologyRevision* newest = replica.topology(body);
    if (newest == nullptr) continue;
    const auto [entry, is_new] = topologies_.try_emplace(body);
    Seen& seen = entry->second;
    if (is_new && newest->piece_of >= 0 && static_cast<std::size_t>(newest->piece_of) < bodies.size())
      out.push_back(
          fmt::format("a piece came off the {}", bodies[static_cast<std::size_t>(newest->piece_of)].name));
    const bool changed = !is_new && newest->revision != seen.revision;
    const bool same_stroke = newest->cause == TopologyCause::cut && seen.cause == TopologyCause::cut &&
                             newest->author == seen.author && now - seen.told < stroke_seconds;
    const bool sought = replica.recording() && newest->cause == TopologyCause::rewind && newest->author == 0;
    if (changed && newest->cause != TopologyCause::compiled && !same_stroke && !sought)
      out.push_back(fmt::format("{} {} the {}", name_of(replica, newest->author), did(newest->cause),
                                bodies[body].name));
    if (is_new || changed) seen = {newest->revision, newest->cause, newest->author, now};
  }
}

void Happenings::look_at_troubles(const Replica& replica, double now, std::vector<std::string>& out) {
  if (!replica.status()) return;
  const std::vector<std::string> entries = entries_of(replica.status()->degraded);
  for (const std::string& entry : entries) {
    const std::string trouble = worth_telling(entry);
    if (trouble.empty()) continue;
    const auto [known, is_new] = troubles_.try_emplace(kind_of(trouble), now);
    if (is_new) out.push_back(trouble);
    known->second = now;
  }
  std::erase_if(troubles_, [&](const auto& t) { return now - t.second > trouble_seconds; });
  const bool recent =
      std::ranges::any_of(troubles_, [&](const auto& t) { return now - t.second < calm_seconds; });
  if (in_trouble_ && !recent) out.push_back("the simulation is well again");
  in_trouble_ = recent;
}

std::string Happenings::name_of(const Replica& replica, ParticipantId who) const {
  if (who == self_) return "you";
  const auto found = replica.roster().find(who);
  return found == replica.roster().end() ? "somebody who left" : found->second.name;
}

}  // namespace prosector
