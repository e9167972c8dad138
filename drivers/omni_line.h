#pragma once
// How an Omni's driver reaches the arm: its registers, and a packet each way a thousand times a second. One
// line is FireWire, the other a socket, at whose end a simulated arm sits.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drivers/omni_packets.h"

namespace prosector::omni {

/// Isochronous channels of the bus, 0 … 63.
struct Channels {
  std::uint8_t to_arm = 0, from_arm = 1;
};

class Line {
 public:
  virtual ~Line() = default;
  /// Opens the line. Returns false when the arm can't be reached; error() says why.
  virtual bool open() = 0;
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  virtual const std::string& error() const = 0;

  /// Reads four bytes at an address, in the bus' order; nothing: it did not answer. Takes a few milliseconds
  /// at most.
  virtual std::optional<Word> read(std::uint64_t address) = 0;
  virtual bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) = 0;
  /// Reserves two channels of the bus and gets ready for packets on them. Returns nothing if it can't.
  virtual std::optional<Channels> start() = 0;
  /// Returns the newest packet that arrived since the last call, never waiting for one.
  virtual std::optional<std::array<std::uint8_t, state_bytes>> receive() = 0;
  virtual bool send(std::span<const std::uint8_t, command_bytes> packet) = 0;
};

/// Reaches the first Omni on a FireWire port, by the port's number: "0".
std::unique_ptr<Line> make_firewire_line(const std::string& port);
/// Reaches a simulated arm at a Unix socket of packets, by its path.
std::unique_ptr<Line> make_socket_line(const std::string& path);

// What travels on the socket: one letter, then what it says.
//   'r' address (8)            → 'R' word (4)     register read
//   'w' address (8) bytes      → 'W'              register write
//   'c' command packet (16)                       host → arm
//   's' state packet (44)                         arm → host
inline constexpr std::uint8_t asks_read = 'r', answers_read = 'R', asks_write = 'w', answers_write = 'W',
                              carries_command = 'c', carries_state = 's';
inline constexpr std::size_t longest_message = 64;  // bytes

}  // namespace prosector::omni
