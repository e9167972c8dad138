#pragma once
// Hand of a desk user. Its fingertips hover above the surface under the pointer; the button moves them in and
// closes the hand. A held part is dragged parallel to the image plane; an instrument hovers by its tip.

#include <optional>
#include <vector>

#include "client/app/desk/blade_carry.h"
#include "client/app/desk/blade_hold.h"
#include "client/app/desk/cut_drawing.h"
#include "client/app/desk/desk_wrist.h"
#include "client/app/desk/grasp_approach.h"
#include "client/app/desk/hand_guide.h"
#include "client/app/desk/hand_withdrawal.h"
#include "client/app/desk/part_drag.h"
#include "client/view/pick.h"
#include "common/math.h"

namespace prosector {

/// Command that the hand of a desk user (mouse and keyboard) requests from the server.
enum class HandRequest { grasp, release };

inline constexpr double fastest_hand = 2;            // m/s, maximum speed of the fingertips
inline constexpr double first_hover = 0.04;          // m above the surface, along the ray
inline constexpr double wrist_to_fingertips = 0.18;  // m, with stretched fingers

class DeskHand {
 public:
  /// Sets the initial state: the hand is open and flat, with the fingertips at the distance `reach` (m) along
  /// the pointer's ray.
  void begin(const Ray& pointer, double reach);
  /// Handles the wheel: moves the hand by `by` m away from the eye. This lowers it onto the surface under the
  /// pointer, moves a held part, or, while a cut is being drawn, increases the cutting depth.
  void reach(double by);
  /// Rotates the wrist by two angles, rad, as DeskWrist::turn() does.
  void turn(double roll, double bend) { wrist_.turn(roll, bend); }
  /// Handles the press of the mouse button: starts a cut if the hand holds a blade; otherwise the hand moves
  /// to the surface and grasps.
  void press();
  /// Adds a point of tissue that was under the pointer between two frames to the path of the cut. `find`:
  /// finds the tissue's surface.
  void trace(const Picked& tissue, const FindSurface& find) { drawing_.trace(tissue, find); }
  /// Handles the release of the mouse button: the hand opens and releases the held body. A blade stays in the
  /// hand; a click off the tissue puts it down.
  void let_go();
  /// Advances the hand by a frame of `seconds`: moves it after the pointer, and grasps when it has reached
  /// the body.
  void advance(const HandGuide& guide, double seconds);
  /// Ends the current cut at its present position and lifts the blade out of the tissue.
  void lift_blade() { drawing_.withdraw_blade(); }
  /// Returns whether the hand with the blade moves along the cut that the user has drawn, rather than after
  /// the pointer.
  bool draws() const { return drawing_.leads(); }
  /// Returns whether a cut is in progress, from pressing the button until the blade is out of the tissue. All
  /// cuts in this time are one stroke for undo.
  bool is_drawing() const { return drawing_.is_under_way(); }
  /// Returns and removes the commands to the server (grasp, release) that the hand has requested since the
  /// last call.
  std::vector<HandRequest> take_wishes();

  bool is_pressed() const { return button_; }
  /// Returns whether the hand is open above a surface, and neither the mouse button nor the wheel brings it
  /// into contact.
  bool hovers() const;
  bool is_closed() const { return phase_ == Phase::grips; }
  /// Returns whether the server should treat the hand as untracked for the moment. This frees a hovering hand
  /// that tissue blocks from its target: the simulated hand then reappears at the target.
  bool is_withdrawn() const { return withdrawal_.is_withdrawn(); }
  double flexion() const { return flexion_; }  // of every finger, 0 … 1
  /// Returns the target pose of the wrist, world frame, which is sent to the server.
  Pose pose() const;
  Vec3 fingertips() const;
  /// Returns the line on tissue (points in m, world frame) that the blade in the hand will or would cut;
  /// empty if there is none.
  const std::vector<Vec3>& cut_line() const { return cut_line_; }
  /// Returns the cutting depth, m, that the user has set for the blade in the hand; nullopt if the hand holds
  /// no blade.
  std::optional<double> cut_depth() const;

 private:
  enum class Phase { hovers, goes_in, grips };

  Phase phase_ = Phase::hovers;
  Vec3 point_ = Vec3::Zero();  // m, world frame: position of the fingertips or of the instrument's tip
  Vec3 from_fingertips_ = Vec3::Zero();  // m, wrist frame: offset from the fingertips to point_
  double reach_ = 0;                     // m from the eye to point_
  double hover_ = first_hover, tool_hover_ = first_hover;  // m above the surface, along the ray
  bool meets_ = false;                                     // the pointer's ray hits a surface
  bool has_tool_ = false;
  PartDrag drag_;
  DeskWrist wrist_;
  GraspApproach approach_;
  HandWithdrawal withdrawal_;
  bool button_ = false;  // is pressed
  BladeHold hold_;
  BladeCarry carry_;
  CutDrawing drawing_;
  std::vector<Vec3> cut_line_;
  double flexion_ = 0.1;
  std::vector<HandRequest> wishes_;

  void put_down();
  void follow_blade(const HandGuide& guide, double seconds);
  bool draw_blade(const HandGuide& guide, double seconds);
  Vec3 target(const HandGuide& guide);
  Vec3 target_at_pointer(const HandGuide& guide);
  double required_retreat(const HandGuide& guide, double reach) const;
  Pose pose_at(const Vec3& point) const;
  void follow_tool(const HandGuide& guide, double seconds);
  void grasp_when_reached(const HandGuide& guide, const Vec3& to, double seconds);
};

}  // namespace prosector
