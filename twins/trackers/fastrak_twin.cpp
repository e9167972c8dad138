#include "twins/trackers/fastrak_twin.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

namespace prosector {
namespace {

constexpr std::int64_t cycle_ns = 8'333'333;  // 120 Hz, shared by all stations
constexpr std::int64_t ns_per_s = 1'000'000'000;
constexpr char save = '\x0b', reinitialise = '\x19', suspend = '\x13', resume = '\x11';
constexpr std::string_view commands_with_parameters = "OlHARBbGVQI";
constexpr int field_missing = -1, not_a_number = -2, out_of_range = -3, unknown_command = -99;
constexpr std::size_t longest_command = 200;

void answer(std::string_view text, std::vector<TwinOutput>& out) {
  out.emplace_back().bytes.assign(text.begin(), text.end());
}

std::optional<double> to_number(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Writes one number in the record's format. Returns the float that a reader decodes.
float put(double value, int decimals, bool binary, std::vector<std::uint8_t>& bytes) {
  if (binary) {
    const auto f = static_cast<float>(value);
    for (auto bits = std::bit_cast<std::uint32_t>(f), i = 0u; i < 4; ++i, bits >>= 8)
      bytes.push_back(static_cast<std::uint8_t>(bits & 0xff));
    return f;
  }
  const std::string text = fmt::format("{:7.{}f}", value, decimals);
  bytes.insert(bytes.end(), text.begin(), text.end());
  return std::strtof(text.c_str(), nullptr);
}

std::vector<double> item_values(int code, const Vec3& position, const Quat& q) {
  if (code == 2) return {position.x(), position.y(), position.z()};
  if (code == 11) return {q.w(), q.x(), q.y(), q.z()};
  if (code == 4) {
    const auto angles = fastrak::euler_angles(q);
    return {angles.begin(), angles.end()};
  }
  const Mat3 r = q.toRotationMatrix();
  const int row = code - 5;
  return {r(row, 0), r(row, 1), r(row, 2)};
}

}  // namespace

FastrakTwin::FastrakTwin(const FastrakTwinOptions& options, std::int64_t now_ns)
    : options_(options),
      settings_(defaults()),
      saved_(settings_),
      clock_(options.timing, now_ns),
      random_(options.seed),
      now_ns_(now_ns),
      next_ns_(now_ns) {
  tracked_.fill(Vec3::Zero());
  sent_.fill(Vec3::Constant(std::numeric_limits<double>::infinity()));
}

FastrakTwin::Settings FastrakTwin::defaults() {
  Settings settings;
  settings.stations[0].active = true;
  return settings;
}

void FastrakTwin::receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
                          std::vector<TwinOutput>& out) {
  now_ns_ = now_ns;
  for (const std::uint8_t byte : bytes) {
    const char c = static_cast<char>(byte);
    if (c == resume || c == suspend) {
      suspended_ = c == suspend;
    } else if (!pending_.empty() && c == '\r') {
      execute(pending_, out);
      pending_.clear();
    } else if (!pending_.empty()) {
      pending_ += c;
      if (pending_.size() <= longest_command) continue;
      refuse(unknown_command, out);
      pending_.clear();
    } else if (commands_with_parameters.find(c) != std::string_view::npos) {
      pending_ = c;
    } else if (c != '\r' && c != '\n') {
      single(c, now_ns, out);
    }
  }
}

void FastrakTwin::single(char command, std::int64_t now_ns, std::vector<TwinOutput>& out) {
  switch (command) {
    case 'P':
      for (std::size_t s = 0; s < max_stations; ++s)
        if (settings_.stations[s].active) out.push_back(record(s, now_ns));
      break;
    case 'C':
      settings_.continuous = true;
      clock_.streaming(now_ns);
      next_ns_ = std::max(now_ns, next_ns_);
      break;
    case 'c':
      settings_.continuous = false;
      break;
    case 'F':
      settings_.binary = false;
      break;
    case 'f':
      settings_.binary = true;
      break;
    case 'U':
      settings_.centimetres = false;
      break;
    case 'u':
      settings_.centimetres = true;
      break;
    case 'S':
      answer(status_record(), out);
      break;
    case 'W':
      settings_ = defaults();
      break;
    case save:
      saved_ = settings_;
      break;
    case reinitialise:
      settings_ = saved_;
      next_ns_ = now_ns + static_cast<std::int64_t>(options_.reinitialise_seconds * ns_per_s);
      break;
    default:
      pending_ = command;
      refuse(unknown_command, out);
      pending_.clear();
  }
}

void FastrakTwin::execute(const std::string& command, std::vector<TwinOutput>& out) {
  Parameters p;
  for (std::string_view rest = std::string_view(command).substr(1);;) {
    const auto comma = rest.find(',');
    p.push_back(trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (p[0].empty()) return refuse(field_missing, out);
  const auto number = to_number(p[0]);
  if (!number) return refuse(not_a_number, out);
  if (*number != std::floor(*number) || *number < 1 || *number > max_stations)
    return refuse(out_of_range, out);
  const auto index = static_cast<std::size_t>(*number) - 1;
  Station& s = settings_.stations[index];
  const std::string head = fmt::format("2{}{}", index + 1, command[0]);
  p.erase(p.begin());
  switch (command[0]) {
    case 'O':
      return set_output_list(s, head, p, out);
    case 'l':
      return set_station(index, p, out);
    case 'A':
      return set_alignment(s, head, p, out);
    case 'R':
      s.alignment = {};
      s.points = Station{}.points;
      return;
    case 'B': {
      s.boresight = Quat::Identity();
      const std::array<float, 3> reference = {static_cast<float>(s.reference[0]),
                                              static_cast<float>(s.reference[1]),
                                              static_cast<float>(s.reference[2])};
      const Quat now = measure(index, now_ns_).orientation;
      s.boresight = now.conjugate() * fastrak::rotation(reference);
      return;
    }
    case 'b':
      s.boresight = Quat::Identity();
      return;
    case 'G':
      return set_numbers(s.reference, 1, head, p, out);
    case 'V':
      return set_numbers(s.position_limits, units_per_cm(), head, p, out);
    case 'Q':
      return set_numbers(s.angle_limits, 1, head, p, out);
    case 'I': {
      std::array<double, 1> increment = {s.increment};
      set_numbers(increment, units_per_cm(), head, p, out);
      s.increment = increment[0];
      return;
    }
    default: {  // H: hemisphere
      std::array<double, 3> zenith = {s.hemisphere.x(), s.hemisphere.y(), s.hemisphere.z()};
      set_numbers(zenith, 1, head, p, out);
      s.hemisphere = Vec3(zenith.data());
    }
  }
}

void FastrakTwin::set_output_list(Station& s, const std::string& head, const Parameters& p,
                                  std::vector<TwinOutput>& out) {
  if (p.empty()) {
    std::string text = head;
    for (const int item : s.items) text += fmt::format("{:2d}", item);
    return answer(text + "\r\n", out);
  }
  std::vector<int> items;
  for (const auto& field : p) {
    if (field.empty()) return refuse(field_missing, out);
    const auto value = to_number(field);
    if (!value) return refuse(not_a_number, out);
    const bool whole = *value == std::floor(*value) && std::abs(*value) < 100;
    if (!whole || fastrak::find_item(static_cast<int>(*value)) == nullptr) return refuse(out_of_range, out);
    items.push_back(static_cast<int>(*value));
  }
  if (items.size() > fastrak::max_items) return refuse(out_of_range, out);
  s.items = items;
}

void FastrakTwin::set_station(std::size_t index, const Parameters& p, std::vector<TwinOutput>& out) {
  if (p.empty()) {
    std::string text = fmt::format("2{}l", index + 1);
    for (const Station& s : settings_.stations) text += s.active ? '1' : '0';
    return answer(text + "\r\n", out);
  }
  if (p[0] != "0" && p[0] != "1") return refuse(out_of_range, out);
  settings_.stations[index].active = p[0] == "1";
}

template <std::size_t N>
void FastrakTwin::set_numbers(std::array<double, N>& values, double scale, const std::string& head,
                              const Parameters& p, std::vector<TwinOutput>& out) {
  if (p.empty()) {
    std::string text = head;
    for (const double v : values) text += fmt::format("{:7.2f}", v * scale);
    return answer(text + "\r\n", out);
  }
  if (p.size() > N) return refuse(out_of_range, out);
  std::array<double, N> given = values;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].empty()) continue;  // an empty field leaves the value unchanged
    const auto value = to_number(p[i]);
    if (!value) return refuse(not_a_number, out);
    given[i] = *value / scale;
  }
  values = given;
}

void FastrakTwin::set_alignment(Station& s, const std::string& head, const Parameters& p,
                                std::vector<TwinOutput>& out) {
  std::array<double, 9> points = s.points;
  set_numbers(points, units_per_cm(), head, p, out);
  if (p.empty()) return;
  const Vec3 o(points.data()), x = Vec3(points.data() + 3) - o, y = Vec3(points.data() + 6) - o;
  const Vec3 z = x.cross(y);
  if (z.norm() < 1e-9) return refuse(out_of_range, out);
  Mat3 axes;
  axes << x.normalized(), z.cross(x).normalized(), z.normalized();
  s.points = points;
  s.alignment = s.alignment * Pose{o, Quat(axes)};  // incremental: given in the current alignment frame
}

void FastrakTwin::refuse(int code, std::vector<TwinOutput>& out) const {
  answer(fmt::format("2 E*ERROR*{}*ERROR* EC {}\r\n", pending_, code), out);
}

std::string FastrakTwin::status_record() const {
  const int flags =
      (settings_.binary ? 1 : 0) | (settings_.centimetres ? 2 : 0) | (settings_.continuous ? 8 : 0);
  return fmt::format("21S3F{:X}000      {:<6}{:<32}\r\n", flags, "TWIN01", "Simulated 3SPACE Fastrak");
}

FastrakTwin::Reading FastrakTwin::measure(std::size_t station, std::int64_t now_ns) {
  const Station& s = settings_.stations[station];
  const Pose moved = options_.script.pose(station, clock_.seconds(now_ns), options_.timing.loop);
  const Pose device = options_.room_device.inverse() * moved * options_.tip.inverse();
  Pose seen = fastrak::to_transmitter(options_.field.report(device));
  seen.p *= 100;  // m to cm
  std::normal_distribution<double> normal;
  if (options_.noise_cm > 0)
    for (int i = 0; i < 3; ++i) seen.p[i] += options_.noise_cm * normal(random_);
  if (options_.noise_deg > 0)
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())})
      seen.q = seen.q * Eigen::AngleAxisd(options_.noise_deg * M_PI / 180 * normal(random_), axis);
  // The field is symmetric: a position and its negative are equivalent; the hemisphere selects one.
  const Vec3 zenith = s.hemisphere.isZero() ? tracked_[station] : s.hemisphere;
  if (seen.p.dot(zenith) < 0) seen.p = -seen.p;
  tracked_[station] = seen.p;
  const Pose aligned = s.alignment.inverse() * seen;
  return {aligned.p, (aligned.q * s.boresight).normalized()};
}

TwinOutput FastrakTwin::record(std::size_t station, std::int64_t now_ns) {
  const Station& s = settings_.stations[station];
  const Reading reading = measure(station, now_ns);
  sent_[station] = reading.position;
  char error = ' ';
  const auto angles = fastrak::euler_angles(reading.orientation);
  for (std::size_t i = 0; i < 3; ++i)
    if (angles[i] > s.angle_limits[i] || angles[i] < s.angle_limits[i + 3]) error = 'y';
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = reading.position[static_cast<Eigen::Index>(i)];
    if (x > s.position_limits[i] || x < s.position_limits[i + 3]) error = 'x';
  }

  TwinOutput out;
  out.is_record = true;
  out.station = static_cast<std::uint32_t>(station);
  out.record = records_[station]++;
  out.bytes = {'0', static_cast<std::uint8_t>('1' + station), static_cast<std::uint8_t>(error)};
  for (const int code : s.items) {
    if (code == 0) out.bytes.push_back(' ');
    if (code == 1) out.bytes.insert(out.bytes.end(), {'\r', '\n'});
    if (code == 16 && settings_.binary) out.bytes.push_back(' ');
    if (code == 16) out.bytes.push_back('0');
    if (code == 0 || code == 1 || code == 16) continue;
    const int decimals = fastrak::find_item(code)->decimals;
    for (const double v : item_values(code, reading.position * units_per_cm(), reading.orientation))
      out.values.push_back(put(v, decimals, settings_.binary, out.bytes));
  }
  return out;
}

std::size_t FastrakTwin::active_count() const {
  return static_cast<std::size_t>(std::count_if(settings_.stations.begin(), settings_.stations.end(),
                                                [](const Station& s) { return s.active; }));
}

void FastrakTwin::produce(std::int64_t now_ns, std::vector<TwinOutput>& out) {
  if (!settings_.continuous || suspended_ || active_count() == 0 || now_ns < next_ns_) return;
  next_ns_ += (1 + (now_ns - next_ns_) / cycle_ns) * cycle_ns;  // missed slots are skipped
  while (!settings_.stations[next_station_ % max_stations].active) ++next_station_;
  const std::size_t station = next_station_++ % max_stations;
  const Station& s = settings_.stations[station];
  if (now_ns < busy_ns_) {
    --next_station_;  // the line is busy: skips this slot and keeps the station order
    return;
  }
  if (s.increment > 0 && (measure(station, now_ns).position - sent_[station]).norm() < s.increment) return;
  out.push_back(record(station, now_ns));
  constexpr std::int64_t bits_per_byte = 10;
  const auto bits = static_cast<std::int64_t>(out.back().bytes.size()) * bits_per_byte;
  busy_ns_ = now_ns + bits * ns_per_s / options_.baud;
}

std::int64_t FastrakTwin::due_ns(std::int64_t now_ns) const {
  return settings_.continuous ? next_ns_ : now_ns + cycle_ns;
}

}  // namespace prosector
