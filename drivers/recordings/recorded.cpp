#include "drivers/recordings/recorded.h"

#include <fmt/format.h>

#include <cmath>

#include "common/clock.h"
#include "common/error.h"
#include "drivers/device/gesture.h"
#include "drivers/files/csv.h"
#include "drivers/recordings/sample_columns.h"

namespace prosector {
namespace {

constexpr double ns_per_s = 1e9;

std::string header() {
  std::string line;
  for (const std::string& c : sample_columns()) line += (line.empty() ? "" : ",") + c;
  return line;
}

std::string row(const DeviceSample& s, double time) {
  std::string line = fmt::format("{:.6f},{}", time, s.station + 1);
  const Pose& x = s.pose;
  line += s.has_pose ? fmt::format(",{},{},{},{},{},{},{}", x.p.x(), x.p.y(), x.p.z(), x.q.w(), x.q.x(),
                                   x.q.y(), x.q.z())
                     : ",,,,,,,";
  for (const double f : s.flexion) line += s.has_flexion ? fmt::format(",{}", f) : ",";
  return line + fmt::format(",{},{}\n", gesture_name(s.gesture), s.buttons);
}

}  // namespace

SampleRecorder::SampleRecorder(const std::filesystem::path& file) : out_(file) {
  if (!(out_ << header() << '\n')) throw InputError(fmt::format("{}: cannot be written", file.string()));
}

bool SampleRecorder::write(const std::vector<DeviceSample>& samples) {
  for (const DeviceSample& s : samples) {
    if (!start_ns_) start_ns_ = s.time_ns;
    out_ << row(s, static_cast<double>(s.time_ns - *start_ns_) / ns_per_s);
  }
  return static_cast<bool>(out_.flush());
}

std::vector<TimedSample> load_recording(const std::filesystem::path& file) {
  const CsvTable table(file, sample_columns());
  std::vector<TimedSample> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    TimedSample t;
    t.time = table.required(i, "time");
    if (!samples.empty() && t.time < samples.back().time) table.fail(i, "time: must not fall");
    t.sample.station = read_station(table, i);
    if (const auto pose = read_pose(table, i)) {
      t.sample.has_pose = true;
      t.sample.pose = *pose;
    }
    if (const auto flexion = read_flexion(table, i)) {
      t.sample.has_flexion = true;
      t.sample.flexion = *flexion;
    }
    if (const auto name = table.text(i, "gesture"); !name.empty()) {
      const GestureRow* gesture = find_gesture(name);
      if (gesture == nullptr) table.fail(i, fmt::format("gesture: '{}' is unknown", name));
      t.sample.gesture = gesture->gesture;
    }
    const double buttons = table.number(i, "buttons").value_or(0);
    if (buttons < 0 || buttons > 4294967295.0 || buttons != std::floor(buttons))
      table.fail(i, "buttons: must be a whole number from 0 to 4294967295");
    t.sample.buttons = static_cast<std::uint32_t>(buttons);
    samples.push_back(t);
  }
  return samples;
}

RecordedDevice::RecordedDevice(const std::filesystem::path& file, bool loop)
    : path_(file.string()), samples_(load_recording(file)), loop_(loop) {}

void RecordedDevice::poll(std::vector<DeviceSample>& out) {
  const std::int64_t now_ns = monotonic_ns();
  if (!start_ns_) start_ns_ = now_ns - static_cast<std::int64_t>(samples_.front().time * ns_per_s);
  const auto due = [&] { return *start_ns_ + static_cast<std::int64_t>(samples_[next_].time * ns_per_s); };
  while (next_ < samples_.size() && due() <= now_ns) {
    out.push_back(samples_[next_].sample);
    out.back().record = records_++;
    out.back().time_ns = due();
    ++next_;
  }
  if (next_ == samples_.size() && loop_) {
    next_ = 0;
    start_ns_.reset();
  }
}

DeviceStatus RecordedDevice::status() const {
  DeviceStatus status;
  status.records = records_;
  const bool ended = next_ == samples_.size();
  status.health = ended ? DeviceHealth::silent : DeviceHealth::streaming;
  if (ended) status.message = fmt::format("{} has ended", path_);
  return status;
}

std::unique_ptr<Device> open_recorded(const std::string& path) {
  return std::make_unique<RecordedDevice>(path, false);
}

std::unique_ptr<Device> open_recorded_loop(const std::string& path) {
  return std::make_unique<RecordedDevice>(path, true);
}

}  // namespace prosector
