#pragma once
// A serial line or a hidraw file as a stream of bytes that may vanish and come back.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// A serial line or other device file: owns one descriptor; never blocks, never throws. Losing the device
/// closes it and says why.
class BytePort {
 public:
  /// Takes the device's path. `baud` 0 leaves line settings alone (hidraw); else the path must be a terminal,
  /// which is set to 8 data bits, no parity, 1 stop bit, raw, no flow control.
  BytePort(std::string path, unsigned baud);
  ~BytePort();
  BytePort(const BytePort&) = delete;
  BytePort& operator=(const BytePort&) = delete;

  bool open();
  void close();
  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  const std::string& path() const { return path_; }
  /// Returns, for people, why the last open failed or the device was lost.
  const std::string& error() const { return error_; }

  /// Appends what has arrived, at most `limit` bytes. Returns false when the device is gone (then it is
  /// closed).
  bool read(std::vector<std::uint8_t>& out, std::size_t limit);
  /// Sends a short command. Returns false when the device is gone, or its queue is full (then it stays open).
  bool write(std::string_view bytes);

 private:
  bool set_up_line();
  bool lose(const std::string& why);

  std::string path_;
  unsigned baud_;
  int descriptor_ = -1;
  std::string error_;
};

}  // namespace prosector
