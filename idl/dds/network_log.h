#pragma once
// Digest of Cyclone DDS's log messages, which aren't useful to users line by line: counted and reported
// rarely.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace prosector {

/// Filter that condenses the log messages of Cyclone DDS to at most one line per ten seconds, with their
/// number.
class LogDigest {
 public:
  /// Counts a log message of Cyclone DDS that was written at `now_ns`. Returns a line to print, at most once
  /// per ten seconds, and otherwise nullopt.
  std::optional<std::string> take(std::int64_t now_ns, std::string_view message);

 private:
  std::uint64_t count_ = 0, reported_count_ = 0;
  std::optional<std::int64_t> last_line_ns_;
};

/// Redirects the log of Cyclone DDS in this process to standard error, condensed by a LogDigest, from now on.
/// May be called repeatedly.
void condense_network_log();

/// Guard that suppresses the log of Cyclone DDS while it exists, for operations that may fail and report
/// their errors separately.
class ScopedLogSuppression {
 public:
  ScopedLogSuppression();
  ~ScopedLogSuppression();
  ScopedLogSuppression(const ScopedLogSuppression&) = delete;
  ScopedLogSuppression& operator=(const ScopedLogSuppression&) = delete;
};

}  // namespace prosector
