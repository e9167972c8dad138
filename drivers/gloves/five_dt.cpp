#include "drivers/gloves/five_dt.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drivers/ports/byte_port.h"
#include "drivers/protocols/five_dt_record.h"

namespace prosector {
namespace {

constexpr unsigned glove_baud = 19200, wireless_baud = 9600;
constexpr std::int64_t glove_answer_ns = 500'000'000;
constexpr double serial_least_span = 16;  // counts, of 255
constexpr double usb_least_span = 40;     // counts, of 4095; gloves use about 500 of them

/// Result of decoding the bytes at the front: number of consumed bytes, and the decoded sample.
struct Taken {
  std::size_t width = 0;
  std::optional<DeviceSample> sample = std::nullopt;
  bool garbage = false;
};

/// Decodes records of `width` bytes from the front of the buffer until fewer bytes remain.
template <class Decode>
void take_records(TimestampedBuffer& buffer, HealthMonitor& health, std::size_t width, std::int64_t now_ns,
                  const Decode& decode, std::vector<DeviceSample>& out) {
  std::size_t skipped = 0;
  while (buffer.bytes().size() >= width) {
    const Taken taken = decode(buffer.bytes().first(width), buffer.time_ns());
    if (taken.garbage) {
      skipped += taken.width;
    } else if (taken.sample) {
      health.garbage(now_ns, skipped);
      skipped = 0;
      health.record(now_ns, taken.width);
      out.push_back(*taken.sample);
    }
    buffer.drop(taken.width);
  }
  health.garbage(now_ns, skipped);
}

constexpr Taken one_byte_of_garbage{1, std::nullopt, true};

}  // namespace

FiveDtSerialGlove::FiveDtSerialGlove(std::unique_ptr<DevicePort> port, const GestureThresholds& gestures,
                                     const GloveConfig& glove)
    : StreamDevice(std::move(port)), left_(glove.left), hand_(gestures, glove, serial_least_span) {}

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
  const auto decode = [&](std::span<const std::uint8_t> bytes, std::int64_t time_ns) {
    if (const auto counts = five_dt::decode_packet(bytes, left_))
      return Taken{five_dt::packet_width, hand_.sample(*counts, time_ns)};
    // Some gloves send that byte after each packet.
    if (bytes[0] == five_dt::reset_answer) return Taken{1};
    return one_byte_of_garbage;
  };
  take_records(buffer(), health(), five_dt::packet_width, now_ns, decode, out);
}

std::string FiveDtSerialGlove::silent_hint() const {
  return streaming_ ? "the glove answered the reset but sends no packets: switch it off and on"
                    : "the glove does not respond: check power and cable";
}

std::string FiveDtSerialGlove::babble_hint() const {
  return "check that the device is a 5DT Data Glove 5 at 19200 baud; for a wireless glove use the driver "
         "5dt-wireless";
}

FiveDtWirelessGlove::FiveDtWirelessGlove(std::unique_ptr<DevicePort> port, const GestureThresholds& gestures,
                                         const GloveConfig& glove)
    : StreamDevice(std::move(port)),
      left_(glove.left),
      reports_left_(glove.left),
      hand_(gestures, glove, serial_least_span) {}

void FiveDtWirelessGlove::parse(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  const auto decode = [&](std::span<const std::uint8_t> bytes, std::int64_t time_ns) {
    const auto packet = five_dt::decode_wireless(bytes, left_);
    // The checksum may be unused. If it is wrong, a packet is accepted only if it begins where the previous
    // packet ended.
    const bool counts = packet && (packet->checksum_ok || at_packet_start_);
    at_packet_start_ = packet.has_value();
    if (!packet) return one_byte_of_garbage;
    if (!counts) return Taken{five_dt::wireless_width};
    reports_left_ = packet->left;
    return Taken{five_dt::wireless_width, hand_.sample(packet->counts, time_ns)};
  };
  take_records(buffer(), health(), five_dt::wireless_width, now_ns, decode, out);
}

DeviceStatus FiveDtWirelessGlove::status() const {
  DeviceStatus out = StreamDevice::status();
  if (out.message.empty() && reports_left_ != left_)
    out.message = fmt::format("the device is a {} glove, but it is configured as the {} one",
                              reports_left_ ? "left" : "right", left_ ? "left" : "right");
  return out;
}

std::string FiveDtWirelessGlove::silent_hint() const {
  return "the glove's receiver sends no data: check that the glove is switched on and near";
}

std::string FiveDtWirelessGlove::babble_hint() const {
  return "check that the device is a wireless 5DT Data Glove at 9600 baud; for a glove with a cable use the "
         "driver 5dt";
}

FiveDtUsbGlove::FiveDtUsbGlove(std::unique_ptr<DevicePort> port, const GestureThresholds& gestures,
                               const GloveConfig& glove)
    : StreamDevice(std::move(port)), hand_(gestures, glove, usb_least_span) {}

void FiveDtUsbGlove::parse(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  // The kernel delivers whole reports. An unreadable report is dropped as a whole; otherwise the words of
  // other sensors could be decoded as fingers.
  const auto decode = [&](std::span<const std::uint8_t> bytes, std::int64_t time_ns) {
    const auto counts = five_dt::decode_report(bytes);
    if (!counts) return Taken{five_dt::report_width, std::nullopt, true};
    return Taken{five_dt::report_width, hand_.sample(*counts, time_ns)};
  };
  take_records(buffer(), health(), five_dt::report_width, now_ns, decode, out);
}

std::string FiveDtUsbGlove::silent_hint() const {
  return "check that the device path is the glove's (5DT is USB vendor 5d70)";
}

std::string FiveDtUsbGlove::babble_hint() const {
  return "the device's reports are not those of a 5DT Ultra glove (USB vendor 5d70): check the path";
}

std::unique_ptr<Device> open_five_dt(const std::string& path, const GestureThresholds& gestures,
                                     const GloveConfig& glove) {
  return std::make_unique<FiveDtSerialGlove>(std::make_unique<BytePort>(path, glove_baud), gestures, glove);
}

std::unique_ptr<Device> open_five_dt_wireless(const std::string& path, const GestureThresholds& gestures,
                                              const GloveConfig& glove) {
  return std::make_unique<FiveDtWirelessGlove>(std::make_unique<BytePort>(path, wireless_baud), gestures,
                                               glove);
}

std::unique_ptr<Device> open_five_dt_usb(const std::string& path, const GestureThresholds& gestures,
                                         const GloveConfig& glove) {
  return std::make_unique<FiveDtUsbGlove>(std::make_unique<BytePort>(path, 0), gestures, glove);
}

}  // namespace prosector
