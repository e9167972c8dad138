#include "twins/trackers/five_dt_twin.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace prosector {
namespace {

constexpr double serial_open = 0, serial_closed = 255;
constexpr double usb_open = 800, usb_closed = 1300;  // range that real gloves use of their 4096 counts

TwinOutput answer(std::string_view text) {
  TwinOutput out;
  out.bytes.assign(text.begin(), text.end());
  return out;
}

}  // namespace

FiveDtTwin::FiveDtTwin(const FiveDtTwinOptions& options, std::int64_t now_ns)
    : options_(options),
      clock_(options.timing, now_ns),
      random_(options.seed),
      period_ns_(std::llround(1e9 / options.rate)),
      next_ns_(now_ns),
      streaming_(options.hid || options.wireless) {
  if (streaming_) clock_.streaming(now_ns);
}

void FiveDtTwin::receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
                         std::vector<TwinOutput>& out) {
  if (options_.hid || options_.wireless) return;
  for (const std::uint8_t byte : bytes) {
    switch (static_cast<char>(byte)) {
      case five_dt::reset_command:
        streaming_ = false;
        out.push_back(answer(std::string_view("\x55", 1)));
        break;
      case five_dt::sample_command:
        out.push_back(record(now_ns));
        break;
      case five_dt::stream_command:
        streaming_ = true;
        next_ns_ = now_ns;
        clock_.streaming(now_ns);
        break;
      case five_dt::info_command: {
        std::string info = "Simulated 5DT Data Glove 5";
        info.resize(five_dt::info_width, ' ');
        out.push_back(answer(info));
        break;
      }
      default:
        break;
    }
  }
}

TwinOutput FiveDtTwin::record(std::int64_t now_ns) {
  const auto flexion =
      options_.script.flexion(options_.station, clock_.seconds(now_ns), options_.timing.loop);
  const double open = options_.hid ? usb_open : serial_open,
               closed = options_.hid ? usb_closed : serial_closed;
  const double most = options_.hid ? five_dt::max_word : serial_closed;
  std::normal_distribution<double> normal;
  five_dt::Counts counts{};
  TwinOutput out;
  for (std::size_t i = 0; i < fingers; ++i) {
    const double noise = options_.noise_counts > 0 ? options_.noise_counts * normal(random_) : 0;
    const double count = std::clamp(open + flexion[i] * (closed - open) + noise, 0.0, most);
    counts[i] = static_cast<std::uint16_t>(std::lround(count));
    out.values.push_back(counts[i]);
  }
  constexpr std::uint8_t level = 128;  // pitch and roll of a level hand
  if (options_.hid) {
    const auto report = five_dt::encode_report(counts);
    out.bytes.assign(report.begin(), report.end());
  } else if (options_.wireless) {
    const auto packet = five_dt::encode_wireless(counts, level, level, options_.left);
    out.bytes.assign(packet.begin(), packet.end());
  } else {
    const auto packet = five_dt::encode_packet(counts, level, level, options_.left);
    out.bytes.assign(packet.begin(), packet.end());
  }
  out.is_record = true;
  out.record = records_++;
  return out;
}

void FiveDtTwin::produce(std::int64_t now_ns, std::vector<TwinOutput>& out) {
  if (!streaming_ || now_ns < next_ns_) return;
  next_ns_ += (1 + (now_ns - next_ns_) / period_ns_) * period_ns_;
  out.push_back(record(now_ns));
}

std::int64_t FiveDtTwin::due_ns(std::int64_t now_ns) const {
  return streaming_ ? next_ns_ : now_ns + period_ns_;
}

}  // namespace prosector
