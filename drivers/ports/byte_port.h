#pragma once
// Serial line or hidraw file as a byte stream that may be lost and reopened.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/ports/device_port.h"

namespace prosector {

/// Serial line or other device file of a device, opened without blocking. It owns one file descriptor.
class BytePort final : public DevicePort {
 public:
  /// Takes the path of the device file without opening it. With `baud` 0 the line settings stay unchanged
  /// (hidraw). Otherwise the path must be a terminal, which open() sets to raw mode, 8 data bits, no parity,
  /// 1 stop bit, no flow control.
  BytePort(std::string path, unsigned baud);
  ~BytePort() override;
  BytePort(const BytePort&) = delete;
  BytePort& operator=(const BytePort&) = delete;

  bool open() override;
  void close() override;
  bool is_open() const override { return descriptor_ >= 0; }
  int descriptor() const override { return descriptor_; }
  const std::string& path() const override { return path_; }
  const std::string& error() const override { return error_; }
  bool read(std::vector<std::uint8_t>& out, std::size_t limit) override;
  bool write(std::string_view bytes) override;

 private:
  bool set_up_line();
  bool lose(const std::string& why);

  std::string path_;
  unsigned baud_;
  int descriptor_ = -1;
  std::string error_;
};

}  // namespace prosector
