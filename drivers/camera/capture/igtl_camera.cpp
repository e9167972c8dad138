#include "drivers/camera/capture/igtl_camera.h"

#include <fmt/format.h>
#include <poll.h>

#include <string_view>

#include "common/error.h"
#include "drivers/ports/byte_line.h"
#include "drivers/protocols/igtl_messages.h"

namespace prosector {
namespace {

constexpr std::string_view scheme = "igtl://";

class IgtlCamera final : public Camera {
 public:
  IgtlCamera(std::string address, const HostPort& there, std::string device)
      : address_(std::move(address)),
        device_(std::move(device)),
        line_(connect_tcp(there.host, there.port)) {}

  std::optional<Frame> next(std::chrono::milliseconds time_limit) override {
    const std::int64_t end_ns = monotonic_ns() + std::chrono::nanoseconds(time_limit).count();
    std::optional<Frame> newest;
    for (;;) {
      while (take(newest)) {
      }
      const std::int64_t left_ns = end_ns - monotonic_ns();
      if (newest || left_ns <= 0) return newest;
      pollfd waiting{line_->descriptor(), POLLIN, 0};
      ::poll(&waiting, 1, static_cast<int>(left_ns / 1'000'000) + 1);
    }
  }
  std::string identity() const override { return address_; }

 private:
  const std::string address_, device_;
  std::unique_ptr<ByteStream> line_;
  igtl::Reader reader_{true};
  std::uint64_t next_number_ = 0;

  /// Receives available messages. Returns whether more may be available.
  bool take(std::optional<Frame>& newest) {
    std::vector<std::uint8_t> bytes;
    const bool is_there = line_->receive(bytes);
    reader_.take(bytes, monotonic_ns());
    while (const auto message = reader_.next()) {
      if (message->type != igtl::image_type || (!device_.empty() && message->device != device_)) continue;
      auto image = igtl::image_of(*message);
      if (!image)
        throw InputError(
            fmt::format("camera {}: the device \"{}\" does not send single images of 8 or 16 bits: choose "
                        "another device, as igtl://HOST/NAME",
                        address_, message->device));
      newest = Frame{std::move(*image), message->time_ns, next_number_++};
    }
    if (!reader_.problem().empty()) throw InputError(fmt::format("{}: {}", address_, reader_.problem()));
    if (!is_there) throw InputError(fmt::format("{}: {}", address_, line_->error()));
    return !bytes.empty();
  }
};

}  // namespace

bool is_igtl_camera(const std::string& address) {
  return address.starts_with(scheme);
}

std::unique_ptr<Camera> open_igtl_camera(const std::string& address) {
  const std::string rest = address.substr(scheme.size());
  const auto slash = rest.find('/');
  const auto there = parse_host_port(rest.substr(0, slash), igtl::default_port);
  const std::string device = slash == std::string::npos ? "" : rest.substr(slash + 1);
  if (!there || device.size() > igtl::longest_name)
    throw InputError(fmt::format(
        "camera {}: must be igtl://HOST[:PORT][/DEVICE], with a device's name of at most {} bytes", address,
        igtl::longest_name));
  return std::make_unique<IgtlCamera>(address, *there, device);
}

}  // namespace prosector
