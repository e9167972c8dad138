#pragma once
// A socket at which other programs are let in, of TCP or of this machine alone.

#include <cstdint>
#include <string>

namespace prosector {

class SocketListener {
 public:
  /// Listens at a TCP address in numbers ("127.0.0.1", "::1"); port 0: one that is free. Throws InputError
  /// where it can't.
  SocketListener(const std::string& address, std::uint16_t port);
  /// Listens at a Unix socket, in place of one that was left behind. Throws InputError where it can't.
  explicit SocketListener(const std::string& path);
  ~SocketListener();
  SocketListener(const SocketListener&) = delete;
  SocketListener& operator=(const SocketListener&) = delete;

  /// Lets in who waits. Returns a descriptor that never blocks, which is the caller's, or −1.
  int accept();
  int descriptor() const { return descriptor_; }
  std::uint16_t port() const { return port_; }

 private:
  int descriptor_ = -1;
  std::uint16_t port_ = 0;
  std::string path_;  // of a Unix socket
};

}  // namespace prosector
