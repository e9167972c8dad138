#include "server/session/people/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/assert.h"

namespace prosector {
namespace {

constexpr std::size_t most_ranges = 16;  // in a message to a user

}  // namespace

void Moments::keep(std::uint64_t tick, std::vector<Revision> revisions, std::vector<std::uint8_t> state) {
  PROSECTOR_ASSERT(moments_.empty() || moments_.back().tick <= tick);
  bytes_ += state.size();
  moments_.push_back(
      {tick, std::move(revisions), std::make_shared<const std::vector<std::uint8_t>>(std::move(state))});
  while (bytes_ > budget_ && moments_.size() > 2) thin_out();
}

/// Drops the state whose neighbours are closest to each other, relative to its age. The older states are, the
/// farther apart they stay.
void Moments::thin_out() {
  PROSECTOR_ASSERT(moments_.size() > 2);
  const std::uint64_t now = moments_.back().tick;
  const auto spacing = [&](std::size_t i) {
    const auto gap = static_cast<double>(moments_[i + 1].tick - moments_[i - 1].tick);
    return gap / static_cast<double>(now - moments_[i].tick + 1);
  };
  std::size_t densest = 1;
  for (std::size_t i = 2; i + 1 < moments_.size(); ++i)
    if (spacing(i) < spacing(densest)) densest = i;
  bytes_ -= moments_[densest].state->size();
  moments_.erase(moments_.begin() + static_cast<std::ptrdiff_t>(densest));
}

Moments::State Moments::find(BodyId body, std::uint32_t revision) const {
  for (const Moment& moment : moments_)
    for (const Revision& r : moment.revisions)
      if (r.body == body && r.revision == revision) return moment.state;
  return nullptr;
}

std::string Moments::kept(BodyId body) const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges;  // first, last
  for (const Moment& moment : moments_)
    for (const Revision& r : moment.revisions) {
      if (r.body != body) continue;
      if (!ranges.empty() && ranges.back().second + 1 == r.revision)
        ranges.back().second = r.revision;
      else
        ranges.emplace_back(r.revision, r.revision);
    }
  std::string out;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges.size() > most_ranges && i == 1) {  // the newest are the most useful
      i = ranges.size() - most_ranges + 1;
      out += ", …";
    }
    const auto [first, last] = ranges[i];
    out += i == 0 ? "" : i + 1 == ranges.size() ? " and " : ", ";
    out += first == last ? fmt::format("{}", first) : fmt::format("{} to {}", first, last);
  }
  return out.empty() ? "none" : out;
}

}  // namespace prosector
