#include "server/session/run/session_rules.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace prosector {
namespace {

constexpr double death_timeout = 1.5;   // s after which a dead client has been detected: its lease is 1 s
constexpr double stall_timeout = 5;     // s that the hands of a silent client stay while its lease is valid
constexpr double regrasp_timeout = 30;  // s for which a hand may grasp again what it lost in a stall
constexpr double presence_timeout = 2;  // s that a join waits for its Presence

}  // namespace

SessionRules rules_of(const SceneDesc& scene, const std::string& session, bool remodels) {
  SessionRules rules;
  rules.remodels = remodels;
  rules.session = session;
  rules.capacity = scene.session.capacity;
  rules.observers = scene.session.observers;
  const auto ticks = [&](double seconds) {
    return static_cast<std::uint64_t>(std::ceil(seconds * scene.tick_rate));
  };
  rules.input_timeout = ticks(scene.session.input_timeout);
  rules.stall_timeout = std::max(rules.input_timeout, ticks(stall_timeout));
  rules.regrasp_timeout = ticks(regrasp_timeout);
  rules.presence_timeout = ticks(presence_timeout);
  rules.death_timeout = ticks(death_timeout);
  const auto add = [&](const auto& body) {
    rules.parts.push_back(body.part);
    rules.names.push_back(body.name);
  };
  for (const RigidDesc& rigid : scene.rigid) add(rigid);
  for (const SoftDesc& soft : scene.soft) add(soft);
  rules.bodies = rules.parts.size();
  rules.rigid_bodies = scene.rigid.size();
  return rules;
}

}  // namespace prosector
