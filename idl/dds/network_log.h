#pragma once
// What Cyclone DDS has to say, which nobody who dissects can use line by line: counted, told seldom.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace prosector {

/// Turns any number of messages into a plain line now and then.
class MessageDigest {
 public:
  /// Counts `message`. Returns the line to tell, at most one in ten seconds.
  std::optional<std::string> take(std::int64_t now_ns, std::string_view message);

 private:
  std::uint64_t count_ = 0, told_ = 0;
  std::optional<std::int64_t> last_line_ns_;
};

/// Sends Cyclone's messages of this process through a MessageDigest to standard error from now on, instead of
/// one by one. Any number of calls.
void quiet_network_log();

/// While one lives, nothing is told, as where failing is expected and said in other words.
class NetworkLogPause {
 public:
  NetworkLogPause();
  ~NetworkLogPause();
  NetworkLogPause(const NetworkLogPause&) = delete;
  NetworkLogPause& operator=(const NetworkLogPause&) = delete;
};

}  // namespace prosector
