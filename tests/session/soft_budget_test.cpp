// What a press costs on the wire and how well the drawn surface follows: simulation, sender, wire and replica
// in one process, without a network.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>

#include "client/replica/replica.h"
#include "common/asset.h"
#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "idl/wire/codec.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/session/sending/scene_content.h"
#include "server/session/sending/soft_sender.h"
#include "tests/folders.h"

namespace prosector {
namespace {

constexpr ParticipantId somebody = 1;
constexpr double playout_ticks = 1;     // a client without jitter draws this far behind
constexpr double tracker_noise = 2e-4;  // m, a component: the tracker's own, as in the demo
constexpr int parts_of_a_tick = 4;      // moments at which the drawn surface is compared

/// The demo's hand on the liver: time s and wrist, room frame, m.
struct Waypoint {
  double time;
  Vec3 wrist;
};
const std::array<Waypoint, 7> press = {{{0, {0.07, 1.27, 0.23}},
                                        {1, {0.01, 1.225, 0.1645}},
                                        {2.5, {0.01, 1.14, 0.1645}},
                                        {5, {0.015, 1.138, 0.1665}},
                                        {6.5, {0.02, 1.245, 0.1845}},
                                        {8, {0.18, 1.315, 0.3245}},
                                        {10, {0.18, 1.315, 0.3245}}}};

Vec3 wrist_at(double time) {
  for (std::size_t k = 1; k < press.size(); ++k)
    if (time < press[k].time) {
      const double s = (time - press[k - 1].time) / (press[k].time - press[k - 1].time);
      return press[k - 1].wrist + s * (press[k].wrist - press[k - 1].wrist);
    }
  return press.back().wrist;
}

/// One deformable on its way from the server to a client.
struct Stream {
  BodyId body;
  const soft::SoftBody& soft;
  std::shared_ptr<const SurfaceStream> shared;
  SoftSender sender;
  SoftReplica replica;
  std::deque<soft::Motion> truth{};  // of this tick and the one before
  std::uint64_t samples = 0, bytes = 0;
  std::vector<std::uint64_t> bytes_of_tick{};
  double worst = 0, sum_of_squares = 0;  // m: of the drawn surface
  std::uint64_t compared = 0;

  void take(const Simulation& simulation) {
    const soft::Motion& motion = simulation.soft_state(body).motion;
    truth.push_back(motion);
    if (truth.size() > 2) truth.pop_front();
    std::vector<Message> out;
    sender.update({body, simulation.asleep(body), 0, std::make_shared<VecX>(motion.x),
                   std::make_shared<VecX>(motion.v), shared},
                  simulation.time(), false, out);
    bytes_of_tick.push_back(0);
    for (const Message& message : out) {
      Message received;
      std::size_t size = 0;
      if (through_the_wire(message, received, size)) throw std::runtime_error("a sample was refused");
      if (const auto* state = std::get_if<SoftState>(&received)) {
        replica.add(*state);
        ++samples;
        bytes_of_tick.back() += size;
      } else {
        replica.add(std::get<Settled>(received));
      }
    }
    bytes += bytes_of_tick.back();
  }

  void compare(double tick, double dt) {
    if (truth.size() < 2) return;
    for (int part = 0; part < parts_of_a_tick; ++part) {
      const double s = static_cast<double>(part) / parts_of_a_tick;
      replica.sample(tick - playout_ticks + s, dt);
      const VecX x = between(s, dt);
      const SparseMap& W = soft.anatomy().embedding;
      for (std::size_t v = 0; v < W.rows.size(); ++v) {
        const double error = (W.apply(v, x.data()) - replica.surface()[v].cast<double>()).norm();
        worst = std::max(worst, error);
        sum_of_squares += error * error;
        ++compared;
      }
    }
  }

  /// The server's nodes at share `s` between the last two ticks.
  VecX between(double s, double dt) const {
    const soft::Motion &a = truth[0], &b = truth[1];
    VecX x(a.x.size());
    for (Eigen::Index i = 0; i < x.size(); i += 3)
      x.segment<3>(i) =
          hermite(a.x.segment<3>(i), a.v.segment<3>(i), b.x.segment<3>(i), b.v.segment<3>(i), dt, s);
    return x;
  }
};

/// The abdomen, or its stand-in of our own shapes where the anatomy has not been fetched.
Simulation abdomen() {
  CompileOptions compile;
  compile.data_dirs = {default_data_dir()};
  compile.cache_dir = default_cache_dir();
  return {load_scene(source_path("deploy/scenes/abdomen.toml")), compile};
}

TEST(SoftBudget, APressedAbdomenStaysBelowTwoMegabitsAndATenthOfAMillimetre) {
  Simulation simulation = abdomen();
  const SceneContent content = make_scene_content(simulation);
  const double rate = simulation.scene().tick_rate;
  std::deque<Stream> streams;
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    if (simulation.kind(b) != BodyKind::soft) continue;
    const auto stream = content.surfaces.at(b).stream();
    streams.push_back({b, simulation.soft(b), stream, SoftSender(b, rate),
                       SoftReplica(content.scene.bodies[b], simulation.surface(b), stream->surface)});
  }
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, tracker_noise);
  TickInput input;
  input.events = {{HandEvent::Kind::appear, somebody, right_hand, BodyId{0}}};
  input.targets.resize(1);
  input.targets[0].participant = somebody;
  const Quat tilt(0.965926, -0.258819, 0, 0);
  std::uint64_t awake = 0;
  for (int tick = 0; tick < static_cast<int>(press.back().time * rate); ++tick) {
    const Vec3 shaken(noise(random), noise(random), noise(random));
    input.targets[0].target = {wrist_at(tick / rate) + shaken, tilt.normalized()};
    simulation.step(input);
    input.events.clear();
    awake += std::ranges::any_of(streams, [&](const Stream& s) { return !simulation.asleep(s.body); });
    for (Stream& s : streams) {
      s.take(simulation);
      s.compare(static_cast<double>(simulation.time().tick), 1 / rate);
    }
  }

  const auto window = static_cast<std::size_t>(rate);
  std::vector<std::uint64_t> all(streams.front().bytes_of_tick.size());
  fmt::print("{:<14}{:>8}{:>8}{:>10}{:>14}{:>12}{:>12}\n", "body", "points", "chunks", "samples",
             "bytes/sample", "worst mm", "rms mm");
  for (const Stream& s : streams) {
    const SurfaceStream& stream = *s.shared;
    const double rms =
        std::sqrt(s.sum_of_squares / static_cast<double>(std::max<std::uint64_t>(1, s.compared)));
    fmt::print("{:<14}{:>8}{:>8}{:>10}{:>14.0f}{:>12.4f}{:>12.4f}\n", simulation.name(s.body), stream.points,
               stream.chunks(), s.samples,
               static_cast<double>(s.bytes) / static_cast<double>(std::max<std::uint64_t>(1, s.samples)),
               1e3 * s.worst, 1e3 * rms);
    EXPECT_LT(s.worst, 1e-4) << simulation.name(s.body);
    for (std::size_t t = 0; t < all.size(); ++t) all[t] += s.bytes_of_tick[t];
  }
  std::uint64_t sum = 0, most = 0, total = 0;
  for (std::size_t t = 0; t < all.size(); ++t) {
    total += all[t];
    sum += all[t] - (t >= window ? all[t - window] : 0);
    most = std::max(most, sum);
  }
  const double mean_kbit =
      8e-3 * static_cast<double>(total) / (static_cast<double>(std::max<std::uint64_t>(1, awake)) / rate);
  const double peak_kbit = 8e-3 * static_cast<double>(most);
  fmt::print(
      "{} tetrahedra; kbit/s an observer: {:.0f} mean while awake ({:.1f} s), {:.0f} in the busiest second\n",
      tet_count(simulation), mean_kbit, static_cast<double>(awake) / rate, peak_kbit);
  EXPECT_GT(tet_count(simulation), 3000u);
  EXPECT_GT(awake, 200u);
  EXPECT_LT(peak_kbit, 2000);
}

}  // namespace
}  // namespace prosector
