#pragma once
// TCP server of a simulated VRPN server: one client at a time.

#include <cstdint>

#include "drivers/ports/socket_listener.h"
#include "twins/arms/vrpn_twin.h"

namespace prosector {

class VrpnServer {
 public:
  /// Starts a TCP server on this machine for the simulated VRPN arm `twin`; port 0 selects a free port.
  /// Throws InputError on failure.
  VrpnServer(VrpnTwin& twin, std::uint16_t port);
  ~VrpnServer();
  VrpnServer(const VrpnServer&) = delete;
  VrpnServer& operator=(const VrpnServer&) = delete;

  std::uint16_t port() const { return listener_.port(); }
  /// Advances the simulated arm to the time `now_ns` and exchanges data with the client, without waiting.
  void serve(std::int64_t now_ns);
  /// Closes the connection to the client, to simulate a lost connection.
  void cut();

 private:
  void hear();
  void send_bytes(const vrpn::Bytes& bytes);

  VrpnTwin& twin_;
  SocketListener listener_;
  int client_ = -1;
  vrpn::Bytes waiting_;  // unsent rest of the data
};

}  // namespace prosector
