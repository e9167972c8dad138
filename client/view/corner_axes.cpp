#include "client/view/corner_axes.h"

#include <array>
#include <string>

#include "client/view/overlay_frame.h"

namespace prosector {
namespace {

constexpr double margin = 56;         // points, from the borders to the origin of the axes
constexpr double letter_height = 12;  // points
constexpr double letter_gap = 11;     // points, from an axis' end to its letter's centre
constexpr double axis_length = 42;    // points, of an axis perpendicular to the view direction
constexpr double half_length = 34;    // points, of an axis with two ends
constexpr double min_visible_opacity =
    0.25;  // fraction of its length: a two-ended axis that appears shorter has no letters

struct Axis {
  Vec3 direction;  // unit, world frame
  Vec3 color;
  std::string end, other_end;  // letters; an axis without other_end begins at the origin
};

const std::array<Vec3, 3> colors = {{{0.9, 0.05, 0.04}, {0.05, 0.75, 0.08}, {0.08, 0.2, 1.0}}};

std::array<Axis, 3> axes_of(const std::optional<PatientFrame>& patient) {
  if (!patient)
    return {{{Vec3::UnitX(), colors[0], "x", ""},
             {Vec3::UnitY(), colors[1], "y", ""},
             {Vec3::UnitZ(), colors[2], "z", ""}}};
  return {{{patient->right.normalized(), colors[0], "R", "L"},
           {patient->front(), colors[1], "A", "P"},
           {patient->head.normalized(), colors[2], "S", "I"}}};
}

/// Draws in a view's lower left corner; positions are points from there, y upwards.
class CornerDrawing {
 public:
  CornerDrawing(DrawList& list, const DrawCamera& camera) : list_(list), picture_(camera, list.scale) {}

  void add_line(const Vec3& from, const Vec3& to, const Vec3& color) {
    list_.lines.push_back({to_ndc(from), to_ndc(to), color, 3, true});
  }

  void add_letter(const std::string& letter, const Vec3& at, const Vec3& color) {
    DrawText label;
    label.text = letter;
    label.at = {at.x(), picture_.height - at.y(), 0};
    label.height = letter_height;
    label.centred = true;
    label.color = (color + Vec3::Ones()) / 2;
    list_.texts.push_back(label);
  }

 private:
  DrawList& list_;
  OverlayFrame picture_;

  Vec3 to_ndc(const Vec3& at) const { return picture_.at(at.x(), picture_.height - at.y()); }
};

}  // namespace

void add_corner_axes(DrawList& list, const std::optional<PatientFrame>& patient, const DrawCamera& camera) {
  CornerDrawing corner(list, camera);
  const Vec3 middle(margin, margin, 0);
  for (const Axis& axis : axes_of(patient)) {
    Vec3 seen = camera.pose.q.conjugate() * axis.direction;
    seen.z() = 0;
    const bool two_ends = !axis.other_end.empty();
    const Vec3 reach = (two_ends ? half_length : axis_length) * seen, gap = letter_gap * seen.normalized();
    corner.add_line(two_ends ? Vec3(middle - reach) : middle, middle + reach, axis.color);
    if (two_ends && seen.norm() < min_visible_opacity) continue;
    corner.add_letter(axis.end, middle + reach + gap, axis.color);
    if (two_ends) corner.add_letter(axis.other_end, middle - reach - gap, axis.color);
  }
}

}  // namespace prosector
