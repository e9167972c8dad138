#pragma once
// The desk user: mouse and keyboard move the view and drive a hand.
//
//   move the mouse        the hand, in a plane across the view      wheel        its distance
//   left button           grasps while held                         right drag   turns the view around its
//   target middle drag           shifts the view                           W A S D Q E  fly H this list Esc
//   leave

#include "client/app/connection.h"
#include "client/render/window_context.h"

namespace prosector {

class Desk {
 public:
  explicit Desk(WindowContext& window) : window_(window) {}

  /// Reads the window's events. `start` is where the view begins.
  void update(const CameraInfo& start);
  bool closed() const;
  const Pose& eye() const { return eye_; }
  /// The hand as the mouse has it; publishes it, and grasp and release as commands.
  HandInput drive_hand(Connection& connection);

 private:
  WindowContext& window_;
  Pose eye_;
};

}  // namespace prosector
