#include "client/app/commands/record_device.h"

#include <fmt/format.h>
#include <poll.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>

#include "client/app/commands/configured_device.h"
#include "common/clock.h"
#include "common/error.h"
#include "drivers/device/driver_table.h"
#include "drivers/recordings/recorded.h"

namespace prosector {
namespace {

std::atomic<bool> recording_ended = false;
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void add_record(CLI::App& app, RecordOptions& o) {
  app.add_option("ADDRESS", o.address,
                 "Device to record, DRIVER:PATH, e.g. fastrak:/dev/ttyS0; with --config also its name there: "
                 "tracker, glove.right or glove.left")
      ->required();
  app.add_option("--out", o.out,
                 "CSV file to write the samples to; it can be replayed as the device recorded:FILE")
      ->required();
  app.add_option("--config", o.config,
                 "Client configuration file with the device's settings (receivers, pose, glove counts)")
      ->check(CLI::ExistingFile);
  app.add_option("--seconds", o.seconds, "Stop recording after this many seconds (default: at Ctrl-C)")
      ->check(CLI::NonNegativeNumber);
}

int record_device(const RecordOptions& o) {
  const ConfiguredDevice wanted = configured_device(o.address, o.config);
  const auto device = open_device(wanted.address, wanted.device);
  SampleRecorder recorder(o.out);
  std::signal(SIGINT, [](int) { recording_ended = true; });
  std::signal(SIGTERM, [](int) { recording_ended = true; });
  constexpr int longest_wait_ms = 20;
  const std::int64_t begin_ns = monotonic_ns();
  std::vector<DeviceSample> samples;
  std::uint64_t count = 0;
  std::string last_message;
  while (!recording_ended && (o.seconds == 0 || seconds_since(begin_ns) < o.seconds)) {
    pollfd descriptor{device->descriptor(), POLLIN, 0};
    ::poll(&descriptor, descriptor.fd >= 0 ? 1 : 0, longest_wait_ms);
    samples.clear();
    device->poll(samples);
    if (!recorder.write(samples))
      throw InputError(fmt::format(
          "{}: the recording can no longer be written: check that the disk has free space", o.out.string()));
    count += samples.size();
    const DeviceStatus status = device->status();
    if (status.message != last_message && !status.message.empty()) fmt::print(stderr, "{}\n", status.message);
    last_message = status.message;
  }
  fmt::print("{} samples in {:.1f} s: replay them with --tracker recorded:{}\n", count,
             seconds_since(begin_ns), o.out.string());
  return count > 0 ? 0 : 1;
}

}  // namespace prosector
