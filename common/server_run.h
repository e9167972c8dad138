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

/// Makes the number from its fields. A reign above last_reign is clamped to it.
std::uint64_t make_server_run(std::uint32_t reign, std::chrono::system_clock::time_point started,
                              std::uint32_t random);
/// Makes the number of a run that starts now.
std::uint64_t make_server_run(std::uint32_t reign);

/// Returns whether run `a` takes precedence over run `b` as host of the session: the one with the later
/// reign, else the one that started earlier.
bool precedes(std::uint64_t a, std::uint64_t b);

}  // namespace prosector
