#pragma once
// A device's port whose other end is the test's: a simulated device answers, and the test spoils its bytes.

#include <memory>
#include <string>
#include <vector>

#include "common/clock.h"
#include "drivers/ports/device_port.h"
#include "twins/base/twin.h"

namespace prosector {

/// What goes through a FedPort; it outlives the port.
struct Feed {
  std::vector<std::uint8_t> to_driver, from_driver;
  bool open = false;
  int openings = 0;
};

class FedPort final : public DevicePort {
 public:
  explicit FedPort(Feed& feed) : feed_(feed) {}
  bool open() override {
    feed_.open = true;
    ++feed_.openings;
    feed_.to_driver.clear();
    feed_.from_driver.clear();
    return true;
  }
  void close() override { feed_.open = false; }
  bool is_open() const override { return feed_.open; }
  int descriptor() const override { return -1; }
  const std::string& path() const override { return path_; }
  const std::string& error() const override { return error_; }
  bool read(std::vector<std::uint8_t>& out, std::size_t) override {
    out.insert(out.end(), feed_.to_driver.begin(), feed_.to_driver.end());
    feed_.to_driver.clear();
    return true;
  }
  bool write(std::string_view bytes) override {
    feed_.from_driver.insert(feed_.from_driver.end(), bytes.begin(), bytes.end());
    return true;
  }

 private:
  Feed& feed_;
  std::string path_ = "fed", error_;
};

/// Lets a simulated device hear what the driver says, and say what it has to by then, in ns.
inline std::vector<std::uint8_t> sent_bytes(Twin& twin, Feed& feed, std::int64_t now_ns) {
  std::vector<TwinOutput> out;
  twin.receive(feed.from_driver, now_ns, out);
  feed.from_driver.clear();
  twin.produce(now_ns, out);
  std::vector<std::uint8_t> bytes;
  for (const TwinOutput& o : out) bytes.insert(bytes.end(), o.bytes.begin(), o.bytes.end());
  return bytes;
}

}  // namespace prosector
