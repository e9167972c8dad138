#pragma once
// WebSocket server of a simulated Inverse3, like that of its service: one client, one state per received
// text.

#include <cstdint>
#include <memory>

#include "twins/arms/inverse3_twin.h"

namespace prosector {

class Inverse3Server {
 public:
  /// Starts a WebSocket server on this machine for the simulated Inverse3 `twin`; port 0 selects a free port.
  /// Throws InputError on failure.
  Inverse3Server(Inverse3Twin& twin, std::uint16_t port);
  ~Inverse3Server();

  std::uint16_t port() const;
  /// Processes pending network events without waiting. A text received from the client is answered in the
  /// next call.
  void serve();
  /// Closes the connection to the client, to simulate a lost connection.
  void cut();
  bool has_client() const;
  bool mute = false;  // send no answers

 private:
  class Talk;
  std::unique_ptr<Talk> talk_;
};

}  // namespace prosector
