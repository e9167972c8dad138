#pragma once
// The TCP port at which a simulated VRPN server is reached: one client at a time.

#include <cstdint>

#include "drivers/socket_listener.h"
#include "drivers/twins/vrpn_twin.h"

namespace prosector {

class VrpnServer {
 public:
  /// Listens on this machine; port 0: one that is free. Throws InputError where it can't.
  VrpnServer(VrpnTwin& twin, std::uint16_t port);
  ~VrpnServer();
  VrpnServer(const VrpnServer&) = delete;
  VrpnServer& operator=(const VrpnServer&) = delete;

  std::uint16_t port() const { return listener_.port(); }
  /// Lets the twin go on to that time, with what its client says and hears, and waits for nothing.
  void serve(std::int64_t now_ns);
  /// Hangs up on the client.
  void cut();

 private:
  void hear();
  void tell(const vrpn::Bytes& bytes);

  VrpnTwin& twin_;
  SocketListener listener_;
  int client_ = -1;
  vrpn::Bytes waiting_;  // of a message that did not fit
};

}  // namespace prosector
