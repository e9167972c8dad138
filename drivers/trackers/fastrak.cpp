#include "drivers/trackers/fastrak.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "drivers/ports/byte_port.h"

namespace prosector {
namespace {

constexpr unsigned fastrak_baud = 115200;
constexpr std::int64_t stop_ns = 100'000'000;  // time for data in transit to arrive before the buffer is
                                               // flushed
constexpr std::int64_t initialise_ns = 10'000'000'000;  // duration of a reinitialisation after ^Y
constexpr std::int64_t answer_ns = 500'000'000;         // timeout of the answer to S
constexpr std::int64_t gap_ns = 50'000'000;             // between commands: the device may drop faster input
constexpr std::string_view resume = "\x11", initialise = "\x19";
constexpr int first_command_reset_attempt = 2, first_initialise_attempt = 6,
              first_toggle_extended_attempt = 8,
              first_leave_point_attempt = 9;                       // first attempt of each recovery command
constexpr std::size_t status_width = 55, short_status_width = 54;  // some trackers omit one byte
constexpr std::size_t max_error_record = 256;
constexpr double metres_per_cm = 0.01;

bool is_active(std::uint32_t stations, std::size_t station) {
  return (stations >> station & 1u) != 0;
}

std::string_view text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::vector<std::string> fastrak_commands(std::uint32_t stations, const FastrakConfig& config) {
  std::vector<std::string> commands = {"u", config.binary ? "f" : "F"};
  for (std::size_t i = 0; i < max_stations; ++i) {
    const std::size_t s = i + 1;
    commands.push_back(fmt::format("l{},{}\r", s, is_active(stations, i) ? 1 : 0));
    if (!is_active(stations, i)) continue;
    commands.push_back(fmt::format("O{},2,11,1\r", s));
    commands.push_back(fmt::format("R{}\r", s));
    const Vec3& h = config.hemisphere;
    commands.push_back(fmt::format("H{},{:.4f},{:.4f},{:.4f}\r", s, h.x(), h.y(), h.z()));
    if (config.alignment) {
      std::string points = fmt::format("A{}", s);
      for (const double x : *config.alignment) points += fmt::format(",{:.2f}", x);
      commands.push_back(points + "\r");
    }
    commands.push_back(fmt::format("{}{}\r", config.boresight ? 'B' : 'b', s));
  }
  commands.push_back("C");
  return commands;
}

std::vector<FastrakStep> fastrak_start(int attempt) {
  std::vector<FastrakStep> out = {{std::string(resume), gap_ns}};
  if (attempt >= first_command_reset_attempt) out.push_back({"\r", gap_ns});
  if (attempt >= first_leave_point_attempt) out.push_back({"Y", gap_ns});
  if (attempt >= first_toggle_extended_attempt) out.push_back({"t", gap_ns});
  if (attempt >= first_initialise_attempt) out.push_back({std::string(initialise), initialise_ns});
  out.push_back({"c", stop_ns});
  return out;
}

FastrakDevice::FastrakDevice(std::unique_ptr<DevicePort> port, const Placement& placement,
                             const FastrakConfig& config)
    : StreamDevice(std::move(port)),
      chain_(placement),
      format_{config.binary, {2, 11, 1}},
      commands_(fastrak_commands(placement.stations, config)) {}

void FastrakDevice::started(std::int64_t now_ns) {
  attempt_ = 0;
  restart(now_ns);
}

void FastrakDevice::restart(std::int64_t now_ns) {
  answered_ = false;
  steps_ = fastrak_start(++attempt_);
  next_step_ = 0;
  phase_ = Phase::stopping;
  due_ns_ = now_ns;
}

void FastrakDevice::advance(std::int64_t now_ns) {
  if (phase_ == Phase::streaming) {
    if (now_ns >= due_ns_ && health().quiet_ns(now_ns) > silence_limit_ns) restart(now_ns);
    return;
  }
  if (now_ns < due_ns_) return;
  if (phase_ == Phase::stopping && next_step_ < steps_.size()) {
    const FastrakStep& step = steps_[next_step_++];
    send(step.bytes);
    due_ns_ = now_ns + step.wait_ns;
  } else if (phase_ == Phase::stopping) {
    buffer().clear();
    run_ = 0;
    send("S");
    phase_ = Phase::asked;
    due_ns_ = now_ns + answer_ns;
  } else if (phase_ == Phase::asked) {
    restart(now_ns);  // timeout: no answer
  } else {
    send(commands_[next_command_++]);
    due_ns_ = now_ns + gap_ns;
    if (next_command_ < commands_.size()) return;
    phase_ = Phase::streaming;
    due_ns_ = now_ns + silence_limit_ns;
  }
}

void FastrakDevice::parse(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  if (phase_ == Phase::asked) {
    parse_status();
    if (answered_) {
      attempt_ = 0;
      phase_ = Phase::configuring;
      next_command_ = 0;
      due_ns_ = now_ns;
    }
  } else if (phase_ == Phase::configuring || phase_ == Phase::streaming) {
    parse_records(now_ns, out);
  }
}

void FastrakDevice::parse_status() {
  const std::string_view bytes = text(buffer().bytes());
  for (std::size_t i = 0; i + short_status_width <= bytes.size(); ++i) {
    const std::size_t end = bytes.find("\r\n", i);
    if (bytes[i] != '2' || bytes[i + 2] != 'S' || end == std::string_view::npos) continue;
    const std::size_t width = end + 2 - i;
    if (width != status_width && width != short_status_width) continue;
    buffer().drop(i + width);
    answered_ = true;
    return;
  }
  if (bytes.size() > 4 * status_width) buffer().drop(bytes.size() - status_width);
}

int FastrakDevice::error_record_length() const {
  constexpr std::string_view mark = "*ERROR*";
  const std::string_view bytes = text(buffer().bytes());
  if (bytes.size() < 3) return !bytes.empty() && bytes[0] == '2' ? -1 : 0;
  if (bytes[0] != '2' || bytes[2] != 'E') return 0;
  const std::string_view head = bytes.substr(3, mark.size());
  if (mark.substr(0, head.size()) != head) return 0;
  const std::size_t end = bytes.find("\r\n", 0);
  if (end != std::string_view::npos && end < max_error_record) return static_cast<int>(end) + 2;
  return bytes.size() < max_error_record ? -1 : 0;
}

void FastrakDevice::parse_records(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  const std::size_t width = fastrak::record_width(format_);
  const auto end_run = [&] {
    health().garbage(now_ns, run_);
    run_ = 0;
  };
  while (!buffer().bytes().empty()) {
    if (const int length = error_record_length(); length < 0) {
      break;
    } else if (length > 0) {
      ++command_errors_;
      command_error_ = std::string(text(buffer().bytes().first(static_cast<std::size_t>(length) - 2)));
      buffer().drop(static_cast<std::size_t>(length));
      continue;
    }
    if (buffer().bytes()[0] == '0' && buffer().bytes().size() < width) break;
    const auto record =
        buffer().bytes()[0] == '0' ? fastrak::decode(buffer().bytes().first(width), format_) : std::nullopt;
    if (!record) {
      ++run_;
      buffer().drop(1);
      continue;
    }
    end_run();
    health().record(now_ns, width);
    out.push_back(sample(*record));
    buffer().drop(width);
  }
  end_run();
}

DeviceSample FastrakDevice::sample(const fastrak::Record& record) {
  DeviceSample out;
  out.station = record.station;
  out.record = records_[record.station]++;
  out.time_ns = buffer().time_ns();
  out.error = station_error_[record.station] = record.error;
  const auto& p = *record.position;
  const auto& q = *record.quaternion;
  out.raw_pose = {p[0], p[1], p[2], q[0], q[1], q[2], q[3]};
  out.has_pose = true;  // with an error code the pose is less accurate, but still the best estimate
  const Pose transmitter = {metres_per_cm * Vec3(p[0], p[1], p[2]),
                            Quat(q[0], q[1], q[2], q[3]).normalized()};
  out.pose = chain_.room(fastrak::from_transmitter(transmitter), record.station);
  return out;
}

DeviceStatus FastrakDevice::status() const {
  DeviceStatus status = StreamDevice::status();
  const auto add = [&](const std::string& what) {
    status.message += (status.message.empty() ? "" : "; ") + what;
  };
  if (command_errors_ > 0)
    add(fmt::format("the tracker refused {} command(s), the last one with: {}", command_errors_,
                    command_error_));
  for (std::size_t i = 0; i < max_stations; ++i)
    if (station_error_[i] != ' ')
      add(
          fmt::format("receiver {} reports error '{}', its pose may be wrong: check the receiver's distance "
                      "to the transmitter and to metal",
                      i + 1, station_error_[i]));
  return status;
}

std::string FastrakDevice::silent_hint() const {
  return answered_
             ? "the tracker responds but sends no records: check that receivers are plugged in"
             : fmt::format("the tracker does not respond: check power, cable and that it is set to {} baud",
                           fastrak_baud);
}

std::string FastrakDevice::babble_hint() const {
  return fmt::format("check that the device is a FASTRAK at {} baud, 8 data bits, no parity", fastrak_baud);
}

std::unique_ptr<Device> open_fastrak(const std::string& path, const Placement& placement,
                                     const FastrakConfig& config) {
  return std::make_unique<FastrakDevice>(std::make_unique<BytePort>(path, fastrak_baud), placement, config);
}

}  // namespace prosector
