#pragma once
// A blade that a desk user draws over an organ: its tip follows the pointer's path on the surface at a set
// depth below it. The blade's plane contains the path's direction and the surface normal.

#include <optional>
#include <vector>

#include "client/view/blade_frame.h"
#include "client/view/draped_line.h"

namespace prosector {

/// Input of a cut that a desk user (mouse and keyboard) draws over tissue, in each frame: blade, tissue under
/// the pointer, and simulated hand.
struct CutGuide {
  BladeFrame blade;                   // in the wrist frame
  std::optional<Picked> tissue;       // point under the pointer, if that tissue can be cut
  FindSurface find;                   // finds the surface of the tissue that can be cut
  Vec3 right = Vec3::UnitX();         // unit vector, the image's right, world frame
  std::optional<Pose> physical = {};  // pose of the simulated wrist
};

inline constexpr double first_cut_depth = 0.01;   // m
inline constexpr double least_cut_depth = 0.001;  // m
/// Longest time step, s, by which a late frame advances the blade. Physics moves the wrist in a straight line
/// to its next pose: over a longer path and rotation the tip would leave tissue, or nick it.
inline constexpr double longest_step = 0.1;
inline constexpr double over_cut = 0.03;  // m, height of the tip over the surface before and after a cut

/// Returns the wrist rotation, world frame, at which the blade is perpendicular to the surface with its edge
/// facing the direction of the cut. The tip trails as far as needed, within bounds, to keep the blade upright
/// in its plane. `blade`: in the wrist frame; `normal`: surface normal; `way`: direction of the cut,
/// perpendicular to it; both unit vectors.
Quat blade_rotation(const BladeFrame& blade, const Vec3& normal, const Vec3& way);
/// Returns the rotation `from`, rotated towards `to` by at most `most` rad.
Quat rotated_towards(const Quat& from, const Quat& to, double most);

class CutDrawing {
 public:
  /// Handles the press of the mouse button. A cut begins as soon as the pointer is on tissue; if one is still
  /// in progress, after its end.
  void press();
  /// Adds a point of tissue that was under the pointer between two frames to the path of the cut, so that the
  /// path follows the pointer at low frame rates. `find`: finds the tissue's surface.
  void trace(const Picked& tissue, const FindSurface& find);
  /// Handles the release of the mouse button: the path no longer follows the pointer. The blade still cuts
  /// the rest of the path.
  void release();
  /// Ends the cut immediately. The wrist is no longer driven, so the blade stays at its present position.
  void stop();
  /// Ends the cut at the blade's present position. If the blade is in tissue, it is lifted out along the
  /// surface normal.
  void withdraw_blade();
  /// Changes the cutting depth by wheel notches, positive for deeper: 1 mm each up to 20 mm depth, 5 mm
  /// above.
  void deepen(double notches);
  double depth() const { return depth_; }
  bool is_pressed() const { return pressed_; }
  /// Returns whether the cut drives the user's wrist: towards its beginning, along the path, or out of the
  /// tissue.
  bool leads() const { return phase_ != Phase::rests && phase_ != Phase::waits; }
  /// Returns whether a cut is in progress, from pressing the button until the blade is out of the tissue.
  bool is_under_way() const { return phase_ != Phase::rests; }
  /// Returns whether the pointer has reached tissue since the button was pressed, so that the path of the cut
  /// has begun.
  bool is_on_tissue() const { return !way_.empty(); }

  /// Advances the cut by a frame of `seconds`. `wrist`: the present target pose of the hand's wrist, world
  /// frame. Returns the next target pose; nullopt if the cut does not drive the hand.
  std::optional<Pose> advance(const CutGuide& guide, const Pose& wrist, double seconds);
  /// Returns the line on the tissue (points in m, world frame) that is still to be cut. Before a cut begins,
  /// returns the line that a cut at the pointer would begin with; empty if there is no tissue.
  std::vector<Vec3> line(const CutGuide& guide) const;

 private:
  enum class Phase { rests, waits, turns, cuts, lifts };
  struct Place {
    Vec3 at, normal;
  };

  Phase phase_ = Phase::rests;
  bool pressed_ = false;
  bool open_ = false;   // the path may grow
  bool again_ = false;  // the button was pressed before the last cut was complete
  double depth_ = first_cut_depth;
  BladeFrame blade_;          // blade pose at the button press: the hold yields under load
  std::vector<Place> way_;    // points on the surface
  std::vector<double> gone_;  // m, arc length along the path to each point
  BodyId organ_ = 0;
  double done_ = 0;              // m, arc length of the blade along the path
  double height_ = 0;            // m, height of the tip over the surface
  double seconds_ = 0;           // time in this phase
  double away_ = 0;              // s since the pointer left the organ
  bool came_on_ = false;         // the pointer moved onto the organ while the button was down
  std::optional<Vec3> last_;     // m: last position of the pointer on tissue
  Vec3 heading_ = Vec3::Zero();  // unit vector, direction of the pointer on tissue; zero: unknown

  void go_to(Phase phase);
  void follow_pointer(const CutGuide& guide, double seconds);
  void lead(const Picked& to, const FindSurface& find);
  void add(const Vec3& at, const Vec3& normal);
  void extend_over_rims(bool at_its_end);
  double length() const { return gone_.empty() ? 0 : gone_.back(); }
  Place place(double gone) const;
  Quat target_rotation() const;
  Pose wrist_at(const Quat& turn) const;
  Pose approach_path(const CutGuide& guide, const Pose& wrist, double seconds);
  Pose draw(const CutGuide& guide, const Pose& wrist, double seconds);
  Pose lift(const Pose& wrist, double seconds);
};

}  // namespace prosector
