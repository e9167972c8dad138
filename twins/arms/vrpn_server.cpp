#include "twins/arms/vrpn_server.h"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace prosector {

VrpnServer::VrpnServer(VrpnTwin& twin, std::uint16_t port) : twin_(twin), listener_("127.0.0.1", port) {}

VrpnServer::~VrpnServer() {
  cut();
}

void VrpnServer::serve(std::int64_t now_ns) {
  if (client_ < 0) client_ = listener_.accept();
  hear();
  send_bytes(twin_.advance(now_ns));
}

void VrpnServer::cut() {
  if (client_ < 0) return;
  ::close(client_);
  client_ = -1;
  waiting_.clear();
  twin_.hang_up();
}

void VrpnServer::hear() {
  std::array<std::uint8_t, 4096> bytes;
  while (client_ >= 0) {
    const ssize_t got = ::recv(client_, bytes.data(), bytes.size(), 0);
    if (got > 0) {
      twin_.receive({bytes.data(), static_cast<std::size_t>(got)});
    } else if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) {
      return;
    } else {
      cut();
    }
  }
}

/// Sends the unsent data, or else `bytes`. A client that reads too slowly misses whole reports.
void VrpnServer::send_bytes(const vrpn::Bytes& bytes) {
  if (client_ < 0) return;
  if (waiting_.empty()) waiting_ = bytes;
  if (waiting_.empty()) return;
  const ssize_t sent = ::send(client_, waiting_.data(), waiting_.size(), MSG_NOSIGNAL);
  if (sent > 0) waiting_.erase(waiting_.begin(), waiting_.begin() + sent);
}

}  // namespace prosector
