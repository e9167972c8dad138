#include "drivers/ports/socket_listener.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "common/error.h"

namespace prosector {
namespace {

constexpr int backlog = 64;

/// Binds and listens. Returns the descriptor. Throws InputError on failure.
template <class Address>
int listen_at(const Address& here, int family, const std::string& name) {
  const int descriptor = ::socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  ::setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  if (descriptor >= 0 && ::bind(descriptor, reinterpret_cast<const sockaddr*>(&here), sizeof(here)) == 0 &&
      ::listen(descriptor, backlog) == 0)
    return descriptor;
  const int error = errno;
  ::close(descriptor);
  throw InputError(fmt::format("{}: {}", name, std::strerror(error)));
}

}  // namespace

SocketListener::SocketListener(const std::string& address, std::uint16_t port) {
  sockaddr_in6 here6{};
  sockaddr_in here{};
  if (::inet_pton(AF_INET6, address.c_str(), &here6.sin6_addr) == 1) {
    here6.sin6_family = AF_INET6;
    here6.sin6_port = htons(port);
    descriptor_ = listen_at(here6, AF_INET6, fmt::format("[{}]:{}", address, port));
  } else if (::inet_pton(AF_INET, address.c_str(), &here.sin_addr) == 1) {
    here.sin_family = AF_INET;
    here.sin_port = htons(port);
    descriptor_ = listen_at(here, AF_INET, fmt::format("{}:{}", address, port));
  } else {
    throw InputError(fmt::format("'{}': must be a numeric IP address, e.g. 127.0.0.1", address));
  }
  sockaddr_in6 bound{};  // the port has the same offset in both address types
  socklen_t size = sizeof(bound);
  ::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&bound), &size);
  port_ = ntohs(bound.sin6_port);
}

SocketListener::SocketListener(const std::string& path) : path_(path) {
  sockaddr_un here{};
  here.sun_family = AF_UNIX;
  if (path.size() >= sizeof(here.sun_path)) throw InputError(fmt::format("{}: too long for a socket", path));
  path.copy(here.sun_path, path.size());
  ::unlink(path.c_str());
  descriptor_ = listen_at(here, AF_UNIX, path);
}

SocketListener::~SocketListener() {
  ::close(descriptor_);
  if (!path_.empty()) ::unlink(path_.c_str());
}

int SocketListener::accept() {
  const int client = ::accept4(descriptor_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  const int on = 1;
  if (client >= 0) ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
  return client;
}

}  // namespace prosector
