#pragma once
// A conversation over a WebSocket: each text that comes may be answered by some. It has a thread of its own,
// with a real-time priority where the system gives one, and connects again by itself.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

class WebSocket {
 public:
  /// How it goes.
  struct State {
    bool connected = false;
    std::uint64_t connections = 0;
    bool refused = false;  // it isn't connected, as `answer` would have it so
    std::string problem;   // why it isn't connected
  };

  using Answer = std::function<std::optional<std::vector<std::string>>(std::string_view text)>;

  /// Starts to connect to what is served there ("/" or "/v6.json"). Its thread calls `answer` with each text,
  /// and sends the texts that it returns, in order. Where it returns nothing, it hangs up, and connects anew.
  WebSocket(std::string host, std::string port, std::string target, Answer answer);
  /// Lets one more answer go out, if one is due within 50 ms, and ends.
  ~WebSocket();

  /// Returns how it goes, without waiting. One thread calls it.
  const State& state();

 private:
  class Talk;
  std::unique_ptr<Talk> talk_;
};

}  // namespace prosector
