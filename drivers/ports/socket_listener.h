#pragma once
// Listening socket: TCP, or a Unix socket on this machine.

#include <cstdint>
#include <string>

namespace prosector {

class SocketListener {
 public:
  /// Listens at a numeric TCP address, such as "127.0.0.1" or "::1". Port 0 selects a free port; port()
  /// returns it. Throws InputError on failure.
  SocketListener(const std::string& address, std::uint16_t port);
  /// Listens at the Unix socket `path` and replaces an old socket file there. Throws InputError on failure.
  explicit SocketListener(const std::string& path);
  ~SocketListener();
  SocketListener(const SocketListener&) = delete;
  SocketListener& operator=(const SocketListener&) = delete;

  /// Accepts a waiting client without blocking. Returns a non-blocking file descriptor that the caller owns,
  /// or −1 if no client is waiting.
  int accept();
  int descriptor() const { return descriptor_; }
  std::uint16_t port() const { return port_; }

 private:
  int descriptor_ = -1;
  std::uint16_t port_ = 0;
  std::string path_;  // of a Unix socket; else empty
};

}  // namespace prosector
