#include "server/session/run/remodeller.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "common/percent_text.h"
#include "server/calibration/accuracy_change.h"

namespace prosector {
namespace {

constexpr int gives_way = 10;  // nice value of the thread

/// Returns the choices with `choice` in place of the body's earlier one.
std::vector<Choice> with(std::vector<Choice> choices, const Choice& choice) {
  std::erase_if(choices, [&](const Choice& c) { return c.body == choice.body; });
  choices.push_back(choice);
  return choices;
}

/// Thrown to interrupt a verification for a more urgent task.
struct PutOff {};

/// Returns whether a verification changed the choice, or its expected error by more than a tenth.
bool differ(const Choice& chosen, const Choice& proved) {
  constexpr double alike = 0.1;  // of the error: smaller changes don't count
  return !(chosen.rung == proved.rung) || chosen.cell != proved.cell || chosen.grade != proved.grade ||
         std::abs(proved.expected.error - chosen.expected.error) > alike * chosen.expected.error;
}

std::string in_words(const Choice& choice) {
  return fmt::format("error {}, {:.2g} ms per frame", percent_text(choice.expected.error),
                     choice.expected.ms);
}

}  // namespace

Remodeller::Remodeller(Hooks hooks)
    : hooks_(std::move(hooks)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

void Remodeller::begin(std::vector<Choice> choices) {
  const std::lock_guard lock(mutex_);
  choices_ = std::move(choices);
  unproved_ = !choices_.empty() && hooks_.choosing.on_the_body;
  asked_.notify_one();
}

void Remodeller::ask(AccuracyWish wish) {
  const std::lock_guard lock(mutex_);
  std::erase_if(wishes_, [&](const AccuracyWish& earlier) { return earlier.body == wish.body; });
  wishes_.push_back(std::move(wish));
  asked_.notify_one();
}

std::map<std::string, std::vector<Price>> Remodeller::prices() const {
  const std::lock_guard lock(mutex_);
  return prices_;
}

std::vector<AccuracyAnswer> Remodeller::take_answers() {
  const std::lock_guard lock(mutex_);
  return std::exchange(answers_, {});
}

std::optional<ReadyScene> Remodeller::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(made_, std::nullopt);
}

void Remodeller::run(const std::stop_token& stop) {
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), gives_way);  // failure is no error
  tbb::task_arena alone(1);  // the other threads are left to the session
  std::unique_lock lock(mutex_);
  while (asked_.wait(lock, stop, [&] { return !wishes_.empty() || unproved_; })) {
    if (wishes_.empty()) {
      unproved_ = false;
      lock.unlock();
      alone.execute([&] { prove(stop); });
      lock.lock();
      continue;
    }
    const AccuracyWish wish = std::move(wishes_.front());
    wishes_.pop_front();
    lock.unlock();
    AccuracyAnswer found = alone.execute([&] { return answer(wish); });
    lock.lock();
    answers_.push_back(std::move(found));
  }
}

/// Verifies the choices for the scene's bodies and reports what changes; the results are cached. Postponed
/// while there are requests.
void Remodeller::prove(const std::stop_token& stop) {
  ChoiceOptions options = hooks_.choosing;
  options.sources.progress = {};
  options.before_step = [&] {
    const std::lock_guard lock(mutex_);
    if (!wishes_.empty()) unproved_ = true;
    if (unproved_ || stop.stop_requested()) throw PutOff{};
  };
  RungTable measured;  // rows that the cached table lacks: both choices use the same ones
  options.measure = [&](const RungTrial& trial) {
    if (const RungFigures* known = measured.find(trial)) return *known;
    options.before_step();
    measured.add(trial, hooks_.choosing.measure(trial));
    return *measured.find(trial);
  };
  try {
    const SceneDesc scene = hooks_.describe();
    SceneDesc chosen_scene = scene, proved_scene = scene;
    const std::vector<Choice> chosen = choose_rungs(chosen_scene, options);
    options.prove = true;
    const std::vector<Choice> proved = choose_rungs(proved_scene, options);
    if (!hooks_.say) return;
    for (std::size_t i = 0; i < proved.size(); ++i) {
      if (!differ(chosen[i], proved[i])) continue;
      const auto body = std::find_if(scene.soft.begin(), scene.soft.end(),
                                     [&](const SoftDesc& desc) { return desc.name == proved[i].body; });
      hooks_.say(
          fmt::format("{}: its model configuration was verified with finer elements: {}; the result is used "
                      "from the next start",
                      proved[i].body, explain(proved[i], *body)));
    }
  } catch (const PutOff&) {
  } catch (const std::exception& error) {
    if (hooks_.say)
      hooks_.say(fmt::format("the chosen model configurations cannot be verified with finer elements: {}",
                             error.what()));
  }
}

/// Finds the errors and costs that the body can have, and remodels it as requested, or returns why not.
AccuracyAnswer Remodeller::answer(const AccuracyWish& wish) {
  AccuracyAnswer out{wish, {}};
  std::vector<Choice> choices;
  {
    const std::lock_guard lock(mutex_);
    choices = choices_;
  }
  try {
    SceneDesc scene = hooks_.describe();
    adopt(choices, scene);
    const AccuracyChange dial(scene, wish.name, hooks_.choosing);
    const std::vector<Price> prices = dial.prices();
    const std::string can_have =
        fmt::format("{}: available accuracies: {}", wish.name, prosector::in_words(prices));
    {
      const std::lock_guard lock(mutex_);
      prices_[wish.name] = prices;
    }
    if (wish.percent > 0) {
      const Choice choice = dial.choose(wish.percent);
      out.words = choice.good_enough ? remodel(wish, scene, choice, std::move(choices))
                                     : fmt::format("no configuration reaches {}: {}",
                                                   percent_text(0.01 * wish.percent), can_have);
    } else {
      out.words = can_have;
    }
  } catch (const std::exception& error) {
    out.words = error.what();
  }
  return out;
}

/// Compiles the scene with that choice. Returns a message about the result.
std::string Remodeller::remodel(const AccuracyWish& wish, const SceneDesc& scene, const Choice& choice,
                                std::vector<Choice> choices) {
  choices = with(std::move(choices), choice);
  SceneDesc changed = scene;
  adopt(choices, changed);
  ReadyScene made{choices, hooks_.compile(changed)};
  {
    const std::lock_guard lock(mutex_);
    made_ = std::move(made);
  }
  hooks_.ready();
  return fmt::format("{} is remodelled: expected {}", wish.name, in_words(choice));
}

}  // namespace prosector
