#include "drivers/five_dt.h"

#include <algorithm>

#include "drivers/five_dt_record.h"

namespace prosector {
namespace {

constexpr unsigned glove_baud = 19200;
constexpr std::int64_t glove_answer_ns = 500'000'000;
constexpr double serial_least_span = 16;  // of 255 counts
constexpr double usb_least_span = 40;     // of 4095 counts, of which about 500 are used

/// Takes records of `width` bytes from the front; what `decode` refuses is skipped byte by byte.
template <class Decode>
void take_records(StampedBuffer& buffer, HealthMonitor& health, GloveHand& hand, std::size_t width,
                  std::int64_t now_ns, const Decode& decode, std::vector<DeviceSample>& out) {
  std::size_t skipped = 0;
  while (buffer.bytes().size() >= width) {
    const auto counts = decode(buffer.bytes().first(width));
    if (!counts) {
      ++skipped;
      buffer.drop(1);
      continue;
    }
    health.garbage(now_ns, skipped);
    skipped = 0;
    health.record(now_ns, width);
    out.push_back(hand.sample(*counts, buffer.time_ns()));
    buffer.drop(width);
  }
  health.garbage(now_ns, skipped);
}

}  // namespace

FiveDtSerialGlove::FiveDtSerialGlove(const std::string& path, const DeviceConfig& config)
    : StreamDevice(path, glove_baud), left_(config.left), hand_(config, serial_least_span) {}

void FiveDtSerialGlove::started(std::int64_t now_ns) {
  buffer().clear();
  send(std::string_view(&five_dt::reset_command, 1));
  streaming_ = false;
  due_ns_ = now_ns + glove_answer_ns;
}

void FiveDtSerialGlove::advance(std::int64_t now_ns) {
  if (now_ns < due_ns_) return;
  if (!streaming_ || health().quiet_ns(now_ns) > silence_limit_ns) started(now_ns);
}

void FiveDtSerialGlove::parse(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  if (!streaming_) {
    const auto bytes = buffer().bytes();
    const auto answer = std::find(bytes.begin(), bytes.end(), five_dt::reset_answer);
    const bool answered = answer != bytes.end();
    buffer().drop(static_cast<std::size_t>(answer - bytes.begin()) + (answered ? 1 : 0));
    if (!answered) return;
    send(std::string_view(&five_dt::stream_command, 1));
    streaming_ = true;
    due_ns_ = now_ns + silence_limit_ns;
  }
  take_records(
      buffer(), health(), hand_, five_dt::packet_width, now_ns,
      [&](std::span<const std::uint8_t> bytes) { return five_dt::decode_packet(bytes, left_); }, out);
}

std::string FiveDtSerialGlove::silent_hint() const {
  return streaming_ ? "it answered its reset but sends no packets"
                    : "it does not answer: check power and cable";
}

std::string FiveDtSerialGlove::babble_hint() const {
  return "check that it is a 5DT Data Glove 5 at 19200 baud";
}

FiveDtUsbGlove::FiveDtUsbGlove(const std::string& path, const DeviceConfig& config)
    : StreamDevice(path, 0), hand_(config, usb_least_span) {}

void FiveDtUsbGlove::parse(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  take_records(buffer(), health(), hand_, five_dt::report_width, now_ns, five_dt::decode_report, out);
}

std::string FiveDtUsbGlove::silent_hint() const {
  return "check that the path is the glove's (5DT is vendor 5d70)";
}

std::string FiveDtUsbGlove::babble_hint() const {
  return "its reports are not those of a 5DT Ultra glove (vendor 5d70): check the path";
}

std::unique_ptr<Device> open_five_dt(const std::string& path, const DeviceConfig& config) {
  return std::make_unique<FiveDtSerialGlove>(path, config);
}

std::unique_ptr<Device> open_five_dt_usb(const std::string& path, const DeviceConfig& config) {
  return std::make_unique<FiveDtUsbGlove>(path, config);
}

}  // namespace prosector
