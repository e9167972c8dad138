#pragma once
// The one place that knows what runs tasks: TBB. Under the thread sanitizer threads of our own take its
// place: Debian's TBB isn't built with the sanitizer, which then takes all that TBB orders for races.

#ifdef __SANITIZE_THREAD__
#include <tbb/task_arena.h>

#include <exception>
#include <thread>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/partitioner.h>
#endif

#include <algorithm>
#include <cstddef>

namespace prosector::fork_join {

#ifdef __SANITIZE_THREAD__

/// Calls f(begin, end) for ranges that together cover [0, n), each on a separate thread, and waits for all.
/// If ranges threw exceptions, rethrows that of the first such range.
template <class F>
void ranges(std::size_t n, const F& f) {
  const auto arena = static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
  const std::size_t threads = std::min(n, arena);
  if (threads <= 1) {
    if (n > 0) f(std::size_t{0}, n);
    return;
  }
  std::vector<std::exception_ptr> thrown(threads);
  const auto run = [&](std::size_t t) {
    try {
      f(n * t / threads, n * (t + 1) / threads);
    } catch (...) {
      thrown[t] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < threads; ++t) others.emplace_back(run, t);
    run(0);
  }
  for (const std::exception_ptr& e : thrown)
    if (e) std::rethrow_exception(e);
}

/// Calls f() and g() on separate threads, if the task arena has more than one, and waits for both.
template <class F, class G>
void both(const F& f, const G& g) {
  ranges(2, [&](std::size_t begin, std::size_t end) {
    if (begin == 0) f();
    if (end == 2) g();
  });
}

#else

/// Calls f(begin, end) for ranges that together cover [0, n), in parallel, and waits for all. If calls threw
/// exceptions, rethrows one of them.
template <class F>
void ranges(std::size_t n, const F& f) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, n),
      [&](const tbb::blocked_range<std::size_t>& range) { f(range.begin(), range.end()); },
      tbb::auto_partitioner());
}

/// Calls f() and g(), in parallel if a thread is free, and waits for both.
template <class F, class G>
void both(const F& f, const G& g) {
  tbb::parallel_invoke([&] { f(); }, [&] { g(); });
}

#endif

}  // namespace prosector::fork_join
