#include "drivers/config/client_config_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

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
using Value = std::optional<ConfigValue>;  // nothing: not set

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

/// Returns a pointer to the value of a variable. A const optional without a value gives nullptr; a mutable
/// one is filled first.
template <class T>
T* content(T& variable) {
  return &variable;
}
template <class T>
const T* content(const std::optional<T>& variable) {
  return variable ? &*variable : nullptr;
}
template <class T>
T* content(std::optional<T>& variable) {
  return variable ? &*variable : &variable.emplace();
}
/// Returns the calibration. Fills a new one with NaN, so that check_glove finds counts that the file omits.
GloveCalibration* content(std::optional<GloveCalibration>& variable) {
  if (variable) return &*variable;
  GloveCalibration& calibration = variable.emplace();
  calibration.open.fill(std::numeric_limits<double>::quiet_NaN());
  calibration.closed.fill(std::numeric_limits<double>::quiet_NaN());
  return &calibration;
}

template <class Object>
auto* reach(Object& object) {
  return &object;
}
template <auto First, auto... Rest, class Object>
auto* reach(Object& object) {
  if constexpr (std::is_member_pointer_v<decltype(First)>) {
    auto* found = content(object.*First);
    return found == nullptr ? nullptr : reach<Rest...>(*found);
  } else {
    return reach<Rest...>(object[First]);
  }
}

/// The variable of a configuration at the end of a path of member pointers and array indices. Called with a
/// const configuration it returns nullptr if an optional on the path has no value; otherwise it fills the
/// optional.
template <auto... Path>
struct At {
  template <class Config>
  auto* operator()(Config& config) const {
    return reach<Path...>(config);
  }
};
template <auto... Path>
using InTracker = At<&ClientConfig::tracker_device, Path...>;
template <auto... Path>
using InFastrak = InTracker<&DeviceConfig::fastrak, Path...>;
template <auto... Path>
using InHands = InTracker<&DeviceConfig::hands, Path...>;
template <auto... Path>
using InCamera = InTracker<&DeviceConfig::camera, Path...>;
template <std::size_t Hand, auto... Path>
using InGlove = At<&ClientConfig::gloves, Hand, &GloveSettings::device, Path...>;
template <auto... Path>
using InArm = At<&ClientConfig::arm, Path...>;
template <auto... Path>
using InEyes = At<&ClientConfig::eyes, Path...>;
template <auto... Path>
using InWindow = At<&ClientConfig::window, Path...>;
template <auto... Path>
using InPhantom = At<&ClientConfig::phantom, Path...>;

/// Completes a key by the variable that stores it. `in` returns a pointer to the variable, or nullptr; `read`
/// converts the file's value to the variable's, and `write` the variable's to the file's.
template <class In, class Read, class Write>
ConfigKey stored(ConfigKey key, In in, Read read, Write write) {
  key.set = [=](ClientConfig& c, const ConfigValue& v) {
    const auto value = read(v);
    if (auto* variable = in(c)) *variable = value;
  };
  key.get = [=](const ClientConfig& c) {
    const auto* variable = in(c);
    return variable == nullptr ? Value() : write(*variable);
  };
  return key;
}

template <class T>
T read_as(const ConfigValue& v) {
  return std::get<T>(v);
}

template <class T>
Value write_as(const T& stored) {
  return ConfigValue(stored);
}

template <class In>
ConfigKey flag(std::string name, In in, std::string help) {
  return stored({.name = std::move(name), .type = ConfigType::flag, .help = std::move(help)}, in,
                read_as<bool>, write_as<bool>);
}

template <class In>
ConfigKey text(std::string name, In in, std::string help) {
  return stored({.name = std::move(name), .help = std::move(help)}, in, read_as<std::string>,
                write_as<std::string>);
}

/// Creates the key of a number. `scale` is the file's unit in the variable's unit.
template <class In>
ConfigKey number(const std::string& name, In in, double least, double most, std::string unit,
                 std::string help, double scale = 1) {
  return stored(
      {.name = name, .type = ConfigType::number, .least = least, .most = most, .unit = unit, .help = help},
      in, [scale](const ConfigValue& v) { return scale * std::get<double>(v); },
      [scale](double x) { return write_as(x / scale); });
}

/// Creates the key of `count` numbers within ±`most`.
template <class In, class Read, class Write>
ConfigKey numbers(const std::string& name, In in, std::size_t count, double most, const std::string& unit,
                  const std::string& help, Read read, Write write) {
  return stored(
      {.name = name, .type = ConfigType::numbers, .most = most, .count = count, .unit = unit, .help = help},
      in, read, write);
}

/// Creates a key with a fixed set of words, each of which stands for a value of the variable.
template <class T, class In>
ConfigKey choice(std::string name, In in, std::vector<std::pair<std::string, T>> words, std::string help) {
  using Word = std::pair<std::string, T>;
  ConfigKey key = {.name = std::move(name), .help = std::move(help)};
  for (const Word& word : words) key.choices.push_back(word.first);
  return stored(
      key, in,
      [words](const ConfigValue& v) {
        return std::ranges::find(words, std::get<std::string>(v), &Word::first)->second;
      },
      [words](const T& x) { return write_as(std::ranges::find(words, x, &Word::second)->first); });
}

/// Creates the key of a device's or an arm's address. `parse` throws InputError for an unknown driver.
template <class In>
ConfigKey address(std::string name, In in, std::string example, std::string help,
                  DeviceAddress (*parse)(const std::string&) = parse_device_address) {
  return stored(
      {.name = std::move(name), .needed = std::move(example), .help = std::move(help)}, in,
      [parse](const ConfigValue& v) {
        const std::string& given = std::get<std::string>(v);
        if (!given.empty()) (void)parse(given);  // empty: no device now; the other keys of the table stay
        return given;
      },
      [](const std::string& given) { return given.empty() ? Value() : write_as(given); });
}

Vec3 read_vector(const ConfigValue& v) {
  return Vec3(std::get<Numbers>(v).data());
}

Value write_vector(const Vec3& v) {
  return Numbers{v.x(), v.y(), v.z()};
}

Quat read_orientation(const ConfigValue& v) {
  const Numbers& q = std::get<Numbers>(v);
  const Quat read(q[0], q[1], q[2], q[3]);
  if (std::abs(read.norm() - 1) > 0.01) throw InputError("must be a unit quaternion w, x, y, z");
  return read.normalized();
}

Value write_orientation(const Quat& q) {
  return Numbers{q.w(), q.x(), q.y(), q.z()};
}

/// Returns an accessor of a member of the struct that `in` reaches.
template <class In, class Member>
auto member_of(In in, Member member) {
  return [=](auto& c) {
    auto* object = in(c);
    return object == nullptr ? nullptr : &(object->*member);
  };
}

/// Adds the keys `position` and `orientation` of a pose.
template <class In>
void add_pose(Keys& keys, const std::string& table, In in, const std::string& what) {
  keys.insert(keys.end(), {numbers(table + ".position", member_of(in, &Pose::p), 3, max_coordinate, "m", what,
                                   read_vector, write_vector),
                           numbers(table + ".orientation", member_of(in, &Pose::q), 4, 1, "", "w, x, y, z",
                                   read_orientation, write_orientation)});
}

std::optional<std::size_t> station_of(const ClientConfig& config, StationRole role) {
  const auto at = std::find(config.stations.begin(), config.stations.end(), role);
  if (at == config.stations.end()) return std::nullopt;
  return static_cast<std::size_t>(at - config.stations.begin());
}

/// Creates the key of the receiver that a role has.
ConfigKey station_number(const std::string& table, StationRole role) {
  ConfigKey key = {.name = table + ".station",
                   .type = ConfigType::whole,
                   .least = 0,
                   .most = max_stations,
                   .needed = "1",
                   .help = "number of the role's receiver, from 1; 0: none, its mount is preserved"};
  key.set = [role](ClientConfig& c, const ConfigValue& v) {
    const auto number = static_cast<std::size_t>(std::get<double>(v));
    if (number == 0) return;
    const std::size_t index = number - 1;
    if (c.stations[index] != StationRole::none)
      throw InputError("this receiver is already assigned to another role: choose another receiver");
    c.stations[index] = role;
    c.tracker_device.placement.stations |= 1u << index;
  };
  key.get = [role](const ClientConfig& c) {
    const auto index = station_of(c, role);
    return index ? write_as(static_cast<double>(*index + 1)) : Value();
  };
  return key;
}

void add_stations(Keys& keys) {
  for (const RoleName& row : role_names) {
    const std::string table = fmt::format("tracker.stations.{}", row.name);
    keys.push_back(station_number(table, row.role));
    const auto mount = [role = row.role](auto& c) {
      const auto index = station_of(c, role);
      return index ? &c.tracker_device.placement.mount[*index] : nullptr;
    };
    add_pose(keys, table + ".mount", mount,
             "pose of the tracked point (wrist, eyes, tip) in the receiver's frame");
    const auto board = [role = row.role](auto& c) {
      const auto index = station_of(c, role);
      return index ? &c.tracker_device.tags.boards[*index] : nullptr;
    };
    ConfigKey key = {.name = table + ".board",
                     .help =
                         "camera tracking: the role's board, a known one (prosector-board --list) or a "
                         "file beside this one; default: the standard board of the role"};
    keys.push_back(
        stored(key, board, read_as<std::string>, [usual = std::string(row.board)](const std::string& given) {
          return given.empty() || given == usual ? Value() : write_as(given);
        }));
    if (row.role == StationRole::instrument)
      keys.push_back(text(table + ".tool", At<&ClientConfig::tool>(),
                          "blade of the scene that the instrument represents, e.g. \"scalpel\", in the right "
                          "hand; empty: none"));
  }
}

using FramePoints = std::array<double, 9>;

FramePoints read_alignment_frame(const ConfigValue& v) {
  FramePoints a{};
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = cm_per_m * std::get<Numbers>(v)[i];
  const Vec3 o(a.data()), x(a.data() + 3), y(a.data() + 6);
  if ((x - o).cross(y - o).norm() < 1e-6)
    throw InputError("the three points of the alignment frame must not lie on one line");
  return a;
}

Value write_alignment_frame(const FramePoints& points) {
  Numbers out;
  for (const double x : points) out.push_back(x / cm_per_m);
  return out;
}

/// Adds the keys of the FASTRAK itself: its records, boresight, hemisphere and alignment frame.
void add_fastrak(Keys& keys) {
  keys.insert(
      keys.end(),
      {flag("tracker.binary", InFastrak<&FastrakConfig::binary>(), "binary records; false: ASCII"),
       flag("tracker.boresight", InFastrak<&FastrakConfig::boresight>(),
            "true: each receiver's orientation at start becomes forward"),
       numbers("tracker.hemisphere", InFastrak<&FastrakConfig::hemisphere>(), 3, 1, "",
               "hemisphere of the transmitter that contains the receivers: X forward, Y right, Z down",
               read_vector, write_vector),
       numbers("tracker.alignment_frame", InFastrak<&FastrakConfig::alignment>(), 9, max_frame_point, "m",
               "the FASTRAK's alignment frame: origin, a point on +X, a point on +Y", read_alignment_frame,
               write_alignment_frame)});
}

/// Adds the keys of bare hands seen by one or two cameras: the hand, its networks, and the second camera.
void add_bare_hands(Keys& keys) {
  keys.insert(
      keys.end(),
      {number("tracker.hand_length", InHands<&HandTrackingConfig::hand_length>(), 0.1, 0.3, "m",
              "bare hands: length from the wrist crease to the middle finger's tip; default 0.191; "
              "depth has the same relative error"),
       choice<HandNets>("tracker.hand_networks", InHands<&HandTrackingConfig::hand_nets>(),
                        {{"full", HandNets::full}, {"lite", HandNets::lite}},
                        "bare hands: networks; `lite` takes two thirds of the time and is less accurate"),
       number("tracker.farthest_hand", InHands<&HandTrackingConfig::farthest_hand>(), 0.3, 5, "m",
              "bare hands: distance from the camera beyond which hands are ignored"),
       text("tracker.second_lens", InHands<&HandTrackingConfig::second_lens>(),
            "bare hands: lens file of the second camera, in this file's folder; empty: estimated lens")});
  add_pose(keys, "tracker.second", InHands<&HandTrackingConfig::first_second>(),
           "bare hands: pose of the second camera in the first one's frame: x right, y up, −z forward");
}

void add_tracker(Keys& keys) {
  keys.push_back(address("tracker.address", At<&ClientConfig::tracker>(), "\"fastrak:/dev/ttyS0\"",
                         "the tracker, DRIVER:PATH; empty: none"));
  add_fastrak(keys);
  keys.push_back(text("tracker.field_map", InTracker<&DeviceConfig::placement, &Placement::field_map>(),
                      "field map: file written by `calibrate field`, beside this one; empty: none"));
  add_pose(keys, "tracker.room", InTracker<&DeviceConfig::placement, &Placement::room_device>(),
           "pose of the transmitter or the camera: x right, y up, −z forward");
  keys.push_back(
      text("tracker.lens", InCamera<&CameraConfig::lens>(),
           "camera tracking: file written by `camera calibrate`, beside this one; empty: estimated lens"));
  add_bare_hands(keys);
  keys.push_back(
      text("tracker.table.board", InCamera<&CameraConfig::table>(),
           "camera tracking: the fixed board that defines the room frame; empty: the camera is fixed"));
  add_pose(keys, "tracker.table", InCamera<&CameraConfig::room_table>(),
           "pose of the table's board; its z axis points up if it lies flat");
  add_stations(keys);
}

/// Creates the key of a glove's fixed counts of the open or of the closed fingers.
template <class In>
ConfigKey counts(const std::string& name, In in, const std::string& help) {
  using Counts = std::array<double, fingers>;
  return numbers(
      name, in, fingers, max_device_count, "counts", help,
      [](const ConfigValue& v) {
        Counts out{};
        std::copy_n(std::get<Numbers>(v).begin(), fingers, out.begin());
        return out;
      },
      [](const Counts& stored) { return Value(Numbers(stored.begin(), stored.end())); });
}

template <std::size_t Hand>
void add_glove(Keys& keys, const std::string& table) {
  constexpr auto gestures = &DeviceConfig::gestures;
  constexpr auto glove = &DeviceConfig::glove;
  constexpr auto calibration = &GloveConfig::calibration;
  keys.insert(
      keys.end(),
      {address(table + ".address", At<&ClientConfig::gloves, Hand, &GloveSettings::address>(),
               "\"5dt:/dev/ttyS1\"", "the glove, DRIVER:PATH; empty: none"),
       number(table + ".closed_above", InGlove<Hand, gestures, &GestureThresholds::closed_above>(), 0, 1,
              "flexion", "a finger with larger flexion is closed"),
       number(table + ".open_below", InGlove<Hand, gestures, &GestureThresholds::open_below>(), 0, 1,
              "flexion", "a finger with smaller flexion is open; no gesture in between"),
       number(table + ".hysteresis", InGlove<Hand, gestures, &GestureThresholds::hysteresis>(), 0, 0.5,
              "flexion", "hysteresis: distance past a threshold at which a finger changes its state"),
       flag(table + ".pinch", InGlove<Hand, gestures, &GestureThresholds::pinch>(),
            "true: index finger closed, thumb bent, the others open, is the gesture `pinch`"),
       flag(table + ".falls_on_bending", InGlove<Hand, glove, &GloveConfig::falls_on_bending>(),
            "true if sensor counts decrease as a finger bends"),
       counts(table + ".open", InGlove<Hand, glove, calibration, &GloveCalibration::open>(),
              "sensor counts of extended fingers, thumb to little; default: learnt from the observed range"),
       counts(table + ".closed", InGlove<Hand, glove, calibration, &GloveCalibration::closed>(),
              "sensor counts of bent fingers; give it together with `open`")});
}

void add_arm(Keys& keys) {
  keys.insert(
      keys.end(),
      {address("arm.address", InArm<&ArmSettings::address>(), "\"omni-twin:/tmp/omni\"",
               "the haptic arm, DRIVER:PATH; empty: none", parse_arm_address),
       choice<std::size_t>("arm.hand", InArm<&ArmSettings::hand>(),
                           {{"left", left_hand}, {"right", right_hand}}, "hand that it moves"),
       stored(
           {.name = "arm.dead_man",
            .type = ConfigType::whole,
            .least = 1,
            .most = arm_buttons,
            .help = "dead-man button, from 1, that must be pressed for forces; default: none"},
           InArm<&ArmSettings::dead_man>(),
           [](const ConfigValue& v) { return static_cast<unsigned>(std::get<double>(v)); },
           [](unsigned button) { return button == 0 ? Value() : write_as(static_cast<double>(button)); })});
  add_pose(keys, "arm.room", InArm<&ArmSettings::arm, &ArmConfig::room_arm>(),
           "pose of the arm: x right, y up, z towards you");
  add_pose(keys, "arm.mount", InArm<&ArmSettings::mount>(),
           "pose of the wrist in the stylus frame; default: the index finger's tip at the stylus tip");
}

void add_gestures(Keys& keys) {
  for (const GestureRow& row : gesture_table()) {
    if (row.gesture == Gesture::none) continue;
    ConfigKey key = {.name = fmt::format("gestures.{}", row.name), .help = "action of this gesture"};
    for (const EventName& e : event_names) key.choices.emplace_back(e.name);
    const Gesture plain = without_thumb(row.gesture);
    if (plain != row.gesture) key.help += fmt::format("; none: action of {}", gesture_name(plain));
    key.set = [gesture = row.gesture](ClientConfig& c, const ConfigValue& v) {
      const auto event = std::find_if(event_names.begin(), event_names.end(),
                                      [&](const EventName& e) { return e.name == std::get<std::string>(v); });
      if (event->event == GestureEvent::none)
        c.gestures.erase(gesture);
      else
        c.gestures[gesture] = event->event;
    };
    key.get = [gesture = row.gesture](const ClientConfig& c) {
      const auto at = c.gestures.find(gesture);
      const GestureEvent asked = at == c.gestures.end() ? GestureEvent::none : at->second;
      return write_as(std::string(event_names[static_cast<std::size_t>(asked)].name));
    };
    keys.push_back(key);
  }
}

/// Adds the measured values of the eyes and the display.
void add_eyes(Keys& keys) {
  keys.insert(
      keys.end(),
      {number("eyes.distance", InEyes<&EyeSettings::distance>(), 0, 0.2, "m",
              "distance between the pupils; default, as for the other keys here: from the stereo profile"),
       number("eyes.fov_horizontal", InEyes<&EyeSettings::fov_horizontal>(), 1, 170, "degrees",
              "horizontal angle that each eye's image fills", degree),
       number("eyes.fov_vertical", InEyes<&EyeSettings::fov_vertical>(), 1, 170, "degrees",
              "vertical angle that each eye's image fills", degree),
       number("eyes.convergence", InEyes<&EyeSettings::convergence>(), 0.05, 1000, "m",
              "distance at which both eyes' images coincide")});
}

/// Adds the keys of the window screen and of the camera at it.
void add_window(Keys& keys) {
  keys.insert(
      keys.end(),
      {address("window.address", InWindow<&WindowSettings::address>(), "\"face:0\"",
               "eye tracker, DRIVER:PATH; its station 1 is between the eyes; empty: none"),
       text("window.lens", InWindow<&WindowSettings::device, &DeviceConfig::camera, &CameraConfig::lens>(),
            "lens: file written by `camera calibrate`, beside this one; empty: estimated lens"),
       number("window.height", InWindow<&WindowSettings::height>(), 0.05, 10, "m",
              "height of the image on the screen, measured with a ruler; the width follows from it"),
       choice<bool>("window.mode", InWindow<&WindowSettings::pans>(), {{"window", false}, {"pan", true}},
                    "`window`: the scene is behind the screen; `pan`: the face rotates the view")});
  add_pose(keys, "window.camera",
           InWindow<&WindowSettings::device, &DeviceConfig::placement, &Placement::room_device>(),
           "pose of the camera relative to the centre of the image on the screen: x right, y up, z towards "
           "you; unrotated, it faces you");
}

/// Adds the keys of the phantom, a real body in the camera's image.
void add_phantom(Keys& keys) {
  keys.insert(
      keys.end(),
      {text("phantom.body", InPhantom<&PhantomSettings::body>(),
            "scene body with the shape of the phantom, a real object; it is not drawn"),
       text("phantom.mesh", InPhantom<&PhantomSettings::mesh>(),
            "instead of `body`: file with the phantom's shape (OBJ, STL, PLY, OFF, glTF), beside this one"),
       number("phantom.scale", InPhantom<&PhantomSettings::scale>(), 1e-6, 1000, "m",
              "length of the unit of `mesh`"),
       text("phantom.board", InPhantom<&PhantomSettings::board>(),
            "board fixed to the phantom: a known board's name, or a file beside this one; empty: it "
            "does not move")});
  add_pose(keys, "phantom", InPhantom<&PhantomSettings::pose>(),
           "pose of the phantom on its board, or in the room without a board, written by `calibrate "
           "phantom`; default: the body's pose in the scene");
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
  keys.push_back({.name = "version",
                  .type = ConfigType::whole,
                  .least = 1,
                  .most = client_config_version,
                  .help = "version of the file's keys; a file without it has version 1",
                  .set = [](ClientConfig&, const ConfigValue&) {},
                  .get = [](const ClientConfig&) { return Value(); }});
  add_tracker(keys);
  add_glove<right_hand>(keys, "glove.right");
  add_glove<left_hand>(keys, "glove.left");
  add_arm(keys);
  add_gestures(keys);
  add_pose(keys, "headset.room", At<&ClientConfig::headset_room>(),
           "pose of an OpenXR headset's stage, its centre on the floor: x right, y up, −z forward");
  add_eyes(keys);
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

/// Lets a table assign receivers to roles; a given table replaces the default assignment.
void assign_stations(ConfigTable& table) {
  table.whole = true;
  table.begin = [](ClientConfig& c) {
    c.stations.fill(StationRole::none);
    c.tracker_device.placement.stations = 0;
    c.tracker_device.tags.boards = {};
  };
  table.finish = [](ClientConfig& c) -> std::optional<ConfigFault> {
    for (const RoleName& row : role_names)
      if (const auto index = station_of(c, row.role); index && c.tracker_device.tags.boards[*index].empty())
        c.tracker_device.tags.boards[*index] = row.board;
    if (c.tracker_device.placement.stations != 0) return std::nullopt;
    return ConfigFault{"right", "give at least one of head, right, left, instrument, tablet a receiver"};
  };
}

std::vector<ConfigTable> make_tables() {
  std::vector<ConfigTable> tables;
  const auto add = [&](std::string name, std::string help) -> ConfigTable& {
    return tables.emplace_back(ConfigTable{std::move(name), std::move(help), {}, false, {}});
  };
  add("", "");
  add("tracker", "`[tracker]` configures a tracker with one or more receivers.");
  add("tracker.room", "");
  assign_stations(add("tracker.stations",
                      "`[tracker.stations]` assigns receivers to hands, head and tools; without it, "
                      "receiver 1 is the right hand."));
  add("tracker.table", "`[tracker.table]` is the fixed printed board of a camera tracker.");
  add("tracker.second", "`[tracker.second]` is the second camera for tracking bare hands.");
  for (const RoleName& row : role_names) {
    add(fmt::format("tracker.stations.{}", row.name),
        fmt::format("`[tracker.stations.{}]` is the receiver of {}.", row.name, row.help));
    add(fmt::format("tracker.stations.{}.mount", row.name), "");
  }
  add("glove", "");
  add("glove.right", "`[glove.right]` is the right hand's glove, with five bend sensors.").finish =
      [](ClientConfig& c) { return check_glove(c, right_hand); };
  add("glove.left", "`[glove.left]` is the left hand's glove.").finish = [](ClientConfig& c) {
    return check_glove(c, left_hand);
  };
  add("arm", "`[arm]` is a haptic arm: [arms](../do/arms.md).");
  add("arm.room", "");
  add("arm.mount", "").begin = [](ClientConfig& c) { c.arm.mount.emplace(); };
  ConfigTable& gestures =
      add("gestures",
          "`[gestures]` maps hand gestures to actions; if it is given, gestures not listed have no action.");
  gestures.whole = true;
  gestures.begin = [](ClientConfig& c) { c.gestures.clear(); };
  add("headset", "`[headset]` is an OpenXR headset: [join](../do/join.md#with-a-headset-by-openxr).");
  add("headset.room", "");
  add("eyes", "`[eyes]` holds measurements of the eyes and the stereo display.").finish =
      [](ClientConfig& c) {
        if (c.eyes.distance.value_or(0) > 0)
          c.tracker_device.face.eye_distance = c.window.device.face.eye_distance = *c.eyes.distance;
        return std::optional<ConfigFault>();
      };
  add("window", "`[window]` makes the screen a window into the room: [window](../do/window.md).");
  add("window.camera", "");
  add("phantom",
      "`[phantom]` is a real body that occludes virtual objects behind it: "
      "[see-through](../do/see-through.md#phantoms).")
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
