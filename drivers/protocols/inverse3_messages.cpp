#include "drivers/protocols/inverse3_messages.h"

#include <array>

#include "drivers/protocols/json_lookup.h"

namespace prosector::inverse3 {
namespace {

using Json = nlohmann::json;

const Json& first(const Json& list) {
  return list.is_array() && !list.empty() ? list.front() : json_at(list, "");
}

template <std::size_t N>
std::optional<std::array<double, N>> numbers(const Json& json, const std::array<const char*, N>& keys) {
  std::array<double, N> out{};
  for (std::size_t i = 0; i < N; ++i) {
    const Json& value = json_at(json, keys[i]);
    if (!value.is_number()) return std::nullopt;
    out[i] = value.get<double>();
  }
  return out;
}
constexpr std::array<const char*, 3> xyz = {"x", "y", "z"}, abc = {"a", "b", "c"};
constexpr std::array<const char*, 4> xyzw = {"x", "y", "z", "w"};

Json json_of(const Vec3& v) {
  return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}};
}

}  // namespace

std::optional<State> state_of(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  const Json& arms = json_at(json, "inverse3");
  if (!arms.is_array()) return std::nullopt;
  State out;
  if (arms.empty()) return out;
  const Json& id = json_at(first(arms), "device_id");
  const auto place = numbers(json_at(json_at(first(arms), "state"), "cursor_position"), xyz);
  if (!id.is_string() || id.get_ref<const std::string&>().empty() || !place) return std::nullopt;
  out.device = id.get<std::string>();
  out.place = Vec3((*place)[0], (*place)[1], (*place)[2]);
  const Json& grip = json_at(first(json_at(json, "wireless_verse_grip")), "state");
  if (const Json& orientation = json_at(grip, "orientation"); !orientation.is_null()) {
    const auto q = numbers(orientation, xyzw);
    if (!q) return std::nullopt;
    out.turn = Quat((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
  }
  for (std::size_t i = 0; i < abc.size(); ++i)
    if (json_at(json_at(grip, "buttons"), abc[i]) == true) out.buttons |= 1u << i;
  return out;
}

std::string text_of(const State& state, bool first) {
  Json arms = Json::array(), grips = Json::array();
  if (!state.device.empty()) {
    Json arm = {
        {"device_id", state.device},
        {"state", {{"cursor_position", json_of(state.place)}, {"cursor_velocity", json_of(Vec3::Zero())}}}};
    if (first) arm["config"] = {{"device_info", {{"id", state.device}}}};
    arms.push_back(arm);
    Json orientation = json_of(state.turn.vec());
    orientation["w"] = state.turn.w();
    Json buttons;
    for (std::size_t i = 0; i < abc.size(); ++i) buttons[abc[i]] = (state.buttons >> i & 1u) != 0;
    grips.push_back({{"device_id", "grip"}, {"state", {{"orientation", orientation}, {"buttons", buttons}}}});
  }
  return Json{{"inverse3", arms}, {"wireless_verse_grip", grips}}.dump();
}

std::optional<Force> force_of(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  const Json& arm = first(json_at(json, "inverse3"));
  const auto force = numbers(json_at(json_at(json_at(arm, "commands"), "set_cursor_force"), "values"), xyz);
  const Json& id = json_at(arm, "device_id");
  if (!force || !id.is_string()) return std::nullopt;
  return Force{id.get<std::string>(), Vec3((*force)[0], (*force)[1], (*force)[2])};
}

std::string text_of(const Force& force) {
  Json arms = Json::array();
  if (!force.device.empty())
    arms.push_back({{"device_id", force.device},
                    {"commands", {{"set_cursor_force", {{"values", json_of(force.force)}}}}}});
  return Json{{"inverse3", arms}}.dump();
}

Mat3 axes() {
  return (Mat3() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished();
}

}  // namespace prosector::inverse3
