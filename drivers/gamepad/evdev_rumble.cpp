// Gamepad motors through the kernel's input devices: linux/input.h, force feedback.

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "drivers/gamepad/rumble.h"

namespace prosector {
namespace {

constexpr std::uint16_t longest_ms = 500;

using Bits = std::array<unsigned long, KEY_CNT / (8 * sizeof(unsigned long)) + 1>;

/// Returns whether the device supports an event code of the given event type.
bool has(int device, unsigned kind, unsigned code) {
  Bits bits{};
  if (ioctl(device, EVIOCGBIT(kind, sizeof bits), bits.data()) < 0) return false;
  constexpr unsigned word = 8 * sizeof(unsigned long);
  return (bits[code / word] >> (code % word) & 1UL) != 0;
}

class EvdevMotors final : public RumbleMotors {
 public:
  explicit EvdevMotors(int device) : device_(device) { effect_.type = FF_RUMBLE; }
  ~EvdevMotors() override { close(device_); }  // the kernel then stops the motors
  EvdevMotors(const EvdevMotors&) = delete;
  EvdevMotors& operator=(const EvdevMotors&) = delete;

  bool set(double strong, double weak) override {
    const auto level = [](double share) {
      return static_cast<std::uint16_t>(std::clamp(share, 0., 1.) * USHRT_MAX);
    };
    effect_.u.rumble.strong_magnitude = level(strong);
    effect_.u.rumble.weak_magnitude = level(weak);
    effect_.replay.length = longest_ms;
    if (ioctl(device_, EVIOCSFF, &effect_) < 0) return false;
    input_event play{};
    play.type = EV_FF;
    play.code = static_cast<std::uint16_t>(effect_.id);
    play.value = 1;
    return write(device_, &play, sizeof play) == static_cast<ssize_t>(sizeof play);
  }

 private:
  int device_;
  ff_effect effect_ = [] {
    ff_effect out{};
    out.id = -1;  // the kernel assigns an id
    return out;
  }();
};

}  // namespace

std::unique_ptr<RumbleMotors> open_rumble() {
  std::error_code ignored;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/input", ignored))
    if (entry.path().filename().string().starts_with("event")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const int device = open(file.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (device < 0) continue;
    if (has(device, EV_KEY, BTN_GAMEPAD) && has(device, EV_FF, FF_RUMBLE))
      return std::make_unique<EvdevMotors>(device);
    close(device);
  }
  return nullptr;
}

}  // namespace prosector
