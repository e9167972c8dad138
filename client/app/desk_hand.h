#pragma once
// The hand of a desk user. Its fingertips hover above what the pointer is at; the button brings them in and
// closes the hand. What it holds is drawn along the picture, and an instrument hovers by its tip.

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "client/app/cut_drawing.h"
#include "client/view/pick.h"
#include "common/math.h"

namespace prosector {

/// What the hand goes by, each picture.
struct HandGuide {
  Ray pointer;
  Vec3 back = Vec3::UnitZ();      // unit, out of the picture
  double yaw = 0, pitch = 0;      // rad, of the view
  std::optional<double> surface;  // m along the pointer's ray; nullopt: it meets nothing
  bool soft = false;              // the surface gives way
  double level = 0;               // how far it faces up: its normal's y
  /// Returns how far behind a place (m, world frame), as the eye sees it, the next surface is: below 0 it is
  /// before it; nullopt: there is none. Empty: nothing else is near.
  std::function<std::optional<double>(const Vec3&)> gap;
  bool still = false;            // the fingertips stay where they are
  std::optional<Pose> physical;  // the wrist as physics has it
  bool is_paused = false;        // simulated time does not advance
  std::optional<Vec3> tip;       // of the instrument in the hand, wrist frame
  // Where it is a blade:
  std::optional<BladeFrame> blade;  // in the wrist's frame
  bool at_blade = false;            // the pointer is at one that can be taken up
  std::optional<Picked> tissue;     // what the pointer is at, if it can be cut
  FindSurface find;                 // of what can be cut
  Vec3 right = Vec3::UnitX();       // unit, the picture's
};

/// What a hand at the desk asks the server for.
enum class HandWish { grasp, release };

inline constexpr double fastest_hand = 2;            // m/s, of the fingertips
inline constexpr double first_hover = 0.04;          // m above the surface, along the ray
inline constexpr double wrist_to_fingertips = 0.18;  // m, fingers stretched

class DeskHand {
 public:
  /// Puts the hand flat, the fingertips `reach` (m) along the pointer's ray.
  void begin(const Ray& pointer, double reach);
  /// Moves the fingertips farther away, m: nearer to the surface, or into it.
  void reach(double by);
  /// Turns the wrist, rad. `bend` lifts what points straight ahead, however the hand is rolled. `roll` is
  /// about that, clockwise as the user sees it, so that an instrument that was taken up lying stays level.
  void turn(double roll, double bend);
  /// Takes the button. With a blade in the hand it cuts, else it takes hold.
  void press();
  /// Takes the tissue that the pointer is at between two pictures: a drawn cut goes along it.
  void trace(const Picked& tissue, const FindSurface& find) { drawing_.trace(tissue, find); }
  /// Takes the button's release. A blade stays in the hand; a click beside tissue puts it down.
  void let_go();
  /// Goes on by a picture.
  void advance(const HandGuide& guide, double seconds);
  /// Ends a cut that is being drawn where it is, and lifts the blade out.
  void lift_blade() { drawing_.lift_out(); }
  /// Tells whether a drawn cut leads the blade.
  bool draws() const { return drawing_.leads(); }
  /// Tells whether a cut is drawn, from when the button goes down: all of it is one stroke.
  bool is_drawing() const { return drawing_.is_under_way(); }
  /// Returns what the hand asked for since the last call.
  std::vector<HandWish> take_wishes();

  bool is_pressed() const { return button_; }
  /// Tells whether it is open above what it is over, and neither the button nor the wheel brings it in.
  bool hovers() const;
  bool is_closed() const { return phase_ == Phase::grips; }
  /// Tells whether the server is to take the hand as untracked. Tissue that keeps a hovering hand from where
  /// it is wanted is left that way: the hand returns at the wanted place.
  bool is_withdrawn() const { return withdrawn_; }
  double flexion() const { return flexion_; }  // of every finger, 0 … 1
  /// Returns the pose of the wrist in the world frame.
  Pose pose() const;
  Vec3 fingertips() const;
  /// Returns the line on tissue that the blade in the hand is to cut, or would; empty: none. m, world frame.
  const std::vector<Vec3>& cut_line() const { return cut_line_; }
  /// Returns how deep (m) the blade in the hand is set to cut; nullopt: there is none.
  std::optional<double> cut_depth() const;

 private:
  /// How long the physical hand has been no nearer to where it is to grasp.
  struct Waiting {
    double seconds = 0;
    double nearest = std::numeric_limits<double>::infinity();  // m, so far
    void count(double distance, double passed);
  };

  /// How long the physical hand has stayed in one place.
  struct Staying {
    double seconds = 0;
    Vec3 at = Vec3::Constant(std::numeric_limits<double>::infinity());  // m, world frame
    void count(const Vec3& physical, double passed);
  };

  enum class Phase { hovers, goes_in, grips };

  Phase phase_ = Phase::hovers;
  Vec3 point_ = Vec3::Zero();            // m, world frame: the fingertips, or the instrument's tip
  Vec3 from_fingertips_ = Vec3::Zero();  // m, wrist frame: to the point
  double reach_ = 0;                     // m from the eye to the point
  double hover_ = first_hover, tool_hover_ = first_hover;  // m above the surface, along the ray
  bool meets_ = false;                                     // the pointer's ray met a surface
  bool has_tool_ = false;
  Vec3 anchor_ = Vec3::Zero();  // m, world frame: where the point is to be while the hand draws
  double pull_ = 0;             // m along the ray, that is still to be done to the anchor
  double yaw_ = 0, lift_ = -0.5, roll_ = 0, bend_ = 0;  // rad; lift: of the fingers, before the bend
  double seconds_in_ = 0;                               // since the button went down
  Waiting waiting_;
  Staying blocked_;  // while it hovers, away from where it is wanted
  bool withdrawn_ = false;
  double seconds_withdrawn_ = 0;
  bool button_ = false;           // is down
  double seconds_held_ = 0;       // since the hand closed
  bool takes_blade_ = false;      // the button went down on one
  bool asks_to_release_ = false;  // the button went up before it was known what the hand holds
  bool has_blade_ = false;
  double without_blade_ = 0;  // s since one was in the hand last
  double over_ground_ = 0;    // m, of its tip over the highest of what lies on its way
  bool upright_ = false;      // the blade was set on its tip since it was taken up
  CutDrawing drawing_;
  Quat turned_ = Quat::Identity();  // of the wrist, by cuts
  std::vector<Vec3> cut_line_;
  double flexion_ = 0.1;
  std::vector<HandWish> wishes_;

  Quat wrist() const;
  Quat wrist_by_hand() const;
  void put_down();
  void follow_blade(const HandGuide& guide, double seconds);
  bool draw_blade(const HandGuide& guide, double seconds);
  void set_upright(const HandGuide& guide, double seconds);
  Vec3 over_tissue(const HandGuide& guide, const Vec3& to);
  Vec3 wanted(const HandGuide& guide);
  double crowded(const HandGuide& guide, double reach) const;
  Pose pose_at(const Vec3& point) const;
  Vec3 drawn_along(const HandGuide& guide);
  void lift_fingers(const HandGuide& guide, double seconds);
  void follow_tool(const HandGuide& guide, double seconds);
  void come_free(const HandGuide& guide, double seconds);
  void grip_when_in(const HandGuide& guide, const Vec3& wanted);
};

}  // namespace prosector
