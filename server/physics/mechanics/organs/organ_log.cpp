#include "server/physics/mechanics/organs/organ_log.h"

#include <fmt/format.h>

#include <algorithm>

namespace prosector::organs {
namespace {

bool in_force(const OrganChange& change) {
  return change.cause == TopologyCause::cut && !change.taken_back;
}

bool meet(const std::vector<cutting::TetId>& a, const std::vector<cutting::TetId>& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i == *j) return true;
    *i < *j ? ++i : ++j;
  }
  return false;
}

}  // namespace

std::vector<OrganChange*> stroke_of(OrganLog& log, ParticipantId author) {
  std::vector<OrganChange*> out;
  for (auto change = log.rbegin(); change != log.rend(); ++change) {
    if (!in_force(*change) || change->author != author) continue;
    if (!out.empty() && out.front()->stroke != change->stroke) break;
    out.push_back(&*change);
  }
  return out;
}

std::optional<std::uint64_t> last_stroke(const OrganLog& log, ParticipantId author) {
  for (auto change = log.rbegin(); change != log.rend(); ++change)
    if (in_force(*change) && change->author == author) return change->stroke;
  return std::nullopt;
}

Refusal why_not_undone(const OrganLog& log, std::span<OrganChange* const> stroke) {
  for (const OrganChange* change : stroke)
    for (const OrganChange& later : log) {
      if (&later <= change || !in_force(later)) continue;
      if (later.stroke == change->stroke && later.author == change->author) continue;
      if (meet(change->touched, later.touched))
        return fmt::format("your last cut cannot be undone: cut {} depends on it, undo that one first",
                           later.stroke);
    }
  return {};
}

bool is_uncut(const OrganLog& log) {
  return std::none_of(log.begin(), log.end(), in_force);
}

bool begins_with(const OrganLog& log, const OrganLog& start) {
  return start.size() <= log.size() &&
         std::equal(start.begin(), start.end(), log.begin(), [](const OrganChange& a, const OrganChange& b) {
           return a.cause == b.cause && a.author == b.author && a.stroke == b.stroke && a.ops == b.ops;
         });
}

}  // namespace prosector::organs
