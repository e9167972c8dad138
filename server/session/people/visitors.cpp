#include "server/session/people/visitors.h"

#include "common/assert.h"

namespace prosector {
namespace {

// Limits memory, since any process can become a visitor.
constexpr std::size_t max_visitors = 1024;

}  // namespace

Visitor* Visitors::admit(ParticipantId id, std::uint64_t writer, std::uint64_t tick, const char* what,
                         SessionOutput& output) {
  if (id == 0) {
    output.drop("participant id 0");
    return nullptr;
  }
  auto it = visitors_.find(id);
  if (it == visitors_.end()) {
    if (visitors_.size() >= max_visitors) {
      output.drop("too many visitors");
      return nullptr;
    }
    it = visitors_.emplace(id, Visitor{}).first;
    it->second.writer = writer;
  } else if (it->second.writer != writer) {
    output.drop(what);
    return nullptr;
  }
  it->second.seen = tick;
  return &it->second;
}

Visitor* Visitors::find(ParticipantId id) {
  const auto it = visitors_.find(id);
  return it == visitors_.end() ? nullptr : &it->second;
}

void Visitors::forget_silent(std::uint64_t tick, std::uint64_t ticks) {
  PROSECTOR_ASSERT(visitors_.size() <= max_visitors && !visitors_.contains(0));
  if (visitors_.size() < max_visitors / 2) return;
  std::erase_if(visitors_, [&](const auto& v) { return tick - v.second.seen > ticks; });
}

}  // namespace prosector
