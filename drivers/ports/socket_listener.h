#pragma once
// Listening socket: TCP, or a Unix socket on this machine.

#include <cstdint>
#include <string>

namespace prosector {

class SocketListener {
 public:
  /// Listens at a numeric TCP address ("127.0.0.1", "::1"); port 0 selects a free port. Throws InputError on
  /// failure.
  SocketListener(const std::string& address, std::uint16_t port);
  /// Listens at a Unix socket, replacing an old socket file. Throws InputError on failure.
  explicit SocketListener(const std::string& path);
  ~SocketListener();
  SocketListener(const SocketListener&) = delete;
  SocketListener& operator=(const SocketListener&) = delete;

  /// Accepts a waiting client. Returns a non-blocking descriptor that the caller owns, or −1.
  int accept();
  int descriptor() const { return descriptor_; }
  std::uint16_t port() const { return port_; }

 private:
  int descriptor_ = -1;
  std::uint16_t port_ = 0;
  std::string path_;  // of a Unix socket; else empty
};

}  // namespace prosector
