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

/// A host's request for the accuracy of a body.
struct AccuracyWish {
  ParticipantId asker = 0;
  BodyId body = 0;
  std::string name;    // of the body
  double percent = 0;  // largest error allowed; 0: only report what is possible
};

/// The result of a request.
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

  /// Sets the choices with which the session runs now, and starts to verify those of the scene.
  void begin(std::vector<Choice> choices);
  void ask(AccuracyWish wish);
  /// Returns the errors and costs that bodies can have, of those that were asked about, by name.
  std::map<std::string, std::vector<Price>> prices() const;
  /// Returns the results of requests since the last call.
  std::vector<AccuracyAnswer> take_answers();
  /// Returns the scene in which a body is modelled as requested; none: there is none, or it was taken.
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
