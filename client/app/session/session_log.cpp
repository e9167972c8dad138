#include "client/app/session/session_log.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "client/replica/shown_names.h"
#include "common/error.h"
#include "common/panel.h"

namespace prosector {
namespace {

using nlohmann::json;

/// Rounds a value: digits beyond the simulation's precision would make lines differ needlessly.
double rounded(double value, int digits) {
  const double scale = std::pow(10, digits);
  return std::round(value * scale) / scale;
}

json vector(const Vec3& v, int digits) {
  return {rounded(v.x(), digits), rounded(v.y(), digits), rounded(v.z(), digits)};
}

std::string name_of(const Replica& replica, ParticipantId id) {
  const auto entry = replica.roster().find(id);
  return entry == replica.roster().end() ? fmt::format("participant {:016x}", id) : entry->second.name;
}

std::string hand_of(const Replica& replica, ParticipantId id, std::size_t hand) {
  return fmt::format("{}, {}", name_of(replica, id), hand == left_hand ? "left" : "right");
}

json part_of(const Replica& replica, const PartState& part) {
  json holders = json::array();
  for (const HandRef& holder : part.holders)
    holders.push_back(hand_of(replica, holder.participant, holder.hand));
  return {{"holders", holders},
          {"attached", part.attached},
          {"hidden", part.hidden},
          {"lit", part.lit},
          {"inspected", part.inspected},
          {"opacity", part.opacity},
          {"stiffness", rounded(part.stiffness, 3)}};
}

struct Whereabouts {
  Vec3 at = Vec3::Zero(), shift = Vec3::Zero();
  Eigen::AlignedBox3d box;
};

Whereabouts whereabouts(const SoftReplica& soft) {
  Whereabouts out;
  const auto count = static_cast<double>(soft.surface().size());
  for (std::size_t i = 0; i < soft.surface().size(); ++i) {
    const Vec3 x = soft.surface()[i].cast<double>();
    out.at += x / count;
    out.shift += (x - soft.rest().positions[i]) / count;
    out.box.extend(x);
  }
  return out;
}

json parts(Replica& replica, const SceneInfo& scene, double tick) {
  json out = json::object();
  for (BodyId body = 0; body < scene.bodies.size(); ++body) {
    json said = json::object();
    if (const PartState* part = replica.part(body)) said = part_of(replica, *part);
    if (const SoftReplica* soft = replica.bodies().soft(body); soft != nullptr && soft->complete()) {
      SoftReplica here =
          *soft;  // a copy, because sample() reports motion only once and the view needs that report
      here.sample(tick, replica.time().tick_seconds());
      const Whereabouts where = whereabouts(here);
      said["at"] = vector(where.at, 3);
      said["shift"] = vector(where.shift, 5);
      said["size"] = vector(where.box.isEmpty() ? Vec3::Zero() : Vec3(where.box.sizes()), 3);
      said["revision"] = soft->revision();
    }
    if (!said.empty()) out[authors_name(scene.bodies[body])] = said;
  }
  return out;
}

json panels(const Replica& replica, const SceneInfo& scene) {
  json out = json::object();
  for (const auto& [id, panel] : replica.panels()) {
    if (panel.body >= scene.bodies.size()) continue;
    json said = {{"part", authors_name(scene.bodies[panel.body])},
                 {"at", vector(panel.pose.p, 4)},
                 {"faces", vector(panel.pose.q * Vec3::UnitZ(), 4)}};
    for (const ControlDesc& control : panel_controls) {
      const ControlState& state = panel.controls[static_cast<std::size_t>(control.control)];
      said["controls"][std::string(control.label)] = {
          {"position", rounded(state.position, 3)}, {"on", state.on}, {"touched", state.touched}};
    }
    out[name_of(replica, id)] = said;
  }
  return out;
}

json touches(const Replica& replica, const SceneInfo& scene) {
  json out = json::object();
  for (const auto& [id, entry] : replica.roster())
    for (const std::size_t hand : {left_hand, right_hand}) {
      const ContactSample* contact = replica.contact(id, hand);
      if (contact == nullptr || !contact->touching || contact->body >= scene.bodies.size()) continue;
      out[hand_of(replica, id, hand)] = {{"body", authors_name(scene.bodies[contact->body])},
                                         {"point", vector(contact->point, 4)},
                                         {"force", vector(contact->force, 2)},
                                         {"depth", rounded(contact->depth, 5)}};
    }
  return out;
}

/// Returns the poses of the participants' eyes and wrists, by name.
json people(const Replica& replica, double tick) {
  json out = json::object();
  for (const auto& [id, entry] : replica.roster()) {
    const auto user = replica.user(id, tick);
    if (!user) continue;
    json said = json::object();
    if (user->head_tracked)
      said["eyes"] = {{"at", vector(user->head.p, 4)}, {"look", vector(user->head.q * -Vec3::UnitZ(), 4)}};
    for (const std::size_t hand : {left_hand, right_hand})
      if (user->hands[hand].tracked)
        said[hand == left_hand ? "left" : "right"] = {
            {"at", vector(user->hands[hand].pose.p, 4)},
            {"points", vector(user->hands[hand].pose.q * -Vec3::UnitZ(), 4)}};
    out[entry.name] = said;
  }
  return out;
}

}  // namespace

SessionLog::SessionLog(const std::filesystem::path& file) : out_(file) {
  if (!out_) throw InputError(fmt::format("--session-log {}: cannot be written", file.string()));
}

void SessionLog::write(Replica& replica, double tick, double seconds) {
  if (!replica.scene()) return;
  const SceneInfo& scene = *replica.scene();
  json line = {
      {"parts", parts(replica, scene, tick)}, {"panels", panels(replica, scene)},
      {"touches", touches(replica, scene)},   {"people", people(replica, tick)},
      {"room_lights", replica.room_lights()}, {"topology", to_hex(replica.bodies().topology_hash())}};
  if (std::string said = line.dump(); said == last_)
    return;
  else
    last_ = std::move(said);
  line["seconds"] = rounded(seconds, 3);
  line["tick"] = rounded(tick, 2);
  out_ << line.dump() << std::endl;
}

}  // namespace prosector
