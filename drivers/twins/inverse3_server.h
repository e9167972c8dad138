#pragma once
// The WebSocket at which a simulated Inverse3 is reached, as its service's: one client, one state for each
// text.

#include <cstdint>
#include <memory>

#include "drivers/twins/inverse3_twin.h"

namespace prosector {

class Inverse3Server {
 public:
  /// Listens on this machine; port 0: one that is free. Throws InputError where it can't.
  Inverse3Server(Inverse3Twin& twin, std::uint16_t port);
  ~Inverse3Server();

  std::uint16_t port() const;
  /// Does what is due, and waits for nothing. What answers a text goes out in the next call after it.
  void serve();
  /// Hangs up on the client.
  void cut();
  bool has_client() const;
  bool mute = false;  // it answers nothing

 private:
  class Talk;
  std::unique_ptr<Talk> talk_;
};

}  // namespace prosector
