#pragma once
// Byte transport of a device: a serial line, a hidraw file or a socket. It may be lost and reopened.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// Non-blocking port that never throws. When the device is lost, the port closes and error() gives the
/// reason.
class DevicePort {
 public:
  virtual ~DevicePort() = default;
  /// Opens the port or begins to open it. Returns whether it is open.
  virtual bool open() = 0;
  /// Returns whether opening is still in progress.
  virtual bool is_opening() const { return false; }
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  /// Returns a descriptor that becomes readable when data arrives, or −1.
  virtual int descriptor() const = 0;
  /// Returns the path or address of the device, for messages.
  virtual const std::string& path() const = 0;
  /// Returns, for messages, why the last open failed or the device was lost.
  virtual const std::string& error() const = 0;
  /// Appends the received bytes, about `limit` at most. Returns false when the device is lost; the port is
  /// then closed.
  virtual bool read(std::vector<std::uint8_t>& out, std::size_t limit) = 0;
  /// Sends a short command. Returns false when the device is lost, or when its queue is full (the port then
  /// stays open).
  virtual bool write(std::string_view bytes) = 0;
};

}  // namespace prosector
