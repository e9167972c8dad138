#pragma once
// WebSocket client that can answer each received text with several texts. It runs on a separate thread, with
// real-time priority if the system grants it, and reconnects automatically.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

class WebSocket {
 public:
  /// State of the connection to the WebSocket server, with the reason if there is none.
  struct State {
    bool connected = false;
    std::uint64_t connections = 0;
    bool refused = false;  // not connected, because `answer` rejected the last text
    std::string problem;   // why it is not connected
  };

  using Answer = std::function<std::optional<std::vector<std::string>>(std::string_view text)>;

  /// Starts a thread that connects to the WebSocket server's endpoint `target`, such as "/" or "/v6.json".
  /// The thread calls `answer` with each received text and sends the returned texts in order. If `answer`
  /// returns nothing, the thread closes the connection and opens it again.
  WebSocket(std::string host, std::string port, std::string target, Answer answer);
  /// Waits up to 50 ms for one more text from the server, to send what `answer` returns for it. Then closes
  /// the connection and ends the thread.
  ~WebSocket();

  /// Returns the connection's state without waiting. Only one thread may call it.
  const State& state();

 private:
  class Talk;
  std::unique_ptr<Talk> talk_;
};

}  // namespace prosector
