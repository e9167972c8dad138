#pragma once
// A user at a desk of `prosector-client join` in a hosted session: seat, mouse, hand and view are the
// client's own, network and time are stepped in one process.

#include <memory>
#include <string>

#include "client/app/desk/desk_session.h"
#include "client/replica/replica.h"
#include "idl/local_bus.h"
#include "server/physics/simulation.h"
#include "server/session/run/server_loop.h"
#include "tests/client/acted_window.h"
#include "tests/client/cover.h"

namespace prosector::test {

class SeatedUser {
 public:
  explicit SeatedUser(Simulation& simulation);

  /// Joins under a new id, before a window of that size (pixels), and draws the first picture.
  void join(int width, int height);
  /// Lets time pass, s, with pictures and ticks.
  void wait(double seconds);
  void point_at(const Eigen::Vector2d& pixel) { window_->events.push_back(MouseMoved{pixel.x(), pixel.y()}); }
  void press(bool down) { window_->events.push_back(MouseButtonEvent{MouseButton::left, down}); }
  void wheel(double notches) { window_->events.push_back(WheelTurned{0, notches}); }
  void key(Key key) { window_->press(key); }

  /// Returns the last picture as it is drawn for the user.
  const DrawList& picture() const { return picture_; }
  /// Measures it at a resolution of `longest` pixels. `seen`: pixels in which the anatomy is, without own
  /// hand and boards; null: not wanted.
  Cover cover(int longest, AnatomyPixels* seen = nullptr);
  bool holds() const;
  const std::string& scene() const { return simulation_.scene().name; }

 private:
  LocalNetwork network_;
  std::unique_ptr<Bus> server_bus_, bus_;
  Simulation& simulation_;
  ServerLoop loop_;
  Replica replica_;
  SceneView view_;
  std::unique_ptr<ActedWindow> window_;
  std::unique_ptr<Desk> desk_;
  ParticipantId self_ = 0;
  std::uint64_t sequence_ = 0;
  LocalUser user_;
  ViewSettings settings_;
  DrawList picture_;

  void step();
  void draw();
  void send();
  void command(const CommandBody& body);
  CoverSubject subject();
};

}  // namespace prosector::test
