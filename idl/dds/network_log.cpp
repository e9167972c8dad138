#include "idl/dds/network_log.h"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>
#include <fmt/format.h>

#include <cstdio>
#include <mutex>
#include <utility>

#include "common/clock.h"

namespace prosector {
namespace {

constexpr std::int64_t line_interval_ns = 10'000'000'000;
constexpr std::size_t max_shown = 160;  // bytes shown of a message

/// The log digest of this process. Cyclone has one log per process and calls it from its own threads.
struct NetworkLog {
  std::mutex mutex;
  LogDigest digest;
  int pauses = 0;
};

NetworkLog& network_log() {
  static NetworkLog log;
  return log;
}

void take_message(void*, const dds_log_data_t* data) {
  NetworkLog& log = network_log();
  const std::scoped_lock lock(log.mutex);
  if (log.pauses > 0) return;
  if (const auto line = log.digest.take(monotonic_ns(), std::string_view(data->message, data->size)))
    fmt::print(stderr, "{}\n", *line);
}

/// Returns the message without control characters, truncated.
std::string shown(std::string_view message) {
  std::string out;
  for (const char c : message.substr(0, max_shown))
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) out += c;
  return out;
}

}  // namespace

std::optional<std::string> LogDigest::take(std::int64_t now_ns, std::string_view message) {
  ++count_;
  if (last_line_ns_ && now_ns - *last_line_ns_ < line_interval_ns) return std::nullopt;
  last_line_ns_ = now_ns;
  const std::uint64_t fresh = count_ - std::exchange(reported_count_, count_);
  return fmt::format("network: {} errors since the last report ({} in total); the latest error: {}", fresh,
                     count_, shown(message));
}

void condense_network_log() {
  static std::once_flag once;
  std::call_once(once, [] {
    dds_set_log_sink(take_message, nullptr);
    dds_set_trace_sink(take_message, nullptr);
  });
}

ScopedLogSuppression::ScopedLogSuppression() {
  const std::scoped_lock lock(network_log().mutex);
  ++network_log().pauses;
}

ScopedLogSuppression::~ScopedLogSuppression() {
  const std::scoped_lock lock(network_log().mutex);
  --network_log().pauses;
}

}  // namespace prosector
