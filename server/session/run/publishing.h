#pragma once
// Shared by the loops that publish a running session and a recording.

#include <cstdint>
#include <iterator>
#include <vector>

#include "server/session/people/session.h"

namespace prosector {

inline constexpr std::int64_t second_ns = 1'000'000'000;

/// Moves the messages of `more` to the end of the list `out`.
inline void append(std::vector<Outgoing>& out, std::vector<Outgoing> more) {
  out.insert(out.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace prosector
