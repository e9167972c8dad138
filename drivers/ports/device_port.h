#pragma once
// Byte transport of a device: a serial line, a hidraw file or a socket. It may be lost and reopened.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// Interface of a non-blocking port to a device, such as a serial line. It never throws. When the device is
/// lost, the port closes and error() gives the reason.
class DevicePort {
 public:
  virtual ~DevicePort() = default;
  /// Opens the port, or starts to open it if this takes long. Returns whether the port is open.
  virtual bool open() = 0;
  /// Returns whether an attempt to open the port is still in progress.
  virtual bool is_opening() const { return false; }
  virtual void close() = 0;
  virtual bool is_open() const = 0;
  /// Returns a file descriptor that becomes readable when data arrives, or −1 if there is none.
  virtual int descriptor() const = 0;
  /// Returns the path of the device file or the address of the server to which this port connects, for
  /// messages.
  virtual const std::string& path() const = 0;
  /// Returns the reason, for messages, why the last attempt to open failed or why the device was lost.
  /// Returns an empty text if neither happened.
  virtual const std::string& error() const = 0;
  /// Appends the bytes received so far to `out`, about `limit` at most, without waiting. Returns false when
  /// the device is lost; the port is then closed.
  virtual bool read(std::vector<std::uint8_t>& out, std::size_t limit) = 0;
  /// Sends the bytes of a short command. Returns false when the device is lost, or when the send queue is
  /// full; in the latter case the port stays open.
  virtual bool write(std::string_view bytes) = 0;
};

}  // namespace prosector
