#pragma once
// The device's end of what leads to a simulated device: a pseudo-terminal, or a socket at which one client is
// served.

#include <cstdint>
#include <memory>
#include <string>

namespace prosector {

class TwinPort {
 public:
  virtual ~TwinPort() = default;
  /// Makes it. Throws InputError where it can't.
  virtual void open() = 0;
  /// Hangs up, as when the plug is pulled.
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  /// Returns what is read and written, or −1 while nobody is there.
  virtual int descriptor() const = 0;
  /// Returns where clients find it.
  virtual const std::string& path() const = 0;
  /// Lets in a client that waits, where there is none. Returns whether one came.
  virtual bool let_in() { return false; }
  /// Lets go of a client that hung up.
  virtual void let_go() {}
};

/// Makes a pseudo-terminal, with a symbolic link to it where `link` isn't empty.
std::unique_ptr<TwinPort> terminal_port(const std::string& link);
/// Makes a TCP port on this machine; 0: one that is free, and stays the same.
std::unique_ptr<TwinPort> tcp_port(std::uint16_t port);
/// Makes a Unix socket.
std::unique_ptr<TwinPort> local_port(const std::string& path);

}  // namespace prosector
