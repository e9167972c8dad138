#pragma once
// A blade that a desk user draws over an organ: its tip goes along the pointer's way on the surface, at a set
// depth below it. The blade's plane is that of the way and the surface's normal.

#include <optional>
#include <vector>

#include "client/view/blade_frame.h"
#include "client/view/draped_line.h"

namespace prosector {

/// What the blade goes by, each picture.
struct CutGuide {
  BladeFrame blade;                   // in the wrist's frame
  std::optional<Picked> tissue;       // what the pointer is at, if it can be cut
  FindSurface find;                   // of what can be cut
  Vec3 right = Vec3::UnitX();         // unit, the picture's
  std::optional<Pose> physical = {};  // the wrist as physics has it
};

inline constexpr double first_cut_depth = 0.01;   // m
inline constexpr double least_cut_depth = 0.001;  // m
/// s that a late picture leads a blade on by. Physics goes straight to where the wrist is next: over a longer
/// way and turn the tip would leave tissue, or nick it.
inline constexpr double longest_step = 0.1;
inline constexpr double over_cut = 0.03;  // m, of the tip over the surface before and after a cut

/// Returns the wrist's turn in which the blade stands on a surface, its edge ahead. Its tip trails as far as
/// keeps it upright in its plane, within bounds. `normal`: of the surface; `way`: ahead, at right angles to
/// that; both unit.
Quat drawing_turn(const BladeFrame& blade, const Vec3& normal, const Vec3& way);
/// Returns the turn on the way from one to another, `most` (rad) farther.
Quat turned_towards(const Quat& from, const Quat& to, double most);

class CutDrawing {
 public:
  /// Begins a cut where the pointer is, or comes to.
  void press();
  /// Takes what tissue the pointer is at between two pictures, so that the way is the pointer's own however
  /// seldom pictures come.
  void trace(const Picked& tissue, const FindSurface& find);
  /// Ends the way. What of it isn't cut yet is cut still.
  void release();
  /// Ends the cut where it is.
  void stop();
  /// Ends the cut where it is, and brings a blade in tissue out by the way it came.
  void lift_out();
  /// Sets the depth by notches of a wheel: a millimetre each, 5 mm where it is deep.
  void deepen(double notches);
  double depth() const { return depth_; }
  bool is_pressed() const { return pressed_; }
  /// Tells whether the blade is led: to a cut, along it, or out of it.
  bool leads() const { return phase_ != Phase::rests && phase_ != Phase::waits; }
  /// Tells whether a cut is drawn: from when the button goes down until its blade is out again.
  bool is_under_way() const { return phase_ != Phase::rests; }
  /// Tells whether the way has begun since the button went down.
  bool is_on_tissue() const { return !way_.empty(); }

  /// Goes on by a picture. Returns where the wrist is to be, which the hand has at `wrist` now; nullopt: that
  /// is the hand's own affair.
  std::optional<Pose> advance(const CutGuide& guide, const Pose& wrist, double seconds);
  /// Returns the line on the tissue that is to be cut, or would be; m, world frame.
  std::vector<Vec3> line(const CutGuide& guide) const;

 private:
  enum class Phase { rests, waits, turns, cuts, lifts };
  struct Place {
    Vec3 at, normal;
  };

  Phase phase_ = Phase::rests;
  bool pressed_ = false;
  bool open_ = false;   // the way goes on
  bool again_ = false;  // the button went down while the last cut was not done
  double depth_ = first_cut_depth;
  BladeFrame blade_;          // as it was when the button went down: its hold gives way under load
  std::vector<Place> way_;    // on the surface
  std::vector<double> gone_;  // m, along the way to each place
  BodyId organ_ = 0;
  double done_ = 0;              // m, along the way: where the blade is
  double height_ = 0;            // m, of the tip over the surface
  double seconds_ = 0;           // in this phase
  double away_ = 0;              // s, of the pointer from the organ
  bool came_on_ = false;         // the pointer came onto the organ while the button was down
  std::optional<Vec3> last_;     // m: where the pointer was on tissue
  Vec3 heading_ = Vec3::Zero();  // unit, of the pointer on tissue; zero: not known

  void go_to(Phase phase);
  void follow_pointer(const CutGuide& guide, double seconds);
  void lead(const Picked& to, const FindSurface& find);
  void add(const Vec3& at, const Vec3& normal);
  void lengthen_over_rims(bool at_its_end);
  double length() const { return gone_.empty() ? 0 : gone_.back(); }
  Place place(double gone) const;
  Quat wanted_turn() const;
  Pose wrist_at(const Quat& turn) const;
  Pose come_over(const CutGuide& guide, const Pose& wrist, double seconds);
  Pose draw(const CutGuide& guide, const Pose& wrist, double seconds);
  Pose lift(const Pose& wrist, double seconds);
};

}  // namespace prosector
