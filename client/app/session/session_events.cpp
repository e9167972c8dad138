#include "client/app/session/session_events.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "common/repeated_line_filter.h"

namespace prosector {
namespace {

constexpr double problem_absence = 10;  // s: a problem that was absent for this long may be reported again …
constexpr double problem_repeat_interval = 60;  // … if its last report is this long ago, s
constexpr double problem_memory = 120;          // s since the server last reported it; then it is removed
constexpr double min_normal_pace = 0.9;         // ratio of simulated to real time
constexpr double problem_end_delay = 3;         // s without any problem, after which the end is reported

const char* role_name(Role role) {
  switch (role) {
    case Role::observer:
      return msg("an observer");
    case Role::dissector:
      return msg("a dissector");
    case Role::host:
      return msg("the host");
  }
  return msg("someone else");
}

/// Splits the server's list into its entries: "liver reset: …; kidney …".
std::vector<std::string> entries_of(const std::string& list) {
  std::vector<std::string> out;
  for (std::size_t from = 0; from < list.size();) {
    const std::size_t comma = std::min(list.find("; ", from), list.size());
    out.push_back(list.substr(from, comma - from));
    from = comma + 2;
  }
  return out;
}

// Format of the server's message about slow simulation.
constexpr std::string_view slowed = "simulated time slowed to ", of_real_time = " of real time";

/// Returns the translation of a server's problem message, or the message itself if there is none.
std::string translated_problem(const Catalogue& words, const std::string& problem) {
  if (!problem.starts_with(slowed) || !problem.ends_with(of_real_time)) return words.tr(problem);
  const std::size_t digits = problem.size() - slowed.size() - of_real_time.size();
  return words.tr("simulated time slowed to {} of real time", problem.substr(slowed.size(), digits));
}

/// Reports whether a problem is common during contact and shown in the statistics only: a solve that did not
/// converge, or simulated time at 0.9 of real time or faster.
bool is_common_problem(const std::string& part) {
  constexpr std::string_view early = " not converged";
  if (part.starts_with(slowed)) return std::strtod(part.c_str() + slowed.size(), nullptr) >= min_normal_pace;
  return part.ends_with(early) || part == "…";
}

/// Returns an entry without its common problems.
std::string uncommon_problems(const std::string& entry) {
  std::string out;
  for (std::size_t from = 0; from < entry.size();) {
    const std::size_t comma = std::min(entry.find(", ", from), entry.size());
    const std::string part = entry.substr(from, comma - from);
    if (!is_common_problem(part)) out += (out.empty() ? "" : ", ") + part;
    from = comma + 2;
  }
  return out;
}

}  // namespace

std::vector<SessionMessage> SessionEvents::look(const Replica& replica, double now) {
  std::vector<SessionMessage> out;
  report_participants(replica, out);
  report_pace(replica, out);
  report_grasps(replica, out);
  report_topology(replica, now, out);
  report_strokes(replica, now, out);
  if (!looked_) out.clear();
  report_problems(replica, now, out);
  looked_ = true;
  return out;
}

void SessionEvents::report_participants(const Replica& replica, std::vector<SessionMessage>& out) {
  for (const auto& [who, entry] : replica.roster()) {
    const auto known = people_.find(who);
    if (known == people_.end() && who != self_)
      out.push_back({words_.tr("{} joined as {}", entry.name, words_.tr(role_name(entry.role)))});
    else if (known != people_.end() && who != self_ && known->second.role != entry.role)
      out.push_back({words_.tr("{} is now {}", entry.name, words_.tr(role_name(entry.role)))});
  }
  for (const auto& [who, entry] : people_)
    if (who != self_ && !replica.roster().contains(who)) out.push_back({words_.tr("{} left", entry.name)});
  people_ = replica.roster();
}

void SessionEvents::report_pace(const Replica& replica, std::vector<SessionMessage>& out) {
  if (replica.time().pace() == pace_) return;
  pace_ = replica.time().pace();
  if (replica.recording()) return;  // the playback bar shows it
  if (pace_ == 0)
    out.push_back({words_.tr("the host stopped time")});
  else
    out.push_back({pace_ == 1 ? std::string(words_.tr("time resumed"))
                              : words_.tr("slow motion: time runs at {:g} of real time", pace_)});
}

void SessionEvents::report_grasps(const Replica& replica, std::vector<SessionMessage>& out) {
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

void SessionEvents::report_topology(const Replica& replica, double now, std::vector<SessionMessage>& out) {
  if (!replica.scene()) return;
  const auto& bodies = replica.scene()->bodies;
  for (BodyId body = 0; body < bodies.size(); ++body) {
    const TopologyRevision* newest = replica.bodies().topology(body);
    if (newest == nullptr) continue;
    const auto [entry, is_new] = topologies_.try_emplace(body);
    Seen& seen = entry->second;
    if (is_new && newest->piece_of >= 0 && static_cast<std::size_t>(newest->piece_of) < bodies.size())
      out.push_back({words_.tr("a piece was separated from the {}",
                               bodies[static_cast<std::size_t>(newest->piece_of)].name)});
    const bool changed = !is_new && newest->revision != seen.revision;
    const bool same_stroke = newest->cause == TopologyCause::cut && seen.cause == TopologyCause::cut &&
                             newest->author == seen.author &&
                             now - seen.reported < StrokeTracker::stroke_seconds;
    const bool sought = replica.recording() && newest->cause == TopologyCause::rewind && newest->author == 0;
    if (changed && newest->cause != TopologyCause::compiled && !same_stroke && !sought)
      out.push_back({change_message(replica, *newest, bodies[body].name), kind_of(newest->author)});
    if (is_new || changed) seen = {newest->revision, newest->cause, newest->author, now};
  }
}

void SessionEvents::report_strokes(const Replica& replica, double now, std::vector<SessionMessage>& out) {
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

void SessionEvents::report_problems(const Replica& replica, double now, std::vector<SessionMessage>& out) {
  if (!replica.status()) return;
  for (const std::string& entry : entries_of(replica.status()->degraded)) {
    const std::string problem = uncommon_problems(entry);
    if (problem.empty()) continue;
    const auto [known, is_new] = problems_.try_emplace(line_kind(problem), Problem{now, now});
    Problem& t = known->second;
    const bool is_back = now - t.last > problem_absence && now - t.reported > problem_repeat_interval;
    if (is_new || is_back) {
      out.push_back({translated_problem(words_, problem)});
      t.reported = now;
      problem_reported_ = true;
    }
    t.last = now;
  }
  std::erase_if(problems_, [&](const auto& t) { return now - t.second.last > problem_memory; });
  const bool recent =
      std::ranges::any_of(problems_, [&](const auto& t) { return now - t.second.last < problem_end_delay; });
  if (!problem_reported_ || recent) return;
  out.push_back({words_.tr("the simulation has recovered")});
  problem_reported_ = false;
}

/// Returns a message on the author and the kind of a topology change.
std::string SessionEvents::change_message(const Replica& replica, const TopologyRevision& revision,
                                          const std::string& part) const {
  const bool own = revision.author == self_;
  const std::string who = name_of(replica, revision.author);
  switch (revision.cause) {
    case TopologyCause::cut:
      return own ? words_.tr("you cut the {}", part) : words_.tr("{} cut the {}", who, part);
    case TopologyCause::undo:
      return own ? words_.tr("you undid a cut of the {}", part)
                 : words_.tr("{} undid a cut of the {}", who, part);
    case TopologyCause::rewind:
      return own ? words_.tr("you rewound the {}", part) : words_.tr("{} rewound the {}", who, part);
    case TopologyCause::compiled:
      break;
  }
  return own ? words_.tr("you changed the {}", part) : words_.tr("{} changed the {}", who, part);
}

std::string SessionEvents::name_of(const Replica& replica, ParticipantId who) const {
  const auto found = replica.roster().find(who);
  return found == replica.roster().end() ? words_.tr("a participant who left") : found->second.name;
}

}  // namespace prosector
