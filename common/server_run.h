#pragma once
// The number that each run of a server has (SessionInfo::server_run). It decides between two runs that say
// they host one session: everyone who sees both numbers decides alike.
//
// From the top it holds three fields. 12 bits of reign count how often the session's journal was gone on
// with. 35 bits are the wall-clock time of the start, in 0.1 s. 17 bits are random.

#include <chrono>
#include <cstdint>

namespace prosector {

inline constexpr std::uint32_t first_reign = 1, last_reign = (1U << 12) - 1;

/// Makes a fresh number. A reign beyond the last counts as the last.
std::uint64_t make_server_run(std::uint32_t reign, std::chrono::system_clock::time_point started,
                              std::uint32_t random);
/// Makes the number of a run that starts now.
std::uint64_t make_server_run(std::uint32_t reign);

/// Tells whether run `a` hosts the session where `b` says so too: the later reign does, else who started
/// earlier.
bool precedes(std::uint64_t a, std::uint64_t b);

}  // namespace prosector
