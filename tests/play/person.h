#pragma once
// A person who plays: sweeps, pokes, pinches, holds and pulls organs, takes up instruments and cuts, at any
// speed. What they do follows from a seed and from where the organs are.

#include <string>

#include "server/physics/simulation.h"
#include "tests/random.h"

namespace prosector::test {

class Person {
 public:
  Person(ParticipantId who, unsigned seed) : who_(who), random_(seed) {}

  /// Adds what this person does in the next tick.
  void act(const Simulation& simulation, TickInput& input);
  /// Adds the end of it: the hands open and vanish.
  void leave(TickInput& input);
  /// What was done so far, a word for each act.
  const std::string& story() const { return story_; }
  int acts() const { return acts_; }

 private:
  struct Waypoint {
    Vec3 at = Vec3::Zero();  // m: fingertips, room frame
    double speed = 1;        // m/s
    double wait = 0;         // s, once there
    double flexion = 0.1;    // of the fingers, from there on
    enum class Then : std::uint8_t { nothing, grasp, release } then = Then::nothing;
  };

  void plan(const Simulation& simulation, TickInput& input);
  Vec3 some_point(const Simulation& simulation);  // on the surface of an organ
  double some_speed();
  void sweep(const Simulation& simulation);
  void poke(const Simulation& simulation);
  void pull(const Simulation& simulation);
  void wield(const Simulation& simulation);
  void meddle(const Simulation& simulation, TickInput& input);
  Pose wrist() const;

  ParticipantId who_;
  Random random_;
  std::vector<Waypoint> way_;  // last first
  Vec3 at_ = Vec3(0, 1.5, 0.5);
  Quat rotated_ = Quat::Identity();
  double flexion_ = 0.1, waited_ = 0;
  bool there_ = false;
  std::string story_;
  int acts_ = 0;
};

}  // namespace prosector::test
