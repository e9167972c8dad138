#pragma once
// The device's end of the connection to a simulated device: a pseudo-terminal, or a socket that serves one
// client.

#include <cstdint>
#include <memory>
#include <string>

namespace prosector {

class TwinPort {
 public:
  virtual ~TwinPort() = default;
  /// Creates the port. Throws InputError on failure.
  virtual void open() = 0;
  /// Hangs up, as when the cable is unplugged.
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  /// Returns the descriptor for reading and writing, or −1 without a client.
  virtual int descriptor() const = 0;
  /// Returns the address for clients.
  virtual const std::string& path() const = 0;
  /// Accepts a waiting client if there is none yet. Returns whether a client has connected.
  virtual bool let_in() { return false; }
  /// Closes the connection of a client that hung up.
  virtual void let_go() {}
};

/// Creates a pseudo-terminal and, if `link` is not empty, a symbolic link to it.
std::unique_ptr<TwinPort> terminal_port(const std::string& link);
/// Creates a TCP port on this machine. Port 0 selects a free port, which stays the same when reopened.
std::unique_ptr<TwinPort> tcp_port(std::uint16_t port);
/// Creates a Unix socket.
std::unique_ptr<TwinPort> local_port(const std::string& path);

}  // namespace prosector
