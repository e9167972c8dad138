#pragma once
// Hand of a desk user. Its fingertips hover above the surface under the pointer; the button moves them in and
// closes the hand. A held part is dragged parallel to the image plane; an instrument hovers by its tip.

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "client/app/desk/cut_drawing.h"
#include "client/view/pick.h"
#include "common/math.h"

namespace prosector {

/// Input of a desk user's hand (driven by the mouse) in each frame: pointer, surface below it, simulated
/// hand, and held instrument.
struct HandGuide {
  Ray pointer;
  Vec3 back = Vec3::UnitZ();      // unit vector, out of the image towards the viewer
  double yaw = 0, pitch = 0;      // rad, angles of the view
  std::optional<double> surface;  // m along the pointer's ray; nullopt: the ray hits nothing
  bool soft = false;              // the surface belongs to a soft body
  double level = 0;               // y component of the surface normal: 1 for a surface facing up
  /// Function that returns the distance, m, from a point (m, world frame) to the next surface along the eye's
  /// ray through it. It is negative if the surface is in front of the point; nullopt if there is none. An
  /// empty function means that no surfaces are near.
  std::function<std::optional<double>(const Vec3&)> gap;
  bool still = false;            // the fingertips keep their position
  std::optional<Pose> physical;  // pose of the simulated wrist
  bool is_paused = false;        // simulated time does not advance
  std::optional<Vec3> tip;       // tip of the instrument in the hand, wrist frame, m
  // If the instrument is a blade:
  std::optional<BladeFrame> blade;  // in the wrist frame
  bool at_blade = false;            // the pointer is on a blade that can be grasped
  std::optional<Picked> tissue;     // point under the pointer, if that tissue can be cut
  FindSurface find;                 // finds the surface of the tissue that can be cut
  Vec3 right = Vec3::UnitX();       // unit vector, the image's right, world frame
};

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
  /// Rotates the wrist by two angles, rad. `bend` raises the direction in which the hand points,
  /// independently of the roll. `roll` is about that direction, clockwise as the user sees it, so an
  /// instrument grasped in a lying position stays level.
  void turn(double roll, double bend);
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
  bool is_withdrawn() const { return withdrawn_; }
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
  /// Timer of an attempt to grasp: time since the simulated hand last came nearer to the point where it
  /// should grasp.
  struct Waiting {
    double seconds = 0;
    double nearest = std::numeric_limits<double>::infinity();  // m, smallest distance so far
    void count(double distance, double passed);
  };

  /// Timer that detects a blocked hand: time since the simulated hand last moved.
  struct Staying {
    double seconds = 0;
    Vec3 at = Vec3::Constant(std::numeric_limits<double>::infinity());  // m, world frame
    void count(const Vec3& physical, double passed);
  };

  enum class Phase { hovers, goes_in, grips };

  Phase phase_ = Phase::hovers;
  Vec3 point_ = Vec3::Zero();  // m, world frame: position of the fingertips or of the instrument's tip
  Vec3 from_fingertips_ = Vec3::Zero();  // m, wrist frame: offset from the fingertips to point_
  double reach_ = 0;                     // m from the eye to point_
  double hover_ = first_hover, tool_hover_ = first_hover;  // m above the surface, along the ray
  bool meets_ = false;                                     // the pointer's ray hits a surface
  bool has_tool_ = false;
  Vec3 anchor_ = Vec3::Zero();  // m, world frame: target of point_ while a held part is dragged
  double pull_ = 0;             // m along the ray, not yet applied to the anchor
  double yaw_ = 0, lift_ = -0.5, roll_ = 0,
         bend_ = 0;        // rad; lift_: elevation of the fingers before the bend
  double seconds_in_ = 0;  // since the button was pressed
  Waiting waiting_;
  Staying blocked_;  // while it hovers away from its target
  bool withdrawn_ = false;
  double seconds_withdrawn_ = 0;
  bool button_ = false;           // is pressed
  double seconds_held_ = 0;       // since the hand closed
  bool takes_blade_ = false;      // the button was pressed on a blade
  bool asks_to_release_ = false;  // the button was released before the server reported the held body
  bool has_blade_ = false;
  double without_blade_ = 0;  // s since a blade was last in the hand
  double over_ground_ = 0;    // m, height of the blade's tip over the highest surface on its path
  bool upright_ = false;      // the blade was set upright on its tip since it was grasped
  CutDrawing drawing_;
  Quat rotated_ = Quat::Identity();  // rotation of the wrist due to cuts
  std::vector<Vec3> cut_line_;
  double flexion_ = 0.1;
  std::vector<HandRequest> wishes_;

  Quat wrist() const;
  Quat wrist_before_cuts() const;
  void put_down();
  void follow_blade(const HandGuide& guide, double seconds);
  bool draw_blade(const HandGuide& guide, double seconds);
  void set_upright(const HandGuide& guide, double seconds);
  Vec3 over_tissue(const HandGuide& guide, const Vec3& to);
  Vec3 wanted(const HandGuide& guide);
  double required_retreat(const HandGuide& guide, double reach) const;
  Pose pose_at(const Vec3& point) const;
  Vec3 drag_target(const HandGuide& guide);
  void lift_fingers(const HandGuide& guide, double seconds);
  void follow_tool(const HandGuide& guide, double seconds);
  void withdraw_if_blocked(const HandGuide& guide, double seconds);
  void grasp_when_reached(const HandGuide& guide, const Vec3& wanted);
};

}  // namespace prosector
