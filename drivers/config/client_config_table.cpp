#include "drivers/config/client_config_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/error.h"
#include "drivers/device/driver_table.h"
#include "drivers/device/gesture.h"

namespace prosector {
namespace {

constexpr double max_device_count = 65535;
constexpr double max_frame_point = 10;  // m
constexpr double cm_per_m = 100;
constexpr double degree = std::numbers::pi / 180;

using Keys = std::vector<ConfigKey>;
using Numbers = std::vector<double>;

struct RoleName {
  const char* name;
  StationRole role;
  const char* board;  // default board of the role in a camera's view
  const char* help;
};
constexpr std::array<RoleName, 5> role_names = {
    {{"head", StationRole::head, "head", "the head; its pose is at the point between the eyes"},
     {"right", StationRole::right_hand, "wrist-right", "the right hand; its pose is the wrist"},
     {"left", StationRole::left_hand, "wrist-left", "the left hand; its pose is the wrist"},
     {"instrument", StationRole::instrument, "instrument",
      "an instrument that touches points in calibration and operates panels; its pose is the tip"},
     {"tablet", StationRole::tablet, "tablet",
      "a hand-held board that serves as the panel; its pose is the centre of its front: x right, y up"}}};

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

/// Creates a key for a flag, number or text member that `in` returns.
template <class T>
ConfigKey plain(std::string name, std::string member, T& (*in)(ClientConfig&), std::string unit,
                std::string help) {
  ConfigKey key;
  key.name = std::move(name);
  key.member = std::move(member);
  key.unit = std::move(unit);
  key.help = std::move(help);
  key.type = std::is_same_v<T, bool>          ? ConfigType::flag
             : std::is_same_v<T, std::string> ? ConfigType::text
                                              : ConfigType::number;
  key.set = [in](ClientConfig& c, const ConfigValue& v) { in(c) = std::get<T>(v); };
  key.get = [in](const ClientConfig& c) -> std::optional<ConfigValue> {
    ClientConfig copy = c;
    return ConfigValue(in(copy));
  };
  return key;
}

ConfigKey ranged(ConfigKey key, double least, double most) {
  key.least = least;
  key.most = most;
  return key;
}

/// Creates the key of a device or arm address, which must name a known driver.
ConfigKey address(std::string name, std::string member, std::string& (*in)(ClientConfig&),
                  std::string example, std::string help, bool arm) {
  ConfigKey key = plain<std::string>(std::move(name), std::move(member), in, "", std::move(help));
  key.needed = std::move(example);
  key.set = [in, arm](ClientConfig& c, const ConfigValue& v) {
    in(c) = std::get<std::string>(v);
    if (in(c).empty()) return;  // no device now; the other keys of the table stay
    if (arm)
      (void)parse_arm_address(in(c));
    else
      (void)parse_device_address(in(c));
  };
  key.get = [in](const ClientConfig& c) -> std::optional<ConfigValue> {
    ClientConfig copy = c;
    if (in(copy).empty()) return std::nullopt;
    return ConfigValue(in(copy));
  };
  return key;
}

using FindPose = std::function<Pose*(ClientConfig&)>;  // nullptr: the pose does not exist

/// Adds the keys `position` and `orientation` of a pose. Without `shown`, an identity pose is reported as not
/// set.
void add_pose(Keys& keys, const std::string& table, const std::string& member, const FindPose& in,
              const std::string& what, bool shown = true) {
  const auto pose_of = [in, shown](const ClientConfig& c) -> std::optional<Pose> {
    ClientConfig copy = c;
    const Pose* pose = in(copy);
    if (pose == nullptr || (!shown && pose->p.isZero() && pose->q.isApprox(Quat::Identity())))
      return std::nullopt;
    return *pose;
  };
  ConfigKey position;
  position.name = table + ".position";
  position.member = member + ".p";
  position.type = ConfigType::numbers;
  position.count = 3;
  position.most = max_coordinate;
  position.unit = "m";
  position.help = what;
  position.set = [in](ClientConfig& c, const ConfigValue& v) {
    if (Pose* pose = in(c)) pose->p = Vec3(std::get<Numbers>(v).data());
  };
  position.get = [pose_of](const ClientConfig& c) -> std::optional<ConfigValue> {
    const auto pose = pose_of(c);
    if (!pose) return std::nullopt;
    return Numbers{pose->p.x(), pose->p.y(), pose->p.z()};
  };
  keys.push_back(position);
  ConfigKey turn = position;
  turn.name = table + ".orientation";
  turn.member = member + ".q";
  turn.count = 4;
  turn.most = 1;
  turn.unit = "";
  turn.help = "w, x, y, z";
  turn.set = [in](ClientConfig& c, const ConfigValue& v) {
    const Numbers& q = std::get<Numbers>(v);
    const Quat read(q[0], q[1], q[2], q[3]);
    if (std::abs(read.norm() - 1) > 0.01) throw InputError("must be a unit quaternion w, x, y, z");
    if (Pose* pose = in(c)) pose->q = read.normalized();
  };
  turn.get = [pose_of](const ClientConfig& c) -> std::optional<ConfigValue> {
    const auto pose = pose_of(c);
    if (!pose) return std::nullopt;
    return Numbers{pose->q.w(), pose->q.x(), pose->q.y(), pose->q.z()};
  };
  keys.push_back(turn);
}

std::optional<std::size_t> station_of(const ClientConfig& config, StationRole role) {
  const auto at = std::find(config.stations.begin(), config.stations.end(), role);
  if (at == config.stations.end()) return std::nullopt;
  return static_cast<std::size_t>(at - config.stations.begin());
}

void add_stations(Keys& keys) {
  for (const RoleName& row : role_names) {
    const StationRole role = row.role;
    const std::string table = fmt::format("tracker.stations.{}", row.name);
    ConfigKey station;
    station.name = table + ".station";
    station.member = "stations";
    station.type = ConfigType::whole;
    station.least = 0;
    station.most = max_stations;
    station.needed = "1";
    station.help = "number of the role's receiver, from 1; 0: none, its mount is preserved";
    station.set = [role](ClientConfig& c, const ConfigValue& v) {
      const auto number = static_cast<std::size_t>(std::get<double>(v));
      if (number == 0) return;
      const std::size_t index = number - 1;
      if (c.stations[index] != StationRole::none)
        throw InputError("this receiver is already assigned to another role: choose another receiver");
      c.stations[index] = role;
      c.tracker_device.placement.stations |= 1u << index;
    };
    station.get = [role](const ClientConfig& c) -> std::optional<ConfigValue> {
      const auto index = station_of(c, role);
      if (!index) return std::nullopt;
      return ConfigValue(static_cast<double>(*index + 1));
    };
    keys.push_back(station);
    add_pose(
        keys, table + ".mount", "tracker_device.placement.mount",
        [role](ClientConfig& c) -> Pose* {
          const auto index = station_of(c, role);
          return index ? &c.tracker_device.placement.mount[*index] : nullptr;
        },
        "pose of the tracked point (wrist, eyes, tip) in the receiver's frame");
    ConfigKey board;
    board.name = table + ".board";
    board.member = "tracker_device.tags.boards";
    board.help =
        "camera tracking: the role's board, a known one (prosector-board --list) or a file beside this one; "
        "default: the standard board of the role";
    board.set = [role](ClientConfig& c, const ConfigValue& v) {
      if (const auto index = station_of(c, role))
        c.tracker_device.tags.boards[*index] = std::get<std::string>(v);
    };
    board.get = [role, usual = std::string(row.board)](const ClientConfig& c) -> std::optional<ConfigValue> {
      const auto index = station_of(c, role);
      if (!index || c.tracker_device.tags.boards[*index].empty() ||
          c.tracker_device.tags.boards[*index] == usual)
        return std::nullopt;
      return ConfigValue(c.tracker_device.tags.boards[*index]);
    };
    keys.push_back(board);
    if (role == StationRole::instrument)
      keys.push_back(plain<std::string>(
          table + ".tool", "tool", [](ClientConfig& c) -> std::string& { return c.tool; }, "",
          "blade of the scene that the instrument represents, e.g. \"scalpel\", in the right hand; empty: "
          "none"));
  }
}

/// Adds the hemisphere of the FASTRAK's transmitter, a direction.
void add_hemisphere(Keys& keys) {
  ConfigKey hemisphere;
  hemisphere.name = "tracker.hemisphere";
  hemisphere.member = "tracker_device.fastrak.hemisphere";
  hemisphere.type = ConfigType::numbers;
  hemisphere.count = 3;
  hemisphere.most = 1;
  hemisphere.help = "hemisphere of the transmitter that contains the receivers: X forward, Y right, Z down";
  hemisphere.set = [](ClientConfig& c, const ConfigValue& v) {
    c.tracker_device.fastrak.hemisphere = Vec3(std::get<Numbers>(v).data());
  };
  hemisphere.get = [](const ClientConfig& c) -> std::optional<ConfigValue> {
    const Vec3& h = c.tracker_device.fastrak.hemisphere;
    return Numbers{h.x(), h.y(), h.z()};
  };
  keys.push_back(hemisphere);
}

/// Adds the FASTRAK's own alignment frame: three points.
void add_alignment_frame(Keys& keys) {
  ConfigKey frame;
  frame.name = "tracker.alignment_frame";
  frame.member = "tracker_device.fastrak.alignment";
  frame.type = ConfigType::numbers;
  frame.count = 9;
  frame.most = max_frame_point;
  frame.unit = "m";
  frame.help = "the FASTRAK's alignment frame: origin, a point on +X, a point on +Y";
  frame.set = [](ClientConfig& c, const ConfigValue& v) {
    std::array<double, 9> a{};
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = cm_per_m * std::get<Numbers>(v)[i];
    const Vec3 o(a.data()), x(a.data() + 3), y(a.data() + 6);
    if ((x - o).cross(y - o).norm() < 1e-6)
      throw InputError("the three points of the alignment frame must not lie on one line");
    c.tracker_device.fastrak.alignment = a;
  };
  frame.get = [](const ClientConfig& c) -> std::optional<ConfigValue> {
    if (!c.tracker_device.fastrak.alignment) return std::nullopt;
    Numbers out;
    for (const double x : *c.tracker_device.fastrak.alignment) out.push_back(x / cm_per_m);
    return out;
  };
  keys.push_back(frame);
}

/// Adds the keys of the FASTRAK itself: its records, boresight, hemisphere and alignment frame.
void add_fastrak(Keys& keys) {
  keys.push_back(plain<bool>(
      "tracker.binary", "tracker_device.fastrak.binary",
      [](ClientConfig& c) -> bool& { return c.tracker_device.fastrak.binary; }, "",
      "binary records; false: ASCII"));
  keys.push_back(plain<bool>(
      "tracker.boresight", "tracker_device.fastrak.boresight",
      [](ClientConfig& c) -> bool& { return c.tracker_device.fastrak.boresight; }, "",
      "true: each receiver's orientation at start becomes forward"));
  add_hemisphere(keys);
  add_alignment_frame(keys);
}

/// Adds the length of the user's hand.
void add_hand_length(Keys& keys) {
  ConfigKey length;
  length.name = "tracker.hand_length";
  length.member = "tracker_device.hands.hand_length";
  length.type = ConfigType::number;
  length.least = 0.1;
  length.most = 0.3;
  length.unit = "m";
  length.help =
      "bare hands: length from the wrist crease to the middle finger's tip; default 0.191; depth has the "
      "same relative error";
  length.set = [](ClientConfig& c, const ConfigValue& v) {
    c.tracker_device.hands.hand_length = std::get<double>(v);
  };
  length.get = [](const ClientConfig& c) -> std::optional<ConfigValue> {
    if (!c.tracker_device.hands.hand_length) return std::nullopt;
    return ConfigValue(*c.tracker_device.hands.hand_length);
  };
  keys.push_back(length);
}

/// Adds the choice of the networks that find bare hands.
void add_hand_networks(Keys& keys) {
  ConfigKey networks;
  networks.name = "tracker.hand_networks";
  networks.member = "tracker_device.hands.hand_nets";
  networks.choices = {"full", "lite"};
  networks.help = "bare hands: networks; `lite` takes two thirds of the time and is less accurate";
  networks.set = [](ClientConfig& c, const ConfigValue& v) {
    c.tracker_device.hands.hand_nets = std::get<std::string>(v) == "lite" ? HandNets::lite : HandNets::full;
  };
  networks.get = [](const ClientConfig& c) -> std::optional<ConfigValue> {
    return ConfigValue(std::string(c.tracker_device.hands.hand_nets == HandNets::lite ? "lite" : "full"));
  };
  keys.push_back(networks);
}

/// Adds the keys of bare hands seen by one or two cameras: the hand, its networks, and the second camera.
void add_bare_hands(Keys& keys) {
  add_hand_length(keys);
  add_hand_networks(keys);
  keys.push_back(ranged(plain<double>(
                            "tracker.farthest_hand", "tracker_device.hands.farthest_hand",
                            [](ClientConfig& c) -> double& { return c.tracker_device.hands.farthest_hand; },
                            "m", "bare hands: distance from the camera beyond which hands are ignored"),
                        0.3, 5));
  keys.push_back(plain<std::string>(
      "tracker.second_lens", "tracker_device.hands.second_lens",
      [](ClientConfig& c) -> std::string& { return c.tracker_device.hands.second_lens; }, "",
      "bare hands: lens file of the second camera, in this file's folder; empty: estimated lens"));
  add_pose(
      keys, "tracker.second", "tracker_device.hands.first_second",
      [](ClientConfig& c) { return &c.tracker_device.hands.first_second; },
      "bare hands: pose of the second camera in the first one's frame: x right, y up, −z forward");
}

/// Adds the fixed board that defines the room's frame for a camera.
void add_table_board(Keys& keys) {
  keys.push_back(plain<std::string>(
      "tracker.table.board", "tracker_device.camera.table",
      [](ClientConfig& c) -> std::string& { return c.tracker_device.camera.table; }, "",
      "camera tracking: the fixed board that defines the room frame; empty: the camera is fixed"));
  add_pose(
      keys, "tracker.table", "tracker_device.camera.room_table",
      [](ClientConfig& c) { return &c.tracker_device.camera.room_table; },
      "pose of the table's board; its z axis points up if it lies flat");
}

void add_tracker(Keys& keys) {
  keys.push_back(address(
      "tracker.address", "tracker", [](ClientConfig& c) -> std::string& { return c.tracker; },
      "\"fastrak:/dev/ttyS0\"", "the tracker, DRIVER:PATH; empty: none", false));
  add_fastrak(keys);
  keys.push_back(plain<std::string>(
      "tracker.field_map", "tracker_device.placement.field_map",
      [](ClientConfig& c) -> std::string& { return c.tracker_device.placement.field_map; }, "",
      "field map: file written by `calibrate field`, beside this one; empty: none"));
  add_pose(
      keys, "tracker.room", "tracker_device.placement.room_device",
      [](ClientConfig& c) { return &c.tracker_device.placement.room_device; },
      "pose of the transmitter or the camera: x right, y up, −z forward");
  keys.push_back(plain<std::string>(
      "tracker.lens", "tracker_device.camera.lens",
      [](ClientConfig& c) -> std::string& { return c.tracker_device.camera.lens; }, "",
      "camera tracking: file written by `camera calibrate`, beside this one; empty: estimated lens"));
  add_bare_hands(keys);
  add_table_board(keys);
  add_stations(keys);
}

/// Adds a glove's fixed counts of the open or of the closed fingers.
void add_counts(Keys& keys, const std::string& table, std::size_t hand, bool open) {
  ConfigKey key;
  key.name = table + (open ? ".open" : ".closed");
  key.member = fmt::format("gloves[].device.glove.calibration.{}", open ? "open" : "closed");
  key.type = ConfigType::numbers;
  key.count = fingers;
  key.most = max_device_count;
  key.unit = "counts";
  key.help =
      open ? "sensor counts of extended fingers, thumb to little; default: learnt from the observed range"
           : "sensor counts of bent fingers; give it together with `open`";
  key.set = [hand, open](ClientConfig& c, const ConfigValue& v) {
    auto& calibration = c.gloves[hand].device.glove.calibration;
    if (!calibration) {
      calibration.emplace();
      calibration->open.fill(std::numeric_limits<double>::quiet_NaN());
      calibration->closed.fill(std::numeric_limits<double>::quiet_NaN());
    }
    std::copy_n(std::get<Numbers>(v).begin(), fingers,
                (open ? calibration->open : calibration->closed).begin());
  };
  key.get = [hand, open](const ClientConfig& c) -> std::optional<ConfigValue> {
    const auto& calibration = c.gloves[hand].device.glove.calibration;
    if (!calibration) return std::nullopt;
    const auto& counts = open ? calibration->open : calibration->closed;
    return Numbers(counts.begin(), counts.end());
  };
  keys.push_back(key);
}

template <std::size_t Hand>
void add_glove(Keys& keys) {
  const std::string table = Hand == right_hand ? "glove.right" : "glove.left";
  const std::string in = "gloves[].device.";
  keys.push_back(address(
      table + ".address", "gloves[].address",
      [](ClientConfig& c) -> std::string& { return c.gloves[Hand].address; }, "\"5dt:/dev/ttyS1\"",
      "the glove, DRIVER:PATH; empty: none", false));
  keys.push_back(
      ranged(plain<double>(
                 table + ".closed_above", in + "gestures.closed_above",
                 [](ClientConfig& c) -> double& { return c.gloves[Hand].device.gestures.closed_above; },
                 "flexion", "a finger with larger flexion is closed"),
             0, 1));
  keys.push_back(
      ranged(plain<double>(
                 table + ".open_below", in + "gestures.open_below",
                 [](ClientConfig& c) -> double& { return c.gloves[Hand].device.gestures.open_below; },
                 "flexion", "a finger with smaller flexion is open; no gesture in between"),
             0, 1));
  keys.push_back(
      ranged(plain<double>(
                 table + ".hysteresis", in + "gestures.hysteresis",
                 [](ClientConfig& c) -> double& { return c.gloves[Hand].device.gestures.hysteresis; },
                 "flexion", "hysteresis: distance past a threshold at which a finger changes its state"),
             0, 0.5));
  keys.push_back(plain<bool>(
      table + ".pinch", in + "gestures.pinch",
      [](ClientConfig& c) -> bool& { return c.gloves[Hand].device.gestures.pinch; }, "",
      "true: index finger closed, thumb bent, the others open, is the gesture `pinch`"));
  keys.push_back(plain<bool>(
      table + ".falls_on_bending", in + "glove.falls_on_bending",
      [](ClientConfig& c) -> bool& { return c.gloves[Hand].device.glove.falls_on_bending; }, "",
      "true if sensor counts decrease as a finger bends"));
  add_counts(keys, table, Hand, true);
  add_counts(keys, table, Hand, false);
}

void add_arm(Keys& keys) {
  keys.push_back(address(
      "arm.address", "arm.address", [](ClientConfig& c) -> std::string& { return c.arm.address; },
      "\"omni-twin:/tmp/omni\"", "the haptic arm, DRIVER:PATH; empty: none", true));
  ConfigKey hand;
  hand.name = "arm.hand";
  hand.member = "arm.hand";
  hand.choices = {"left", "right"};
  hand.help = "hand that it moves";
  hand.set = [](ClientConfig& c, const ConfigValue& v) {
    c.arm.hand = std::get<std::string>(v) == "left" ? left_hand : right_hand;
  };
  hand.get = [](const ClientConfig& c) -> std::optional<ConfigValue> {
    return ConfigValue(std::string(c.arm.hand == left_hand ? "left" : "right"));
  };
  keys.push_back(hand);
  ConfigKey button;
  button.name = "arm.dead_man";
  button.member = "arm.dead_man";
  button.type = ConfigType::whole;
  button.least = 1;
  button.most = arm_buttons;
  button.help = "dead-man button, from 1, that must be pressed for forces; default: none";
  button.set = [](ClientConfig& c, const ConfigValue& v) {
    c.arm.dead_man = static_cast<unsigned>(std::get<double>(v));
  };
  button.get = [](const ClientConfig& c) -> std::optional<ConfigValue> {
    if (c.arm.dead_man == 0) return std::nullopt;
    return ConfigValue(static_cast<double>(c.arm.dead_man));
  };
  keys.push_back(button);
  add_pose(
      keys, "arm.room", "arm.arm.room_arm", [](ClientConfig& c) { return &c.arm.arm.room_arm; },
      "pose of the arm: x right, y up, z towards you");
  add_pose(
      keys, "arm.mount", "arm.mount", [](ClientConfig& c) { return c.arm.mount ? &*c.arm.mount : nullptr; },
      "pose of the wrist in the stylus frame; default: the index finger's tip at the stylus tip");
}

void add_gestures(Keys& keys) {
  for (const GestureRow& row : gesture_table()) {
    if (row.gesture == Gesture::none) continue;
    ConfigKey key;
    key.name = fmt::format("gestures.{}", row.name);
    key.member = "gestures";
    for (const EventName& e : event_names) key.choices.emplace_back(e.name);
    const Gesture plain = without_thumb(row.gesture);
    key.help = "action of this gesture";
    if (plain != row.gesture) key.help += fmt::format("; none: action of {}", gesture_name(plain));
    key.set = [gesture = row.gesture](ClientConfig& c, const ConfigValue& v) {
      const auto event = std::find_if(event_names.begin(), event_names.end(),
                                      [&](const EventName& e) { return e.name == std::get<std::string>(v); });
      if (event->event == GestureEvent::none)
        c.gestures.erase(gesture);
      else
        c.gestures[gesture] = event->event;
    };
    key.get = [gesture = row.gesture](const ClientConfig& c) -> std::optional<ConfigValue> {
      const auto at = c.gestures.find(gesture);
      const GestureEvent asked = at == c.gestures.end() ? GestureEvent::none : at->second;
      return ConfigValue(std::string(event_names[static_cast<std::size_t>(asked)].name));
    };
    keys.push_back(key);
  }
}

/// Adds a measured value of the eyes or the display. `scale` is the file's unit in the program's unit.
void add_eye_value(Keys& keys, const char* name, std::optional<double> EyeSettings::*in, double least,
                   double most, double scale, const char* unit, const char* help) {
  ConfigKey key;
  key.name = fmt::format("eyes.{}", name);
  key.member = fmt::format("eyes.{}", name);
  key.type = ConfigType::number;
  key.least = least;
  key.most = most;
  key.unit = unit;
  key.help = help;
  key.set = [in, scale](ClientConfig& c, const ConfigValue& v) { c.eyes.*in = scale * std::get<double>(v); };
  key.get = [in, scale](const ClientConfig& c) -> std::optional<ConfigValue> {
    if (!(c.eyes.*in)) return std::nullopt;
    return ConfigValue(*(c.eyes.*in) / scale);
  };
  keys.push_back(key);
}

/// Adds the keys of the window screen and of the camera at it.
void add_window(Keys& keys) {
  keys.push_back(address(
      "window.address", "window.address", [](ClientConfig& c) -> std::string& { return c.window.address; },
      "\"face:0\"", "eye tracker, DRIVER:PATH; its station 1 is between the eyes; empty: none", false));
  keys.push_back(plain<std::string>(
      "window.lens", "window.device.camera.lens",
      [](ClientConfig& c) -> std::string& { return c.window.device.camera.lens; }, "",
      "lens: file written by `camera calibrate`, beside this one; empty: estimated lens"));
  keys.push_back(
      ranged(plain<double>(
                 "window.height", "window.height", [](ClientConfig& c) -> double& { return c.window.height; },
                 "m", "height of the image on the screen, measured with a ruler; the width follows from it"),
             0.05, 10));
  ConfigKey mode;
  mode.name = "window.mode";
  mode.member = "window.pans";
  mode.choices = {"window", "pan"};
  mode.help = "`window`: the scene is behind the screen; `pan`: the face rotates the view";
  mode.set = [](ClientConfig& c, const ConfigValue& v) { c.window.pans = std::get<std::string>(v) == "pan"; };
  mode.get = [](const ClientConfig& c) -> std::optional<ConfigValue> {
    return ConfigValue(std::string(c.window.pans ? "pan" : "window"));
  };
  keys.push_back(mode);
  add_pose(
      keys, "window.camera", "window.device.placement.room_device",
      [](ClientConfig& c) { return &c.window.device.placement.room_device; },
      "pose of the camera relative to the centre of the image on the screen: x right, y up, z towards you; "
      "unrotated, it faces you");
}

/// Adds the keys of the phantom, a real body in the camera's image.
void add_phantom(Keys& keys) {
  keys.push_back(plain<std::string>(
      "phantom.body", "phantom.body", [](ClientConfig& c) -> std::string& { return c.phantom.body; }, "",
      "scene body with the phantom's shape; it is not drawn"));
  keys.push_back(plain<std::string>(
      "phantom.mesh", "phantom.mesh", [](ClientConfig& c) -> std::string& { return c.phantom.mesh; }, "",
      "instead of `body`: file with the phantom's shape (OBJ, STL, PLY, OFF, glTF), beside this one"));
  keys.push_back(
      ranged(plain<double>(
                 "phantom.scale", "phantom.scale", [](ClientConfig& c) -> double& { return c.phantom.scale; },
                 "m", "length of the unit of `mesh`"),
             1e-6, 1000));
  keys.push_back(plain<std::string>(
      "phantom.board", "phantom.board", [](ClientConfig& c) -> std::string& { return c.phantom.board; }, "",
      "board fixed to the phantom: a known board's name, or a file beside this one; empty: it does not "
      "move"));
  add_pose(
      keys, "phantom", "phantom.pose",
      [](ClientConfig& c) { return &(c.phantom.pose ? *c.phantom.pose : c.phantom.pose.emplace()); },
      "pose of the phantom on its board, or in the room without a board, written by `calibrate phantom`; "
      "default: the body's pose in the scene",
      false);
}

std::optional<ConfigFault> check_phantom(ClientConfig& config) {
  const PhantomSettings& phantom = config.phantom;
  if (!phantom.body.empty() && !phantom.mesh.empty())
    return ConfigFault{"mesh", "give body or mesh, not both: each defines the shape"};
  if (phantom.has_place() && !phantom.has_shape())
    return ConfigFault{phantom.board.empty() ? "position" : "board",
                       "also give body or mesh, which defines the phantom's shape"};
  return std::nullopt;
}

Keys make_keys() {
  Keys keys;
  ConfigKey version;
  version.name = "version";
  version.member = "–";
  version.type = ConfigType::whole;
  version.least = 1;
  version.most = client_config_version;
  version.help = "version of the file's keys; a file without it has version 1";
  version.set = [](ClientConfig&, const ConfigValue&) {};
  version.get = [](const ClientConfig&) -> std::optional<ConfigValue> { return std::nullopt; };
  keys.push_back(version);
  add_tracker(keys);
  add_glove<right_hand>(keys);
  add_glove<left_hand>(keys);
  add_arm(keys);
  add_gestures(keys);
  add_pose(
      keys, "headset.room", "headset_room", [](ClientConfig& c) { return &c.headset_room; },
      "pose of an OpenXR headset's stage, its centre on the floor: x right, y up, −z forward");
  add_eye_value(keys, "distance", &EyeSettings::distance, 0, 0.2, 1, "m",
                "distance between the pupils; default, as for the other keys here: from the stereo profile");
  add_eye_value(keys, "fov_horizontal", &EyeSettings::fov_horizontal, 1, 170, degree, "degrees",
                "horizontal angle that each eye's image fills");
  add_eye_value(keys, "fov_vertical", &EyeSettings::fov_vertical, 1, 170, degree, "degrees",
                "vertical angle that each eye's image fills");
  add_eye_value(keys, "convergence", &EyeSettings::convergence, 0.05, 1000, 1, "m",
                "distance at which both eyes' images coincide");
  add_window(keys);
  add_phantom(keys);
  return keys;
}

std::optional<ConfigFault> check_glove(ClientConfig& config, std::size_t hand) {
  const DeviceConfig& device = config.gloves[hand].device;
  if (device.gestures.closed_above - device.gestures.open_below <= device.gestures.hysteresis)
    return ConfigFault{"closed_above", "closed_above must exceed open_below by more than hysteresis"};
  if (!device.glove.calibration) return std::nullopt;
  const GloveCalibration& c = *device.glove.calibration;
  if (std::isnan(c.open[0]) || std::isnan(c.closed[0]))
    return ConfigFault{std::isnan(c.open[0]) ? "closed" : "open", "open and closed must be given together"};
  for (std::size_t i = 0; i < fingers; ++i)
    if (c.open[i] == c.closed[i])
      return ConfigFault{"closed", "the counts of closed must differ from those of open for every finger"};
  return std::nullopt;
}

std::vector<ConfigTable> make_tables() {
  std::vector<ConfigTable> tables;
  const auto add = [&](std::string name, std::string help) -> ConfigTable& {
    return tables.emplace_back(ConfigTable{std::move(name), std::move(help), {}, false, {}});
  };
  add("", "");
  add("tracker", "A tracker with one or more receivers.");
  add("tracker.room", "");
  ConfigTable& stations =
      add("tracker.stations", "Assignment of receivers. Without this table receiver 1 is the right hand.");
  stations.whole = true;
  stations.begin = [](ClientConfig& c) {
    c.stations.fill(StationRole::none);
    c.tracker_device.placement.stations = 0;
    c.tracker_device.tags.boards = {};
  };
  stations.finish = [](ClientConfig& c) -> std::optional<ConfigFault> {
    for (const RoleName& row : role_names)
      if (const auto index = station_of(c, row.role); index && c.tracker_device.tags.boards[*index].empty())
        c.tracker_device.tags.boards[*index] = row.board;
    if (c.tracker_device.placement.stations != 0) return std::nullopt;
    return ConfigFault{"right", "give at least one of head, right, left, instrument, tablet a receiver"};
  };
  add("tracker.table", "The fixed board of a camera tracker.");
  add("tracker.second", "The second camera for bare hands.");
  for (const RoleName& row : role_names) {
    add(fmt::format("tracker.stations.{}", row.name), fmt::format("The receiver of {}.", row.help));
    add(fmt::format("tracker.stations.{}.mount", row.name), "");
  }
  add("glove", "");
  add("glove.right", "A glove with five bend sensors.").finish = [](ClientConfig& c) {
    return check_glove(c, right_hand);
  };
  add("glove.left", "The glove of the left hand.").finish = [](ClientConfig& c) {
    return check_glove(c, left_hand);
  };
  add("arm", "A haptic arm: [arms](../do/arms.md).");
  add("arm.room", "");
  add("arm.mount", "").begin = [](ClientConfig& c) { c.arm.mount.emplace(); };
  ConfigTable& gestures =
      add("gestures", "Actions of gestures. If this table is given, gestures not listed have no action.");
  gestures.whole = true;
  gestures.begin = [](ClientConfig& c) { c.gestures.clear(); };
  add("headset", "An OpenXR headset: [join](../do/join.md#with-a-headset-by-openxr).");
  add("headset.room", "");
  add("eyes", "Measurements of the eyes and the display.").finish = [](ClientConfig& c) {
    if (c.eyes.distance.value_or(0) > 0)
      c.tracker_device.face.eye_distance = c.window.device.face.eye_distance = *c.eyes.distance;
    return std::optional<ConfigFault>();
  };
  add("window", "The screen as a window into the room: [window](../do/window.md).");
  add("window.camera", "");
  add("phantom", "A real body that occludes what is behind it: [see-through](../do/see-through.md#phantoms).")
      .finish = check_phantom;
  return tables;
}

}  // namespace

std::span<const ConfigKey> client_config_keys() {
  static const Keys keys = make_keys();
  return keys;
}

std::span<const ConfigTable> client_config_tables() {
  static const std::vector<ConfigTable> tables = make_tables();
  return tables;
}

const ConfigKey* find_config_key(std::string_view name) {
  const auto keys = client_config_keys();
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const ConfigKey& k) { return k.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

std::string allowed_values(const ConfigKey& key) {
  switch (key.type) {
    case ConfigType::flag:
      return "must be true or false";
    case ConfigType::number:
      return fmt::format("must be a number from {} to {}", key.least, key.most);
    case ConfigType::whole:
      return fmt::format("must be a whole number from {} to {}", key.least, key.most);
    case ConfigType::numbers:
      return fmt::format("must be {} numbers within ±{}", key.count, key.most);
    case ConfigType::text:
      break;
  }
  if (key.choices.empty()) return "must be a string";
  const std::vector<std::string> first(key.choices.begin(), key.choices.end() - 1);
  return fmt::format("must be {} or {}", fmt::join(first, ", "), key.choices.back());
}

bool fits(const ConfigKey& key, const ConfigValue& value) {
  const auto within = [](double v, double least, double most) {
    return v >= least && v <= most;
  };  // false for NaN
  switch (key.type) {
    case ConfigType::flag:
      return std::holds_alternative<bool>(value);
    case ConfigType::number:
    case ConfigType::whole: {
      const double* v = std::get_if<double>(&value);
      return v != nullptr && within(*v, key.least, key.most) &&
             (key.type == ConfigType::number || *v == std::floor(*v));
    }
    case ConfigType::numbers: {
      const Numbers* v = std::get_if<Numbers>(&value);
      return v != nullptr && v->size() == key.count &&
             std::all_of(v->begin(), v->end(), [&](double x) { return within(x, -key.most, key.most); });
    }
    case ConfigType::text:
      break;
  }
  const std::string* v = std::get_if<std::string>(&value);
  return v != nullptr &&
         (key.choices.empty() || std::find(key.choices.begin(), key.choices.end(), *v) != key.choices.end());
}

}  // namespace prosector
