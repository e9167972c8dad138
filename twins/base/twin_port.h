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
  /// Creates the port at which clients connect to the simulated device. Throws InputError on failure.
  virtual void open() = 0;
  /// Closes the port, so that the client's side hangs up as when the cable is unplugged.
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  /// Returns the file descriptor to exchange bytes with the client, or −1 if no client is connected.
  virtual int descriptor() const = 0;
  /// Returns the address at which clients connect: the terminal's or socket's path, or "localhost:PORT".
  virtual const std::string& path() const = 0;
  /// Accepts a waiting client if none is connected yet. Returns whether a client has newly connected.
  virtual bool let_in() { return false; }
  /// Closes the connection to a client that hung up, so that another one can connect. Does nothing at a
  /// terminal.
  virtual void let_go() {}
};

/// Returns a port, not opened yet, that simulates a serial line by a pseudo-terminal. If `link` is not empty,
/// it is a symbolic link to the terminal.
std::unique_ptr<TwinPort> terminal_port(const std::string& link);
/// Returns a port, not opened yet, that serves clients by TCP on this machine. Port number 0 selects a free
/// one, which stays the same when the port is reopened.
std::unique_ptr<TwinPort> tcp_port(std::uint16_t port);
/// Returns a port, not opened yet, that serves clients at the Unix socket `path`.
std::unique_ptr<TwinPort> local_port(const std::string& path);

}  // namespace prosector
