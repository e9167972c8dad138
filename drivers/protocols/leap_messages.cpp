#include "drivers/protocols/leap_messages.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "drivers/device/plausible.h"
#include "drivers/protocols/json_lookup.h"

namespace prosector::leap {
namespace {

using Json = nlohmann::json;

constexpr double m_per_mm = 1e-3, mm_per_m = 1e3;
constexpr double farthest = 3;            // m: beyond the range of its cameras
constexpr double min_bone_length = 1e-3;  // m: shorter bones are implausible
constexpr double max_normal_cosine =
    0.3;  // maximum cosine between the palm's normal and the hand's direction
constexpr double closed = std::numbers::pi / 2;
constexpr std::size_t most_hands = 8;  // per frame
constexpr std::array<const char*, 5> joint_keys = {"carpPosition", "mcpPosition", "pipPosition",
                                                   "dipPosition", "btipPosition"};

std::optional<Vec3> place_of(const Json& json) {
  const auto mm = json_vector(json);
  if (!mm || !is_within(m_per_mm * *mm, farthest)) return std::nullopt;
  return Vec3(m_per_mm * *mm);
}
std::optional<Vec3> direction_of(const Json& json) {
  const auto direction = json_vector(json);
  if (!direction || !is_unit(*direction)) return std::nullopt;
  return direction->normalized();
}

std::optional<Hand> hand_of(const Json& json) {
  const Json& type = json_at(json, "type");
  const auto wrist = place_of(json_at(json, "wrist"));
  const auto direction = direction_of(json_at(json, "direction"));
  const auto normal = direction_of(json_at(json, "palmNormal"));
  if ((type != "left" && type != "right") || !wrist || !direction || !normal ||
      std::abs(direction->dot(*normal)) > max_normal_cosine)
    return std::nullopt;
  Hand out;
  out.left = type == "left";
  out.wrist = *wrist;
  out.direction = *direction;
  out.palm_normal = *normal;
  for (Finger& finger : out.joints) finger.fill(Vec3::Zero());
  return out;
}

/// Reads a finger into its hand. Returns false if the finger is invalid. A finger of an unknown hand is
/// skipped.
bool take_finger(const Json& json, std::map<std::int64_t, std::size_t>& by_id, std::vector<Hand>& hands,
                 std::vector<unsigned>& had) {
  const Json &type = json_at(json, "type"), &hand_id = json_at(json, "handId");
  if (!type.is_number_integer() || !hand_id.is_number_integer()) return false;
  const auto number = type.get<std::int64_t>();
  const auto hand = by_id.find(hand_id.get<std::int64_t>());
  if (number < 0 || number >= static_cast<std::int64_t>(fingers)) return false;
  if (hand == by_id.end()) return true;
  const auto finger = static_cast<std::size_t>(number);
  for (std::size_t k = 0; k < joint_keys.size(); ++k) {
    const auto place = place_of(json_at(json, joint_keys[k]));
    if (!place) return false;
    hands[hand->second].joints[finger][k] = *place;
  }
  // Without bones a finger has no flexion. The thumb's first bone has no length.
  const Finger& at = hands[hand->second].joints[finger];
  for (std::size_t k = finger == 0 ? 1 : 0; k + 1 < at.size(); ++k)
    if ((at[k + 1] - at[k]).norm() < min_bone_length) return false;
  had[hand->second] |= 1u << finger;
  return true;
}

Json json_of(const Vec3& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

/// Returns the angle between the bones from→over and over→to, rad. With `towards`, the angle is signed:
/// positive for flexion towards that direction.
double bend(const Vec3& from, const Vec3& over, const Vec3& to, const Vec3* towards = nullptr) {
  const Vec3 before = (over - from).normalized(), bone = (to - over).normalized();
  if (towards == nullptr) return std::acos(std::clamp(before.dot(bone), -1.0, 1.0));
  const Vec3 side = (*towards - towards->dot(before) * before).normalized();
  return std::atan2(bone.dot(side), bone.dot(before));
}

}  // namespace

std::optional<Text> read_text(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  Text out;
  if (const Json& version = json_at(json, "version"); version.is_number_integer()) {
    out.version = static_cast<int>(std::clamp<std::int64_t>(version.get<std::int64_t>(), -1, 1000));
    return out;
  }
  if (const Json& event = json_at(json, "event"); event.is_object()) {
    out.is_event = true;
    if (const Json& streams = json_at(json_at(event, "state"), "streaming"); streams.is_boolean())
      out.streaming = streams.get<bool>();
    return out;
  }
  const Json& hands = json_at(json, "hands");
  if (!hands.is_array() || hands.size() > most_hands) return std::nullopt;
  std::map<std::int64_t, std::size_t> by_id;
  for (const Json& each : hands) {
    const auto hand = hand_of(each);
    const Json& id = json_at(each, "id");
    if (!hand || !id.is_number_integer()) return std::nullopt;
    by_id[id.get<std::int64_t>()] = out.hands.size();
    out.hands.push_back(*hand);
  }
  std::vector<unsigned> had(out.hands.size());
  const Json& pointables = json_at(json, "pointables");
  if (!pointables.is_array() && !out.hands.empty()) return std::nullopt;
  if (pointables.is_array())
    for (const Json& each : pointables)
      if (json_at(each, "tool") != true && !take_finger(each, by_id, out.hands, had)) return std::nullopt;
  if (std::ranges::any_of(had, [](unsigned bits) { return bits != (1u << fingers) - 1; }))
    return std::nullopt;
  return out;
}

std::string text_of(const Text& text, std::int64_t frame) {
  if (text.version) return Json{{"serviceVersion", "simulated"}, {"version", *text.version}}.dump();
  Json hands = Json::array(), pointables = Json::array();
  for (const Hand& hand : text.hands) {
    const int id = hand.left ? 2 : 1;
    hands.push_back({{"id", id},
                     {"type", hand.left ? "left" : "right"},
                     {"wrist", json_of(mm_per_m * hand.wrist)},
                     {"direction", json_of(hand.direction)},
                     {"palmNormal", json_of(hand.palm_normal)}});
    for (std::size_t f = 0; f < fingers; ++f) {
      Json finger = {{"handId", id}, {"type", f}, {"tool", false}};
      for (std::size_t k = 0; k < joint_keys.size(); ++k)
        finger[joint_keys[k]] = json_of(mm_per_m * hand.joints[f][k]);
      pointables.push_back(finger);
    }
  }
  return Json{{"id", frame}, {"timestamp", 1000 * frame}, {"hands", hands}, {"pointables", pointables}}
      .dump();
}

std::vector<std::string> ask_for_frames() {
  return {Json{{"background", true}}.dump(), Json{{"focused", true}}.dump()};
}

Pose wrist_of(const Hand& hand) {
  const Vec3 back = -hand.direction;
  const Vec3 right = (-hand.palm_normal).cross(back).normalized();
  Mat3 axes;
  axes << right, back.cross(right), back;
  return {hand.wrist, Quat(axes).normalized()};
}

std::array<double, fingers> flexion_of(const Hand& hand) {
  std::array<double, fingers> out{};
  for (std::size_t f = 0; f < fingers; ++f) {
    const Finger& at = hand.joints[f];
    const double angle =
        f == 0 ? (bend(at[1], at[2], at[3]) + bend(at[2], at[3], at[4])) / 2
               : (2 * bend(at[0], at[1], at[2], &hand.palm_normal) + bend(at[1], at[2], at[3])) / 3;
    out[f] = std::clamp(angle / closed, 0.0, 1.0);
  }
  return out;
}

}  // namespace prosector::leap
