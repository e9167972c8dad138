#include "client/app/desk/figures.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double interval = 0.5;  // s: more frequent changes are unreadable

std::string network(const BusCounters& before, const BusCounters& now, double seconds,
                    const Catalogue& words) {
  const auto rate = [&](std::uint64_t a, std::uint64_t b) {
    return 1e-3 * static_cast<double>(b - a) / seconds;
  };
  return words.tr("network {:.1f} kB/s in, {:.1f} kB/s out, {} samples dropped",
                  rate(before.bytes_in, now.bytes_in), rate(before.bytes_out, now.bytes_out),
                  now.dropped_total);
}

}  // namespace

void Figures::take(std::int64_t now_ns, double seconds, const BusCounters& counters,
                   const ServerStatus* status) {
  if (!since_ns_) {
    since_ns_ = now_ns;
    counters_since_ = counters;
    return;
  }
  ++pictures_;
  drawing_seconds_ += seconds;
  longest_ = std::max(longest_, seconds);
  const double over = 1e-9 * static_cast<double>(now_ns - *since_ns_);
  if (over < interval) return;
  text_ = words_.tr("frame {:.1f} ms (mean), {:.1f} ms (max), {:.0f} frames per second",
                    1e3 * drawing_seconds_ / pictures_, 1e3 * longest_, pictures_ / over) +
          '\n' + network(counters_since_, counters, over, words_);
  if (status != nullptr)
    text_ +=
        '\n' + words_.tr("server step {:.1f} ms (median), {:.1f} ms (99th percentile); x{:.2f} real time",
                         status->step_ms_p50, status->step_ms_p99, status->real_time_factor);
  since_ns_ = now_ns;
  counters_since_ = counters;
  pictures_ = 0;
  drawing_seconds_ = longest_ = 0;
}

}  // namespace prosector
