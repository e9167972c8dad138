#pragma once
// A line to another program: bytes each way, and nothing that waits.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace prosector {

class ByteLine {
 public:
  virtual ~ByteLine() = default;
  /// Appends what arrived. Returns false when the line is gone; error() says why.
  virtual bool receive(std::vector<std::uint8_t>& out) = 0;
  /// Sends bytes. While earlier ones wait for their way out, newer ones are dropped, as a whole.
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  /// Tells whether earlier bytes still wait.
  virtual bool is_full() { return false; }
  /// Returns a descriptor that becomes readable when something arrived, or −1.
  virtual int descriptor() const { return -1; }
  virtual const std::string& error() const = 0;
};

/// Connects by TCP; that may take two seconds. Throws InputError with the reason where it can't.
std::unique_ptr<ByteLine> connect_tcp(const std::string& host, const std::string& port);
/// Connects to a Unix socket. Throws InputError with the reason where it can't.
std::unique_ptr<ByteLine> connect_local(const std::string& path);
/// Takes over a connected socket, of that name in messages.
std::unique_ptr<ByteLine> socket_line(int descriptor, std::string where);

/// Where a program listens.
struct HostPort {
  std::string host, port;
};
/// Splits HOST[:PORT]. Returns nothing for what is none.
std::optional<HostPort> parse_host_port(const std::string& text, const char* usual_port);

}  // namespace prosector
