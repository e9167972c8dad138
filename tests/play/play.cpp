#include "tests/play/play.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector::test {
namespace {

constexpr int looks_per_second = 4;                  // while the organs rest
constexpr std::uint64_t ticks_of_a_checkpoint = 60;  // a server with a journal makes one after 1 s of work

/// What the report says of each body, for people.
std::string words_of(const StepReport& report) {
  std::string out;
  for (const BodyReport& row : report.bodies)
    if (!row.note.empty()) out += fmt::format("; {}: {}", row.body, row.note);
  return out;
}

void note(const StepReport& report, PlayFigures& figures) {
  figures.step_ms = std::max(figures.step_ms, 1e3 * report.total_seconds);
  for (const BodyReport& row : report.bodies) {
    figures.resets += row.reset;
    figures.recoveries += row.note.find("recovering") != std::string::npos;
  }
}

/// m/s: of a soft body's fastest node, along one axis; of a rigid one's middle, or of a point 0.1 m from it.
double speed_of(const Simulation& simulation, BodyId body) {
  if (simulation.kind(body) == BodyKind::soft)
    return simulation.soft_state(body).motion.v.lpNorm<Eigen::Infinity>();
  const auto motion = simulation.rigid_state(body);
  return std::max(motion.linear_velocity.norm(), 0.1 * motion.angular_velocity.norm());
}

/// Where bodies are, and how far they go from there.
class Excursions {
 public:
  explicit Excursions(const Simulation& simulation) : farthest_(simulation.body_count(), 0) {
    for (BodyId b = 0; b < simulation.body_count(); ++b) start_.push_back(place(simulation, b));
  }
  void look(const Simulation& simulation) {
    for (BodyId b = 0; b < farthest_.size(); ++b) {
      const VecX now = place(simulation, b);
      if (now.size() == start_[b].size())
        farthest_[b] = std::max(farthest_[b], (now - start_[b]).lpNorm<Eigen::Infinity>());
    }
  }
  double farthest(BodyId body) const {
    return body < farthest_.size() ? farthest_[body] : 0;
  }  // m, along one axis

 private:
  static VecX place(const Simulation& simulation, BodyId body) {
    if (simulation.kind(body) == BodyKind::soft) return simulation.soft_state(body).motion.x;
    return simulation.rigid_state(body).pose.p;
  }
  std::vector<VecX> start_;
  std::vector<double> farthest_;
};

}  // namespace

void add(PlayFigures& to, const PlayFigures& from) {
  to.seconds += from.seconds;
  to.bouts += from.bouts;
  to.bad += from.bad;
  to.acts += from.acts;
  to.resets += from.resets;
  to.recoveries += from.recoveries;
  to.least_volume = std::min(to.least_volume, from.least_volume);
  to.most_volume = std::max(to.most_volume, from.most_volume);
  to.overlap = std::max(to.overlap, from.overlap);
  to.recovery = std::max(to.recovery, from.recovery);
  to.step_ms = std::max(to.step_ms, from.step_ms);
  to.rest_ms = std::max(to.rest_ms, from.rest_ms);
  to.bad_saves += from.bad_saves;
  to.found.insert(to.found.end(), from.found.begin(), from.found.end());
}

PlayFigures play(Simulation& simulation, const PlayOptions& options,
                 const std::function<void(const std::string&)>& say) {
  const double rate = simulation.scene().tick_rate;
  const Judge judge(simulation);
  PlayFigures out;
  int bad_saves = 0;  // of this bout
  const auto check_save = [&] {
    if (options.saves == nullptr) return;
    if (const std::string wrong = options.saves->look(simulation); !wrong.empty()) {
      if (bad_saves++ == 0)
        out.found.push_back(fmt::format("{}, seed {}, {}", simulation.scene().name, options.seed, wrong));
    } else if (simulation.time().tick % ticks_of_a_checkpoint == 0) {
      (void)simulation.checkpoint();
    }
  };
  const auto step = [&](const TickInput& input) {
    note(simulation.step(input), out);
    out.seconds += 1 / rate;
    check_save();
  };
  std::vector<Person> people;
  for (int p = 0; p < options.people; ++p)
    people.emplace_back(static_cast<ParticipantId>(p + 1), 1000 * options.seed + static_cast<unsigned>(p));
  for (int bout = 0; bout < options.bouts; ++bout, ++out.bouts) {
    bad_saves = 0;
    for (int tick = 0; tick < options.bout * rate; ++tick) {
      TickInput input;
      for (Person& person : people) person.act(simulation, input);
      step(input);
    }
    TickInput end;
    for (Person& person : people) person.leave(end);
    step(end);
    const int ticks = static_cast<int>(options.rest * rate);
    double good_since = options.rest, spent = 0;
    bool was_good = false;
    for (int tick = 1; tick <= ticks; ++tick) {
      step({});
      const double left = (ticks - tick) / rate;
      if (tick % std::max(1, static_cast<int>(rate / looks_per_second)) != 0 && tick != ticks) continue;
      const Finding now = judge.look(simulation, options.bounds);
      const bool good = now.good();
      if (options.tell && say)
        say(fmt::format("{:.2f} s after: volume {:.3f} … {:.3f}, overlap {:.2f} mm, inverted {:.4f}; {}",
                        options.rest - left, now.least_volume, now.most_volume, 1e3 * now.overlap,
                        now.inverted, now.where));
      if (good && !was_good) good_since = options.rest - left;
      was_good = good;
    }
    const Finding end_state = judge.look(simulation, options.bounds);
    const int last = static_cast<int>(rate / 2);
    std::string words;
    Excursions excursions(simulation);
    for (int tick = 0; tick < last; ++tick) {
      const StepReport& report = simulation.step({});
      excursions.look(simulation);
      spent += report.total_seconds;
      if (tick + 1 == last) words = words_of(report);
      out.seconds += 1 / rate;
    }
    const double mean_ms = 1e3 * spent / last;
    if (say && mean_ms > 1e3 / rate / 2) {
      std::string awake;
      for (BodyId b = 0; b < simulation.body_count(); ++b)
        if (!simulation.asleep(b))
          awake += fmt::format(" {} ({:.1f} mm/s, within {:.2f} mm)", simulation.name(b),
                               1e3 * speed_of(simulation, b), 1e3 * excursions.farthest(b));
      say(fmt::format("{}, seed {}, bout {}: still {:.1f} ms a step, awake:{}{}", simulation.scene().name,
                      options.seed, bout, mean_ms, awake, words));
    }
    out.bad_saves += bad_saves;
    out.rest_ms = std::max(out.rest_ms, mean_ms);
    out.least_volume = std::min(out.least_volume, end_state.least_volume);
    out.most_volume = std::max(out.most_volume, end_state.most_volume);
    out.overlap = std::max(out.overlap, end_state.overlap);
    if (end_state.good()) {
      out.recovery = std::max(out.recovery, good_since);
    } else {
      ++out.bad;
      out.found.push_back(fmt::format("{}, seed {}, bout {}, tick {}: {}{}", simulation.scene().name,
                                      options.seed, bout, simulation.time().tick, end_state.where, words));
      if (say) say(out.found.back());
    }
  }
  for (const Person& person : people) out.acts += person.acts();
  return out;
}

}  // namespace prosector::test
