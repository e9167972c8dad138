#include "client/app/commands/self_test.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "client/app/commands/configured_device.h"
#include "client/app/commands/device_report.h"
#include "common/clock.h"
#include "common/error.h"
#include "drivers/device/driver_table.h"
#include "drivers/recordings/recorded.h"

namespace prosector {
namespace {

constexpr double report_period = 10;  // s between two progress lines
constexpr unsigned all_stations = (1u << max_stations) - 1;
std::atomic<bool> ended = false;

}  // namespace

int self_test(const SelfTestOptions& options) {
  auto [address, config] = configured_device(options.address, options.config);
  if (options.config.empty()) config.placement.stations = all_stations;
  const auto device = open_device(address, config);
  const std::filesystem::path samples_file = std::filesystem::path(options.out).replace_extension(".csv");
  SampleRecorder recorder(samples_file);
  std::ofstream report_file(options.out);
  if (!report_file) throw InputError(fmt::format("{}: cannot be written", options.out.string()));
  fmt::print(
      "device {}: for the next {:g} s, move it through its whole range, rotate it, open and close all "
      "fingers, and press its buttons\n",
      address, options.seconds);
  std::fflush(stdout);
  std::signal(SIGINT, [](int) { ended = true; });
  std::signal(SIGTERM, [](int) { ended = true; });
  DeviceReport report(address, driver_of(address).is_camera);
  std::vector<DeviceSample> samples;
  const std::int64_t start_ns = monotonic_ns();
  bool kept = true;
  for (double seconds = 0, next_report = report_period; seconds < options.seconds && !ended;) {
    samples.clear();
    device->poll(samples);
    seconds = 1e-9 * static_cast<double>(monotonic_ns() - start_ns);
    report.take(samples, device->status(), seconds);
    kept = recorder.write(samples) && kept;
    if (seconds > next_report) {
      fmt::print("{:.0f} s: {} records\n", seconds, device->status().records);
      std::fflush(stdout);
      next_report += report_period;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const std::string text = report.text();
  fmt::print(
      "\n{}\nThe report was written to {}, the samples to {}. Replay the samples with `recorded:{}`.\n", text,
      options.out.string(), samples_file.string(), samples_file.string());
  report_file << text;
  if (!kept || !report_file.flush())
    throw InputError(fmt::format("{}: cannot be written", samples_file.string()));
  return report.fits() ? 0 : 1;
}

void add_self_test(CLI::App& app, SelfTestOptions& o) {
  app.add_option("ADDRESS", o.address,
                 "Device to test, DRIVER:PATH, e.g. 5dt-usb:/dev/hidraw0; with --config also its name there: "
                 "tracker, glove.right or glove.left (default: the first one configured)");
  app.add_option(
         "--config", o.config,
         "Client configuration file with the device's settings (address, receivers, pose, glove counts)")
      ->check(CLI::ExistingFile);
  app.add_option("--seconds", o.seconds, "Duration of the recording")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 86400.0));
  app.add_option("--out", o.out,
                 "File to write the report to; the samples are written to a .csv file of the same name")
      ->capture_default_str();
}

}  // namespace prosector
