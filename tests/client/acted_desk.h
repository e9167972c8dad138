#pragma once
// A person at a desk over a hosted session, acted in one process and in stepped time: late pictures, late
// samples and slow ticks are what a busy machine makes of it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/desk/desk_hand.h"
#include "client/replica/replica.h"
#include "client/replica/stroke_figures.h"
#include "client/view/scene_view.h"
#include "idl/local_bus.h"
#include "server/physics/simulation.h"
#include "server/session/run/server_loop.h"

namespace prosector::test {

/// Returns the body of that name. Throws std::runtime_error if there is none.
BodyId body_named(const Simulation& simulation, const std::string& name);

/// How well the machines keep up.
struct Haste {
  int picture_ms = 30;  // between pictures
  int tick_ms = 17;     // between ticks, of which each simulates a 60th of a second
  int delay_ms = 5;     // of the network, one way
  int stall_ms = 0;     // of the client, once a second
};

class ActedDesk {
 public:
  ActedDesk(Simulation& simulation, const Haste& haste);

  /// Lets time pass, s.
  void wait(double seconds);
  /// Moves the pointer, which looks straight down, over a place in the room.
  void point_at(const Vec3& place);
  /// Moves it evenly from place to place, s.
  void draw(const Vec3& from, const Vec3& to, double seconds);
  void press() {
    hand_.press();
    asked_for_ = true;
  }
  void let_go() { hand_.let_go(); }
  /// Waits until the hand holds the body, or not; false: not within that time, s.
  bool waits_until_held(BodyId body, bool held, double seconds);
  bool holds(BodyId body) const;
  bool draws() const { return hand_.draws(); }
  /// Takes the last cut back, once the blade is out.
  void take_back();
  /// Asks the server for something.
  void ask(const CommandBody& body) { command(body); }
  /// Lets the client do nothing at all while that much time passes, s.
  void stall(double seconds);

  /// Returns the server's lines, what it told this person of refusals and losses, and the strokes that ended.
  const std::vector<std::string>& log() const { return log_; }
  const std::vector<std::string>& messages() const { return messages_; }
  const std::vector<StrokeFigures>& strokes() const { return strokes_; }

 private:
  Haste haste_;
  LocalNetwork network_;
  std::unique_ptr<Bus> server_bus_, bus_;
  std::vector<std::string> log_;
  ServerLoop loop_;
  Simulation& simulation_;
  Replica replica_;
  SceneView view_;
  DeskHand hand_;
  ParticipantId self_ = 1;
  std::uint64_t sequence_ = 0;
  Vec3 pointed_{0, 1, 0};
  std::optional<BodyId> pressed_at_;
  std::vector<std::string> messages_;
  std::vector<StrokeFigures> strokes_;
  StrokeTracker gauge_;
  bool asked_for_ = false;
  std::int64_t ms_ = 0, next_tick_ = 0, next_picture_ = 0, next_send_ = 0, last_picture_ = 0, next_stall_ = 0;
  bool is_stalled_ = false;

  void millisecond();
  void take();
  void picture();
  void send_hand();
  void command(const CommandBody& body);
  HandGuide guide(double tick);
  std::optional<Picked> surface(const Ray& ray);
  std::optional<Picked> found(const Ray& ray, std::optional<BodyId> only);
};

}  // namespace prosector::test
