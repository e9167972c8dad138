#pragma once
// Changes the models of a session's bodies while it runs. Trials and the compilation of the scene run on a
// thread of low priority. While there are no requests, that thread verifies the choices made when the scene
// was loaded; its results apply from the next start on.

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/error_estimate.h"
#include "server/calibration/choose_scene.h"
#include "server/session/run/ready_scene.h"

namespace prosector {

/// A host's request to simulate a body with another accuracy.
struct AccuracyWish {
  ParticipantId asker = 0;
  BodyId body = 0;
  std::string name;    // of the body
  double percent = 0;  // largest error allowed; 0: only report what is possible
};

/// The answer to a host's request to simulate a body with another accuracy.
struct AccuracyAnswer {
  AccuracyWish wish;
  std::string words;  // text for the asker
};

class Remodeller {
 public:
  struct Hooks {
    std::function<SceneDesc()> describe;  // reads the scene from its text; throws InputError
    ChoiceOptions choosing;
    std::function<std::unique_ptr<Simulation>(const SceneDesc&)> compile;
    std::function<void()> ready;                       // called when a scene is available from take()
    std::function<void(const std::string&)> say = {};  // gets results of verifications, on any thread
  };

  explicit Remodeller(Hooks hooks);

  /// Sets the model configurations with which the session runs now. Starts to verify, on a background thread,
  /// whether the configurations that were chosen for the scene meet the accuracy that it requests.
  void begin(std::vector<Choice> choices);
  void ask(AccuracyWish wish);
  /// Returns, by body name, the errors and costs that are available for the bodies of earlier requests.
  std::map<std::string, std::vector<Price>> prices() const;
  /// Returns the answers to requests for other accuracies that were completed since the last call.
  std::vector<AccuracyAnswer> take_answers();
  /// Returns the compiled scene in which a body is modelled as requested. Returns none if no such scene is
  /// ready or it was already taken.
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
  std::jthread thread_;  // last member: it ends before the data that it uses

  void run(const std::stop_token& stop);
  AccuracyAnswer answer(const AccuracyWish& wish);
  void prove(const std::stop_token& stop);
  std::string remodel(const AccuracyWish& wish, const SceneDesc& scene, const Choice& choice,
                      std::vector<Choice> choices);
};

}  // namespace prosector
