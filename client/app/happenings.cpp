#include "client/app/happenings.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "common/repeated_lines.h"

namespace prosector {
namespace {

constexpr double trouble_seconds = 10;     // a trouble that was away for so long may be news again …
constexpr double trouble_interval = 60;    // … so long after it was told, s
constexpr double forgotten_seconds = 120;  // since the server had it
constexpr double hardly_slower = 0.9;      // of real time
constexpr double calm_seconds = 3;         // without any: told to be over

const char* role_name(Role role) {
  switch (role) {
    case Role::observer:
      return msg("an observer");
    case Role::dissector:
      return msg("a dissector");
    case Role::host:
      return msg("the host");
  }
  return msg("somebody else");
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

// How the server says at what share of real time it simulates.
constexpr std::string_view slowed = "simulated time slowed to ", of_real_time = " of real time";

/// Returns a trouble of the server's in the user's language, where it has one.
std::string told_in(const Catalogue& words, const std::string& trouble) {
  if (!trouble.starts_with(slowed) || !trouble.ends_with(of_real_time)) return words.tr(trouble);
  const std::size_t digits = trouble.size() - slowed.size() - of_real_time.size();
  return words.tr("simulated time slowed to {} of real time", trouble.substr(slowed.size(), digits));
}

/// Tells whether a trouble is everyday where somebody touches, and stands among the figures: a solve that
/// stopped early, and time that is hardly slower than real time.
bool is_everyday(const std::string& part) {
  constexpr std::string_view early = " not converged";
  if (part.starts_with(slowed)) return std::strtod(part.c_str() + slowed.size(), nullptr) >= hardly_slower;
  return part.ends_with(early) || part == "…";
}

/// Returns what is worth a message of an entry.
std::string worth_telling(const std::string& entry) {
  std::string out;
  for (std::size_t from = 0; from < entry.size();) {
    const std::size_t comma = std::min(entry.find(", ", from), entry.size());
    const std::string part = entry.substr(from, comma - from);
    if (!is_everyday(part)) out += (out.empty() ? "" : ", ") + part;
    from = comma + 2;
  }
  return out;
}

}  // namespace

std::vector<Happening> Happenings::look(const Replica& replica, double now) {
  std::vector<Happening> out;
  look_at_people(replica, out);
  look_at_time(replica, out);
  look_at_hands(replica, out);
  look_at_cuts(replica, now, out);
  look_at_strokes(replica, now, out);
  if (!looked_) out.clear();
  look_at_troubles(replica, now, out);
  looked_ = true;
  return out;
}

void Happenings::look_at_people(const Replica& replica, std::vector<Happening>& out) {
  for (const auto& [who, entry] : replica.roster()) {
    const auto known = people_.find(who);
    if (known == people_.end() && who != self_)
      out.push_back({words_.tr("{} joined as {}", entry.name, words_.tr(role_name(entry.role)))});
    else if (known != people_.end() && who != self_ && known->second.role != entry.role)
      out.push_back({words_.tr("{} is {} now", entry.name, words_.tr(role_name(entry.role)))});
  }
  for (const auto& [who, entry] : people_)
    if (who != self_ && !replica.roster().contains(who)) out.push_back({words_.tr("{} left", entry.name)});
  people_ = replica.roster();
}

void Happenings::look_at_time(const Replica& replica, std::vector<Happening>& out) {
  if (replica.pace() == pace_) return;
  pace_ = replica.pace();
  if (replica.recording()) return;  // its bar tells
  if (pace_ == 0)
    out.push_back({words_.tr("the host stopped time")});
  else
    out.push_back({pace_ == 1 ? std::string(words_.tr("time goes on"))
                              : words_.tr("slow motion: {:g} of real time", pace_)});
}

void Happenings::look_at_hands(const Replica& replica, std::vector<Happening>& out) {
  if (!replica.scene()) return;
  const auto is_own = [&](const HandRef& hand) { return hand.participant == self_; };
  std::set<BodyId> held;
  for (BodyId body = 0; body < replica.scene()->bodies.size(); ++body)
    if (const PartState* part = replica.part(body);
        part != nullptr && std::ranges::any_of(part->holders, is_own)) {
      held.insert(body);
      if (!held_.contains(body))
        out.push_back({words_.tr("you hold the {}", replica.scene()->bodies[body].name), MessageKind::own});
    }
  held_ = std::move(held);
}

void Happenings::look_at_cuts(const Replica& replica, double now, std::vector<Happening>& out) {
  if (!replica.scene()) return;
  const auto& bodies = replica.scene()->bodies;
  for (BodyId body = 0; body < bodies.size(); ++body) {
    const TopologyRevision* newest = replica.topology(body);
    if (newest == nullptr) continue;
    const auto [entry, is_new] = topologies_.try_emplace(body);
    Seen& seen = entry->second;
    if (is_new && newest->piece_of >= 0 && static_cast<std::size_t>(newest->piece_of) < bodies.size())
      out.push_back(
          {words_.tr("a piece came off the {}", bodies[static_cast<std::size_t>(newest->piece_of)].name)});
    const bool changed = !is_new && newest->revision != seen.revision;
    const bool same_stroke = newest->cause == TopologyCause::cut && seen.cause == TopologyCause::cut &&
                             newest->author == seen.author && now - seen.told < StrokeGauge::stroke_seconds;
    const bool sought = replica.recording() && newest->cause == TopologyCause::rewind && newest->author == 0;
    if (changed && newest->cause != TopologyCause::compiled && !same_stroke && !sought)
      out.push_back({told_change(replica, *newest, bodies[body].name), kind_of(newest->author)});
    if (is_new || changed) seen = {newest->revision, newest->cause, newest->author, now};
  }
}

void Happenings::look_at_strokes(const Replica& replica, double now, std::vector<Happening>& out) {
  strokes_.look(replica, now);
  for (const StrokeFigures& stroke : strokes_.take_ended()) {
    const std::string figures = in_words(stroke, words_);
    const std::string& organ = replica.scene()->bodies[stroke.organ].name;
    out.push_back({stroke.author == self_ ? words_.tr("cut: {}, in the {}", figures, organ)
                                          : words_.tr("{}'s cut: {}, in the {}",
                                                      name_of(replica, stroke.author), figures, organ),
                   kind_of(stroke.author)});
  }
}

void Happenings::look_at_troubles(const Replica& replica, double now, std::vector<Happening>& out) {
  if (!replica.status()) return;
  for (const std::string& entry : entries_of(replica.status()->degraded)) {
    const std::string trouble = worth_telling(entry);
    if (trouble.empty()) continue;
    const auto [known, is_new] = troubles_.try_emplace(line_kind(trouble), Trouble{now, now});
    Trouble& t = known->second;
    const bool is_back = now - t.last > trouble_seconds && now - t.told > trouble_interval;
    if (is_new || is_back) {
      out.push_back({told_in(words_, trouble)});
      t.told = now;
      told_of_trouble_ = true;
    }
    t.last = now;
  }
  std::erase_if(troubles_, [&](const auto& t) { return now - t.second.last > forgotten_seconds; });
  const bool recent =
      std::ranges::any_of(troubles_, [&](const auto& t) { return now - t.second.last < calm_seconds; });
  if (!told_of_trouble_ || recent) return;
  out.push_back({words_.tr("the simulation is well again")});
  told_of_trouble_ = false;
}

/// Says who changed a part, and how.
std::string Happenings::told_change(const Replica& replica, const TopologyRevision& revision,
                                    const std::string& part) const {
  const bool own = revision.author == self_;
  const std::string who = name_of(replica, revision.author);
  switch (revision.cause) {
    case TopologyCause::cut:
      return own ? words_.tr("you cut the {}", part) : words_.tr("{} cut the {}", who, part);
    case TopologyCause::undo:
      return own ? words_.tr("you took back a cut of the {}", part)
                 : words_.tr("{} took back a cut of the {}", who, part);
    case TopologyCause::rewind:
      return own ? words_.tr("you rewound the {}", part) : words_.tr("{} rewound the {}", who, part);
    case TopologyCause::compiled:
      break;
  }
  return own ? words_.tr("you changed the {}", part) : words_.tr("{} changed the {}", who, part);
}

std::string Happenings::name_of(const Replica& replica, ParticipantId who) const {
  const auto found = replica.roster().find(who);
  return found == replica.roster().end() ? words_.tr("somebody who left") : found->second.name;
}

}  // namespace prosector
