#pragma once
// Connection of the Omni driver to the arm: registers, and packets in both directions at 1000 Hz. One
// implementation uses FireWire, the other a socket to a simulated arm.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drivers/protocols/omni_packets.h"

namespace prosector::omni {

/// Isochronous channels of the bus, 0 … 63.
struct Channels {
  std::uint8_t to_arm = 0, from_arm = 1;
};

class Line {
 public:
  virtual ~Line() = default;
  /// Opens the connection. Returns false when the arm is unreachable; error() gives the reason.
  virtual bool open() = 0;
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  virtual const std::string& error() const = 0;

  /// Reads four bytes at an address, in bus order; nothing if the arm does not answer. Takes a few
  /// milliseconds at most.
  virtual std::optional<Word> read(std::uint64_t address) = 0;
  virtual bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) = 0;
  /// Reserves two isochronous channels of the bus and prepares to transfer packets on them. Returns nothing
  /// on failure.
  virtual std::optional<Channels> start() = 0;
  /// Returns the latest packet that arrived since the last call, without waiting.
  virtual std::optional<std::array<std::uint8_t, state_bytes>> receive() = 0;
  virtual bool send(std::span<const std::uint8_t, command_bytes> packet) = 0;
};

/// Creates a connection to the first Omni on a FireWire port, given the port's number: "0".
std::unique_ptr<Line> make_firewire_line(const std::string& port);
/// Creates a connection to a simulated arm at a Unix socket of packets, given its path.
std::unique_ptr<Line> make_socket_line(const std::string& path);

// Messages on the socket: one letter, then the data.
//   'r' address (8)            → 'R' word (4)     register read
//   'w' address (8) bytes      → 'W'              register write
//   'c' command packet (16)                       host → arm
//   's' state packet (44)                         arm → host
inline constexpr std::uint8_t read_request = 'r', read_response = 'R', write_request = 'w',
                              write_response = 'W', command_message = 'c', state_message = 's';
inline constexpr std::size_t longest_message = 64;  // bytes

}  // namespace prosector::omni
