#include "client/app/terminal/cut_list.h"

#include <fmt/format.h>

namespace prosector {
namespace {

std::string_view done(TopologyCause cause) {
  switch (cause) {
    case TopologyCause::compiled:
      return "made";
    case TopologyCause::cut:
      return "cut";
    case TopologyCause::undo:
      return "undone";
    case TopologyCause::rewind:
      return "rewound";
  }
  return "changed";
}

std::string by(ParticipantId author, const std::map<ParticipantId, RosterEntry>& roster) {
  if (author == 0) return "";
  const auto found = roster.find(author);
  return " by " + (found == roster.end() ? "a participant who left" : found->second.name);
}

}  // namespace

std::string cut_list_text(const SceneInfo& scene, const std::map<ParticipantId, RosterEntry>& roster,
                          double tick_seconds, const std::function<const TopologyRevision*(BodyId)>& shown) {
  std::string out;
  for (BodyId body = 0; body < scene.bodies.size(); ++body) {
    const TopologyRevision* newest = shown(body);
    if (newest == nullptr || (newest->revision == 0 && newest->piece_of < 0)) continue;
    out += fmt::format("{}{}: revision {}, {}{} {:.1f} s into the session", out.empty() ? "" : "\n",
                       scene.bodies[body].name, newest->revision, done(newest->cause),
                       by(newest->author, roster), tick_seconds * static_cast<double>(newest->time.tick));
  }
  return out.empty() ? "nothing has been cut" : out;
}

}  // namespace prosector
