#pragma once
// Work in parallel whose results don't depend on how many threads did it. All of it goes through here.

#include <algorithm>
#include <cstddef>

#include "common/assert.h"
#include "server/physics/base/fork_join.h"

namespace prosector {

/// Returns the number of chunks of at most `chunk` items into which parallel_chunks() divides n items.
constexpr std::size_t chunk_count(std::size_t n, std::size_t chunk) {
  return (n + chunk - 1) / chunk;
}

/// Calls f(begin, end, chunk_index) for fixed ranges of `chunk` items of [0, n). The ranges depend on n and
/// `chunk` only. Results are bitwise equal for any number of threads if f writes only its own items. The same
/// holds if f sums within a chunk and the caller then sums over the chunks in order. Runs in the caller's
/// tbb::task_arena and within tbb's global limits.
template <class F>
void parallel_chunks(std::size_t n, std::size_t chunk, const F& f) {
  PROSECTOR_ASSERT(chunk > 0);
  const std::size_t chunks = chunk_count(n, chunk);
  const auto run = [&](std::size_t c) { f(c * chunk, std::min(n, (c + 1) * chunk), c); };
  if (chunks <= 1) {
    if (chunks == 1) run(0);
    return;
  }
  fork_join::ranges(chunks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c != end; ++c) run(c);
  });
}

/// Number of short chunks up to which the calling thread alone is faster. Waking another one takes a few µs.
inline constexpr std::size_t few_chunks = 4;

/// Does the same as parallel_chunks(), with equal results, for loops that take a few µs per chunk. Uses other
/// threads only for more than few_chunks chunks.
template <class F>
void parallel_short_chunks(std::size_t n, std::size_t chunk, const F& f) {
  PROSECTOR_ASSERT(chunk > 0);
  if (chunk_count(n, chunk) > few_chunks) {
    parallel_chunks(n, chunk, f);
    return;
  }
  for (std::size_t c = 0; c * chunk < n; ++c) f(c * chunk, std::min(n, (c + 1) * chunk), c);
}

/// Calls f(i) for each i of [0, n) in parallel and waits for all calls. It is meant for calls that each take
/// long, since each may become a separate task.
template <class F>
void parallel_each(std::size_t n, const F& f) {
  fork_join::ranges(n, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i) f(i);
  });
}

/// Calls f() and g(), in parallel if a thread is free, and waits for both.
template <class F, class G>
void parallel_both(const F& f, const G& g) {
  fork_join::both(f, g);
}

}  // namespace prosector
