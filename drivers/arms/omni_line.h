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

/// Numbers (0 … 63) of the two isochronous channels of the FireWire bus that carry packets to the arm and
/// from it.
struct Channels {
  std::uint8_t to_arm = 0, from_arm = 1;
};

class Line {
 public:
  virtual ~Line() = default;
  /// Opens the connection to the arm. Returns false if the arm is unreachable; error() then gives the reason.
  virtual bool open() = 0;
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  virtual const std::string& error() const = 0;

  /// Reads four bytes at a register address of the arm, in the byte order of the bus. Returns nothing if the
  /// arm does not answer. Blocks for a few milliseconds at most.
  virtual std::optional<Word> read(std::uint64_t address) = 0;
  virtual bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) = 0;
  /// Reserves two isochronous channels of the FireWire bus and prepares to transfer packets on them. Returns
  /// the channels, or nothing on failure; error() then gives the reason.
  virtual std::optional<Channels> start() = 0;
  /// Returns the arm's latest state packet among those that arrived since the last call. Returns nothing if
  /// none arrived. Does not wait.
  virtual std::optional<std::array<std::uint8_t, state_bytes>> receive() = 0;
  virtual bool send(std::span<const std::uint8_t, command_bytes> packet) = 0;
};

/// Creates a connection, not opened yet, to the first PHANTOM Omni on a FireWire port, given the port's
/// number, such as "0".
std::unique_ptr<Line> make_firewire_line(const std::string& port);
/// Creates a connection, not opened yet, to a simulated PHANTOM Omni at a Unix socket of type SOCK_SEQPACKET,
/// given the socket's path.
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
