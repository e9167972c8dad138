#include "client/app/user/config_watch.h"

#include <fmt/format.h>

#include <utility>

#include "common/error.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

constexpr std::int64_t check_interval_ns = 500'000'000;

}  // namespace

ClientConfig ConfigSource::read() const {
  ClientConfig out;
  if (!file.empty()) out = load_client_config(file);
  const auto take = [](const std::string& given, std::string& address) {
    if (!given.empty()) address = given;
  };
  take(tracker, out.tracker);
  take(left_glove, out.gloves[left_hand].address);
  take(right_glove, out.gloves[right_hand].address);
  take(arm, out.arm.address);
  for (const std::string& address :
       {out.tracker, out.gloves[left_hand].address, out.gloves[right_hand].address})
    if (!address.empty()) (void)parse_device_address(address);
  if (!out.arm.address.empty()) (void)parse_arm_address(out.arm.address);
  out.tracker_device.camera.shared = camera;
  return out;
}

ConfigWatch::ConfigWatch(ConfigSource source) : source_(std::move(source)), written_(last_written()) {}

std::filesystem::file_time_type ConfigWatch::last_written() const {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(source_.file, error);
  return error ? written_ : time;  // a missing file is assumed to be in the middle of replacement
}

std::optional<ClientConfig> ConfigWatch::look(std::int64_t now_ns,
                                              const std::function<void(const std::string&)>& report) {
  if (source_.file.empty() || now_ns - looked_ns_ < check_interval_ns) return std::nullopt;
  looked_ns_ = now_ns;
  const auto written = last_written();
  if (std::exchange(written_, written) == written) return std::nullopt;
  try {
    ClientConfig out = source_.read();
    report(fmt::format("{} was changed: its devices and gestures are now in use", source_.file.string()));
    return out;
  } catch (const InputError& error) {
    report(fmt::format("{}; devices are unchanged", error.what()));
    return std::nullopt;
  }
}

}  // namespace prosector
