#pragma once
// A session's bodies modelled in other ways while it runs: ways are tried and the scene is compiled beside
// it, on a thread that gives way to the session. That thread also proves, while nobody wishes for anything,
// what was chosen when the scene was loaded; from the next start on bodies are modelled by what it finds.

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/calibration/choose_scene.h"
#include "server/session/ready_scene.h"

namespace prosector {

/// What a host wants of a body.
struct AccuracyWish {
  ParticipantId asker = 0;
  BodyId body = 0;
  std::string name;    // of the body
  double percent = 0;  // to be off by at most; 0: only what it can have
};

/// What came of a wish.
struct AccuracyAnswer {
  AccuracyWish wish;
  std::string words;  // for who asked
};

class Remodeller {
 public:
  struct Hooks {
    std::function<SceneDesc()> describe;  // the scene as its text says; throws InputError
    ChoiceOptions choosing;
    std::function<std::unique_ptr<Simulation>(const SceneDesc&)> compile;
    std::function<void()> ready;                       // called when a scene is there to take()
    std::function<void(const std::string&)> say = {};  // what a proof finds; may be called by any thread
  };

  explicit Remodeller(Hooks hooks);

  /// Says with which choices the session runs now, and has what the scene asks for proved.
  void begin(std::vector<Choice> choices);
  void ask(AccuracyWish wish);
  /// Returns what bodies can have, of those that were asked about, by name.
  std::map<std::string, std::vector<Price>> prices() const;
  /// Returns what came of wishes since the last call.
  std::vector<AccuracyAnswer> take_answers();
  /// Takes the scene in which a body is modelled as it was wished; none: there is none, or it was taken.
  std::optional<ReadyScene> take();

 private:
  Hooks hooks_;
  mutable std::mutex mutex_;
  std::condition_variable_any asked_;
  std::deque<AccuracyWish> wishes_;
  std::vector<AccuracyAnswer> answers_;
  std::map<std::string, std::vector<Price>> prices_;
  std::vector<Choice> choices_;
  std::optional<ReadyScene> made_;
  bool unproved_ = false;
  std::jthread thread_;  // last: it ends before what it uses

  void run(const std::stop_token& stop);
  AccuracyAnswer answer(const AccuracyWish& wish);
  void prove(const std::stop_token& stop);
  std::string remodel(const AccuracyWish& wish, const SceneDesc& scene, const Choice& choice,
                      std::vector<Choice> choices);
};

}  // namespace prosector
