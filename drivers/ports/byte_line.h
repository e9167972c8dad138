#pragma once
// Non-blocking byte stream to another program.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace prosector {

class ByteStream {
 public:
  virtual ~ByteStream() = default;
  /// Appends the bytes received so far to `out` without waiting. Returns false when the connection is lost;
  /// error() gives the reason.
  virtual bool receive(std::vector<std::uint8_t>& out) = 0;
  /// Sends bytes without waiting. If earlier bytes are still queued, all of the new ones are dropped, so that
  /// messages are never cut.
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  /// Returns whether bytes of an earlier send() are still queued, so that the next send() would drop its
  /// bytes.
  virtual bool is_full() { return false; }
  /// Returns a file descriptor that becomes readable when data arrives, or −1 if there is none.
  virtual int descriptor() const { return -1; }
  virtual const std::string& error() const = 0;
};

/// Connects to a TCP server. Blocks for up to two seconds per address of the host. Throws InputError with the
/// reason on failure.
std::unique_ptr<ByteStream> connect_tcp(const std::string& host, const std::string& port);
/// Connects to the Unix socket at `path`. Throws InputError with the reason on failure.
std::unique_ptr<ByteStream> connect_local(const std::string& path);
/// Creates a byte stream that owns a connected socket and closes it on destruction. `where` names the socket
/// in error messages.
std::unique_ptr<ByteStream> socket_line(int descriptor, std::string where);

/// Host name and port number, as text, of a network server.
struct HostPort {
  std::string host, port;
};
/// Parses the address HOST[:PORT] of a server; the port is `default_port` if omitted. Returns nothing if the
/// host is empty or the port is not a number from 0 to 65535.
std::optional<HostPort> parse_host_port(const std::string& text, const char* default_port);

}  // namespace prosector
