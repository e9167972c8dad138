#include "drivers/twins/vrpn_server.h"

#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "common/error.h"

namespace prosector {

VrpnServer::VrpnServer(VrpnTwin& twin, std::uint16_t port) : twin_(twin) {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_port = htons(port);
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(here);
  if (listener_ < 0 || ::bind(listener_, reinterpret_cast<const sockaddr*>(&here), sizeof(here)) != 0 ||
      ::listen(listener_, 1) != 0 ||
      ::getsockname(listener_, reinterpret_cast<sockaddr*>(&here), &size) != 0) {
    const int error = errno;
    ::close(listener_);
    throw InputError(fmt::format("port {}: {}", port, std::strerror(error)));
  }
  port_ = ntohs(here.sin_port);
}

VrpnServer::~VrpnServer() {
  cut();
  ::close(listener_);
}

void VrpnServer::serve(std::int64_t now_ns) {
  if (client_ < 0) {
    client_ = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    const int on = 1;
    if (client_ >= 0) ::setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
  }
  hear();
  tell(twin_.advance(now_ns));
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

/// Sends what there is to say. Where a client doesn't keep up, it misses whole reports.
void VrpnServer::tell(const vrpn::Bytes& bytes) {
  if (client_ < 0) return;
  if (waiting_.empty()) waiting_ = bytes;
  if (waiting_.empty()) return;
  const ssize_t sent = ::send(client_, waiting_.data(), waiting_.size(), MSG_NOSIGNAL);
  if (sent > 0) waiting_.erase(waiting_.begin(), waiting_.begin() + sent);
}

}  // namespace prosector
