#pragma once
// A line to another program as a device's port. Connecting has a thread of its own, as it may take its time.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/byte_line.h"
#include "drivers/device_port.h"
#include "drivers/opening.h"

namespace prosector {

class LinePort final : public DevicePort {
 public:
  /// Makes one that is not open. `where` is for people; `connect` throws InputError with the reason where it
  /// can't.
  LinePort(std::string where, std::function<std::unique_ptr<ByteLine>()> connect);

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
  Opening<ByteLine> opening_;
};

}  // namespace prosector
