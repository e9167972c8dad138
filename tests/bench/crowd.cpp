#include "tests/bench/crowd.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/error.h"
#include "common/hand.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr int candidates = 8;                 // random candidates per point
constexpr double least_up = 0.2;              // least y component of the normals of upward-facing surface
constexpr double slant = 0.8;                 // rad, between the fingers and the pressing direction
constexpr double above = 0.05;                // m, initial height of the hands
constexpr double coming_down = 0.5;           // s
constexpr double rubbed = 0.004, period = 2;  // m, s: amplitude and period of rubbing
constexpr double bent = 0.15;                 // flexion of all fingers

std::vector<Vec3> outward_normals(const TriangleMesh& surface) {
  std::vector<Vec3> out(surface.positions.size(), Vec3::Zero());
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3& x = surface.positions[a];
    const Vec3 area = (surface.positions[b] - x).cross(surface.positions[c] - x);
    for (const std::uint32_t corner : {a, b, c}) out[corner] += area;
  }
  for (Vec3& n : out) n.stableNormalize();
  return out;
}

double nearest(const std::vector<PressedPlace>& places, const Vec3& at) {
  double least = std::numeric_limits<double>::max();
  for (const PressedPlace& place : places) least = std::min(least, (place.at - at).norm());
  return least;
}

}  // namespace

std::vector<PressedPlace> spread_places(const Simulation& simulation, BodyId body, std::size_t count,
                                        unsigned seed) {
  const TriangleMesh& surface = simulation.surface(body);
  const std::vector<Vec3> normals = outward_normals(surface);
  std::vector<std::size_t> up;
  for (std::size_t v = 0; v < normals.size(); ++v)
    if (normals[v].y() > least_up) up.push_back(v);
  if (up.empty()) throw InputError(fmt::format("{}: no part of the surface faces up", simulation.name(body)));
  Random random(seed);
  std::vector<PressedPlace> out;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t best = up[random.below(up.size())];
    for (int i = 1; i < candidates; ++i)
      if (const std::size_t other = up[random.below(up.size())];
          nearest(out, surface.positions[other]) > nearest(out, surface.positions[best]))
        best = other;
    const double turn = random.uniform(0, 2 * std::numbers::pi);
    const Vec3 across = normals[best].unitOrthogonal();
    out.push_back({surface.positions[best], normals[best], Eigen::AngleAxisd(turn, normals[best]) * across});
  }
  return out;
}

Crowd::Crowd(std::vector<PressedPlace> places, std::size_t users, std::size_t hands_each, double depth)
    : places_(std::move(places)), hands_(users * hands_each), hands_each_(hands_each), depth_(depth) {}

Pose Crowd::wrist(std::size_t hand, double time) const {
  const PressedPlace& place = places_[hand];
  const Vec3 fingers = -std::cos(slant) * place.outward + std::sin(slant) * place.along;
  const Vec3 back = std::sin(slant) * place.outward + std::cos(slant) * place.along;
  Mat3 axes;
  axes << back.cross(-fingers), back, -fingers;
  const double down = std::min(1.0, time / coming_down);
  const double rub = rubbed * std::sin(2 * std::numbers::pi * std::max(0.0, time - coming_down) / period);
  const Vec3 tip = place.at + (above * (1 - down) - depth_ * down) * place.outward +
                   rub * place.outward.cross(place.along);
  std::array<double, prosector::fingers> flexion;
  flexion.fill(bent);
  const Quat q(axes);
  return {tip - q * middle_fingertip(hand % hands_each_, flexion), q};
}

TickInput Crowd::act(int tick, double h) const {
  TickInput input;
  for (std::size_t hand = 0; hand < hands_; ++hand) {
    HandTarget target;
    target.participant = static_cast<ParticipantId>(1 + hand / hands_each_);
    target.hand = hand % hands_each_;
    target.target = wrist(hand, tick * h);
    target.flexion.fill(bent);
    if (tick == 0) input.events.push_back({HandEvent::Kind::appear, target.participant, target.hand});
    input.targets.push_back(target);
  }
  return input;
}

BodyId pressed_body(const Simulation& simulation, const std::string& name) {
  std::string names;
  std::optional<BodyId> largest;
  for (BodyId body = 0; body < simulation.body_count(); ++body) {
    if (simulation.kind(body) != BodyKind::soft) continue;
    if (simulation.name(body) == name) return body;
    names += (names.empty() ? "" : ", ") + simulation.name(body);
    if (!largest || simulation.soft(body).elements() > simulation.soft(*largest).elements()) largest = body;
  }
  if (!name.empty() || !largest)
    throw InputError(fmt::format("organ \"{}\": the scene's soft bodies are: {}", name, names));
  return *largest;
}

}  // namespace prosector
