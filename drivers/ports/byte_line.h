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
  /// Appends the received bytes. Returns false when the connection is lost; error() gives the reason.
  virtual bool receive(std::vector<std::uint8_t>& out) = 0;
  /// Sends bytes. If earlier bytes are still queued, the new ones are dropped as a whole.
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  /// Returns whether earlier bytes are still queued.
  virtual bool is_full() { return false; }
  /// Returns a descriptor that becomes readable when data arrives, or −1.
  virtual int descriptor() const { return -1; }
  virtual const std::string& error() const = 0;
};

/// Connects by TCP, which may take two seconds. Throws InputError with the reason on failure.
std::unique_ptr<ByteStream> connect_tcp(const std::string& host, const std::string& port);
/// Connects to a Unix socket. Throws InputError with the reason on failure.
std::unique_ptr<ByteStream> connect_local(const std::string& path);
/// Takes ownership of a connected socket; `where` names it in error messages.
std::unique_ptr<ByteStream> socket_line(int descriptor, std::string where);

/// Host and port of a server.
struct HostPort {
  std::string host, port;
};
/// Parses HOST[:PORT]. Returns nothing for an invalid text.
std::optional<HostPort> parse_host_port(const std::string& text, const char* default_port);

}  // namespace prosector
