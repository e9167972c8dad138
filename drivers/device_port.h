#pragma once
// What a device's bytes come through: a serial line, a hidraw file, a socket. It may vanish and come back.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// Never waits, never throws. Losing the device closes it and says why.
class DevicePort {
 public:
  virtual ~DevicePort() = default;
  /// Opens it, or begins to. Returns whether it is open.
  virtual bool open() = 0;
  /// Tells whether it is still being opened: it neither failed nor is open.
  virtual bool is_opening() const { return false; }
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  /// Returns a descriptor that becomes readable when something arrived, or −1.
  virtual int descriptor() const = 0;
  /// Returns what it opens, for people.
  virtual const std::string& path() const = 0;
  /// Returns, for people, why the last open failed or the device was lost.
  virtual const std::string& error() const = 0;
  /// Appends what has arrived, about `limit` bytes at most. Returns false when the device is gone (then it is
  /// closed).
  virtual bool read(std::vector<std::uint8_t>& out, std::size_t limit) = 0;
  /// Sends a short command. Returns false when the device is gone, or its queue is full (then it stays open).
  virtual bool write(std::string_view bytes) = 0;
};

}  // namespace prosector
