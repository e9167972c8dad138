#pragma once
// Adapter from a byte stream of another program to a device port. Connecting runs on a separate thread, since
// it may take seconds.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/ports/background_opener.h"
#include "drivers/ports/byte_line.h"
#include "drivers/ports/device_port.h"

namespace prosector {

class StreamPort final : public DevicePort {
 public:
  /// Creates a closed port to another program. `where` names the program in messages. `connect` opens a byte
  /// stream to it and throws InputError with the reason on failure.
  StreamPort(std::string where, std::function<std::unique_ptr<ByteStream>()> connect);

  bool open() override;
  bool is_opening() const override { return opening_.is_trying(); }
  void close() override;
  bool is_open() const override { return opening_.get() != nullptr; }
  int descriptor() const override;
  const std::string& path() const override { return where_; }
  const std::string& error() const override { return opening_.problem(); }
  bool read(std::vector<std::uint8_t>& out, std::size_t limit) override;
  bool write(std::string_view bytes) override;

 private:
  std::string where_;
  BackgroundOpener<ByteStream> opening_;
};

}  // namespace prosector
