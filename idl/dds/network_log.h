#pragma once
// Digest of Cyclone DDS's log messages, which aren't useful to users line by line: counted and reported
// rarely.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace prosector {

/// Condenses any number of log messages to one line per interval.
class LogDigest {
 public:
  /// Counts `message`. Returns the line to print, at most one per ten seconds.
  std::optional<std::string> take(std::int64_t now_ns, std::string_view message);

 private:
  std::uint64_t count_ = 0, told_ = 0;
  std::optional<std::int64_t> last_line_ns_;
};

/// Redirects the log of Cyclone DDS in this process to standard error through a LogDigest, from now on.
/// May be called repeatedly.
void condense_network_log();

/// Suppresses the network log while an object exists, for operations that may fail and report errors
/// themselves.
class ScopedLogSuppression {
 public:
  ScopedLogSuppression();
  ~ScopedLogSuppression();
  ScopedLogSuppression(const ScopedLogSuppression&) = delete;
  ScopedLogSuppression& operator=(const ScopedLogSuppression&) = delete;
};

}  // namespace prosector
