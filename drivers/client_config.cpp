#include "drivers/client_config.h"

#include <fmt/format.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <cmath>
#include <optional>
#include <set>

#include "common/error.h"
#include "common/regular_file.h"
#include "common/toml_nesting.h"
#include "drivers/gesture.h"

namespace prosector {
namespace {

/// One table of the file. Reads keys with their checks, and refuses those that nobody read.
class Section {
 public:
  Section(const toml::table& table, std::string name, std::string file)
      : table_(table), name_(std::move(name)), file_(std::move(file)) {}

  template <class T>
  std::optional<T> value(std::string_view key, const char* allowed) {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const auto v = node->value_exact<T>();
    if (!v) fail(*node, key, fmt::format("must be {}", allowed));
    return v;
  }

  void read(std::string_view key, std::string& out) {
    out = value<std::string>(key, "a string").value_or(out);
  }
  void read(std::string_view key, bool& out) { out = value<bool>(key, "true or false").value_or(out); }

  void read(std::string_view key, double& out, double least, double most) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const auto v = node->is_number() ? node->value<double>() : std::nullopt;
    if (!v || !(*v >= least && *v <= most))
      fail(*node, key, fmt::format("must be a number from {} to {}", least, most));
    out = *v;
  }

  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(std::string_view key, double limit) {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const std::string allowed = fmt::format("must be {} numbers within ±{}", N, limit);
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() != N) fail(*node, key, allowed);
    std::array<double, N> out{};
    for (std::size_t i = 0; i < N; ++i) {
      const auto v = (*array)[i].is_number() ? (*array)[i].value<double>() : std::nullopt;
      if (!v || !(std::abs(*v) <= limit)) fail(*node, key, allowed);
      out[i] = *v;
    }
    return out;
  }

  std::optional<Section> section(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) return std::nullopt;
    const toml::table* table = node->as_table();
    if (table == nullptr) fail(*node, key, "must be a table");
    return Section(*table, name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key), file_);
  }

  /// Throws InputError for a key that nobody read. Called after the last read.
  void finish() const {
    std::string known;
    for (const std::string& k : known_) known += (known.empty() ? "" : ", ") + k;
    for (const auto& [key, node] : table_)
      if (!known_.contains(std::string(key.str())))
        fail(node, key.str(), fmt::format("unknown key; allowed here are {}", known));
  }

  [[noreturn]] void fail(std::string_view key, const std::string& what) const {
    const toml::node* node = table_.get(key);
    fail(node == nullptr ? static_cast<const toml::node&>(table_) : *node, key, what);
  }

 private:
  const toml::node* find(std::string_view key) {
    known_.emplace(key);
    return table_.get(key);
  }

  [[noreturn]] void fail(const toml::node& node, std::string_view key, const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}{}{}: {}", file_, node.source().begin.line, name_,
                                 name_.empty() ? "" : ".", key, what));
  }

  const toml::table& table_;
  std::string name_, file_;
  std::set<std::string> known_;
};

constexpr double max_device_count = 65535;
constexpr double max_alignment_cm = 1000;

void check_address(const Section& section, const std::string& address) {
  try {
    parse_device_address(address);
  } catch (const InputError& e) {
    section.fail("address", e.what());
  }
}

/// Reads `position` and `orientation` (w, x, y, z) of a table.
Pose read_pose(Section section) {
  Pose pose;
  if (const auto p = section.numbers<3>("position", max_coordinate)) pose.p = Vec3(p->data());
  if (const auto q = section.numbers<4>("orientation", 1)) pose.q = Quat((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
  if (std::abs(pose.q.norm() - 1) > 0.01) section.fail("orientation", "must be a unit quaternion w, x, y, z");
  pose.q.normalize();
  section.finish();
  return pose;
}

struct RoleName {
  const char* name;
  StationRole role;
};
constexpr std::array<RoleName, 3> role_names = {
    {{"head", StationRole::head}, {"right", StationRole::right_hand}, {"left", StationRole::left_hand}}};

/// Reads which receiver (counted from 1) is fixed to what, and how.
void read_stations(Section section, ClientConfig& config) {
  config.stations.fill(StationRole::none);
  config.tracker_device.stations = 0;
  for (const RoleName& r : role_names) {
    auto role = section.section(r.name);
    if (!role) continue;
    double station = 0;
    role->read("station", station, 1, max_stations);
    if (station != std::floor(station) || station < 1)
      role->fail("station", fmt::format("must be a whole number from 1 to {}", max_stations));
    const auto index = static_cast<std::size_t>(station) - 1;
    if (config.stations[index] != StationRole::none) role->fail("station", "is another role's already");
    config.stations[index] = r.role;
    config.tracker_device.stations |= 1u << index;
    if (auto mount = role->section("mount")) config.tracker_device.mount[index] = read_pose(*mount);
    role->finish();
  }
  section.finish();
  if (config.tracker_device.stations == 0) section.fail("right", "name at least one of head, right, left");
}

void read_tracker(Section section, ClientConfig& config) {
  DeviceConfig& device = config.tracker_device;
  section.read("address", config.tracker);
  if (config.tracker.empty()) section.fail("address", "must be given, as in \"fastrak:/dev/ttyS0\"");
  check_address(section, config.tracker);
  section.read("binary", device.binary);
  section.read("boresight", device.boresight);
  if (const auto h = section.numbers<3>("hemisphere", 1)) device.hemisphere = Vec3(h->data());
  device.alignment = section.numbers<9>("alignment", max_alignment_cm);
  if (device.alignment) {
    const auto& a = *device.alignment;
    const Vec3 o(a.data()), x(a.data() + 3), y(a.data() + 6);
    if ((x - o).cross(y - o).norm() < 1e-6)
      section.fail("alignment", "its three points must not lie on a line");
  }
  if (auto room = section.section("room")) device.room_device = read_pose(*room);
  if (auto stations = section.section("stations")) read_stations(*stations, config);
  section.finish();
}

void read_glove(Section section, GloveSettings& glove) {
  DeviceConfig& device = glove.device;
  section.read("address", glove.address);
  if (glove.address.empty()) section.fail("address", "must be given, as in \"5dt:/dev/ttyS1\"");
  check_address(section, glove.address);
  section.read("closed_above", device.closed_above, 0, 1);
  section.read("open_below", device.open_below, 0, 1);
  section.read("hysteresis", device.hysteresis, 0, 0.5);
  if (device.closed_above - device.open_below <= device.hysteresis)
    section.fail("closed_above", "must exceed open_below by more than hysteresis");
  section.read("pinch", device.pinch);
  section.read("falls_on_bending", device.falls_on_bending);
  const auto open = section.numbers<fingers>("open", max_device_count);
  const auto closed = section.numbers<fingers>("closed", max_device_count);
  if (open.has_value() != closed.has_value())
    section.fail(open ? "open" : "closed", "open and closed must be given together");
  if (open) device.calibration = {*open, *closed};
  if (open)
    for (std::size_t i = 0; i < fingers; ++i)
      if ((*open)[i] == (*closed)[i]) section.fail("closed", "must differ from open for every finger");
  section.finish();
}

void read_arm(Section section, ArmSettings& arm) {
  section.read("address", arm.address);
  if (arm.address.empty()) section.fail("address", "must be given, as in \"omni-twin:/tmp/omni\"");
  try {
    parse_arm_address(arm.address);
  } catch (const InputError& e) {
    section.fail("address", e.what());
  }
  if (const auto hand = section.value<std::string>("hand", "\"left\" or \"right\"")) {
    if (*hand != "left" && *hand != "right") section.fail("hand", "must be \"left\" or \"right\"");
    arm.hand = *hand == "left" ? left_hand : right_hand;
  }
  double button = 0;
  section.read("dead_man", button, 1, arm_buttons);
  if (button != std::floor(button))
    section.fail("dead_man", fmt::format("must be a whole number from 1 to {}", arm_buttons));
  arm.dead_man = static_cast<unsigned>(button);
  if (auto room = section.section("room")) arm.arm.room_arm = read_pose(*room);
  if (auto mount = section.section("mount")) arm.mount = read_pose(*mount);
  section.finish();
}

struct EventName {
  const char* name;
  GestureEvent event;
};
constexpr std::array<EventName, 6> event_names = {{{"none", GestureEvent::none},
                                                   {"grasp", GestureEvent::grasp},
                                                   {"release", GestureEvent::release},
                                                   {"reset", GestureEvent::reset},
                                                   {"panel", GestureEvent::panel},
                                                   {"parts", GestureEvent::parts}}};
constexpr const char* allowed_events = "none, grasp, release, reset, panel or parts";

void read_gestures(Section section, ClientConfig& config) {
  config.gestures.clear();
  for (const GestureRow& row : gesture_table()) {
    if (row.gesture == Gesture::none) continue;
    const auto name = section.value<std::string>(row.name, allowed_events);
    if (!name) continue;
    bool found = false;
    for (const EventName& e : event_names) {
      if (*name != e.name) continue;
      found = true;
      if (e.event != GestureEvent::none) config.gestures[row.gesture] = e.event;
    }
    if (!found) section.fail(row.name, fmt::format("must be {}", allowed_events));
  }
  section.finish();
}

}  // namespace

ClientConfig parse_client_config(std::string_view toml, const std::string& file) {
  check_nesting(toml, file);
  toml::table table;
  try {
    table = toml::parse(toml, file);
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}:{}: {}", file, e.source().begin.line, e.description()));
  }
  ClientConfig config;
  Section root(table, "", file);
  if (auto tracker = root.section("tracker")) read_tracker(*tracker, config);
  if (auto glove = root.section("glove")) {
    if (auto right = glove->section("right")) read_glove(*right, config.gloves[right_hand]);
    if (auto left = glove->section("left")) read_glove(*left, config.gloves[left_hand]);
    glove->finish();
  }
  if (auto arm = root.section("arm")) read_arm(*arm, config.arm);
  if (auto gestures = root.section("gestures")) read_gestures(*gestures, config);
  root.finish();
  return config;
}

ClientConfig load_client_config(const std::filesystem::path& file) {
  constexpr std::size_t max_bytes = 1 << 20;
  return parse_client_config(read_regular_file(file, max_bytes), file.string());
}

}  // namespace prosector
