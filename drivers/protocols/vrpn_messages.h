#pragma once
// VRPN messages on a TCP stream: a cookie in each direction, then messages. Numbers are big endian; each side
// announces the names of its senders and message types before it uses them.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/math.h"
#include "drivers/ports/byte_line.h"
#include "drivers/ports/timestamped_buffer.h"

namespace prosector::vrpn {

using Bytes = std::vector<std::uint8_t>;

inline constexpr const char* default_port = "3883";
inline constexpr std::int32_t names_sender = -1, names_type = -2;  // message types that announce names
inline constexpr const char* pose_type = "vrpn_Tracker Pos_Quat";
inline constexpr const char* button_type = "vrpn_Button Change";
inline constexpr const char* analog_type = "vrpn_Analog Channel";
inline constexpr const char* dial_type = "vrpn_Dial update";
inline constexpr const char* ping_type = "vrpn_Base ping_message";  // expects a pong
inline constexpr const char* pong_type = "vrpn_Base pong_message";
inline constexpr const char* field_type = "vrpn_ForceDevice Force_Field";
inline constexpr const char* error_type = "vrpn_ForceDevice Force_Error";

/// Address NAME@HOST[:PORT] of a device on a VRPN server: the device's name, and the server's host and port.
struct Place {
  std::string name;
  HostPort at;
};
/// Parses the address NAME@HOST[:PORT] of a device on a VRPN server. Returns nothing for an invalid text.
std::optional<Place> parse_device_location(const std::string& text);

struct Message {
  std::int32_t sender = 0, type = 0;  // for an announcement, `sender` is the announced number
  Bytes body;
  std::int64_t time_ns = 0;  // received: when its first byte was read; sent: time since the epoch, or 0
};

/// Returns the VRPN cookie: the bytes with the protocol version that each side of a connection sends first.
Bytes cookie();
/// Appends the encoded VRPN message, header and body, to `out`.
void put(Bytes& out, const Message& message);
/// Creates the VRPN message that announces the name of a sender or of a message type. `kind` is names_sender
/// or names_type; `number` stands for the name in later messages.
Message naming(std::int32_t kind, std::int32_t number, const std::string& name);

/// Pose of one sensor (receiver) that a VRPN tracker reports: m, the server's frame.
struct TrackerPose {
  std::int32_t sensor = 0;
  Vec3 place = Vec3::Zero();
  Quat turn = Quat::Identity();  // as received, not normalised
};
Bytes body_of(const TrackerPose& pose);
std::optional<TrackerPose> tracker_pose_of(const Bytes& body);

struct Button {
  std::int32_t number = 0;
  bool pressed = false;
};
Bytes body_of(const Button& button);
std::optional<Button> button_of(const Bytes& body);

/// Values of all channels of a VRPN analog device, in any unit.
using Channels = std::vector<double>;
Bytes body_of(const Channels& channels);
/// Decodes the body of a VRPN analog message to the channels' values. Returns nothing if the stated count
/// does not match the body's length.
std::optional<Channels> channels_of(const Bytes& body);

/// Rotation of one dial of a VRPN device since its last report, in revolutions.
struct Dial {
  std::int32_t number = 0;
  double turned = 0;
};
Bytes body_of(const Dial& dial);
std::optional<Dial> dial_of(const Bytes& body);

/// Force field that a VRPN server's haptic arm renders: force + jacobian·(x − origin) at positions x within
/// `radius` of the origin, zero outside.
struct ForceField {
  Vec3 origin = Vec3::Zero(), force = Vec3::Zero();  // m, N
  Mat3 jacobian = Mat3::Zero();                      // N/m
  double radius = 0;                                 // m
};
Bytes body_of(const ForceField& field);
std::optional<ForceField> field_of(const Bytes& body);

// Codes of Force_Error.
inline constexpr std::int32_t duty_cycle_error = 1, force_error = 2, no_force_error = 4;
Bytes body_of(std::int32_t code);
std::optional<std::int32_t> code_of(const Bytes& body);

/// Parser of a byte stream into VRPN messages. It learns the announced names of senders and message types.
class Reader {
 public:
  void take(std::span<const std::uint8_t> bytes, std::int64_t time_ns = 0);
  /// Returns the next complete VRPN message of the received bytes, or nothing if more bytes are needed or the
  /// stream is broken.
  std::optional<Message> next();
  /// Returns whether the received stream is corrupt or not VRPN of a compatible version. The reader then
  /// returns no further messages.
  bool broken() const { return broken_; }
  bool greeted() const { return greeted_; }
  /// Returns the name that the peer announced for the message's sender; empty if it announced none.
  const std::string& sender(const Message& message) const { return name(senders_, message.sender); }
  const std::string& type(const Message& message) const { return name(types_, message.type); }

 private:
  using Names = std::map<std::int32_t, std::string>;
  static const std::string& name(const Names& names, std::int32_t number);
  void learn(const Message& message);

  TimestampedBuffer waiting_;
  bool greeted_ = false, broken_ = false;
  Names senders_, types_;
};

}  // namespace prosector::vrpn
