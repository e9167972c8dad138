#pragma once
// The number of a server run (SessionInfo::server_run). It decides between two runs that claim to host the
// same session: all participants that see both numbers reach the same decision.
//
// The number has three fields, from the most significant bits. 12 bits: reign, first_reign and one
// more each time the session's journal is continued. 35 bits: wall-clock start time, in units of 0.1 s.
// 17 bits: random.

#include <chrono>
#include <cstdint>

namespace prosector {

inline constexpr std::uint32_t first_reign = 1, last_reign = (1U << 12) - 1;

/// Returns the number that identifies a server run, composed of three fields: the reign, the start time and a
/// random number. The reign is 1 plus the number of times that the session's journal was continued. A reign
/// above last_reign is clamped to it.
std::uint64_t make_server_run(std::uint32_t reign, std::chrono::system_clock::time_point started,
                              std::uint32_t random);
/// Returns the number that identifies a server run that starts now. `reign` is 1 plus the number of times
/// that the session's journal was continued.
std::uint64_t make_server_run(std::uint32_t reign);

/// Returns whether server run `a` takes precedence over run `b` as host of their session. The run with the
/// later reign (more continuations of the journal) does, or else the one that started earlier.
bool precedes(std::uint64_t a, std::uint64_t b);

}  // namespace prosector
