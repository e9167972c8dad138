#include "common/scene/curve_fields.h"

#include "common/curves/nurbs_curve.h"
#include "common/scene/field_rows.h"

namespace prosector {
namespace {

constexpr Range weight{1e-6, 1e6};
constexpr Range knot{-1e6, 1e6};
constexpr Range degree{1, max_degree};
constexpr Range size{0, 10, true};
constexpr Range tolerance{1e-6, 1, false};
constexpr const char* about_knots =
    "bspline knots: points + degree + 1 values, non-decreasing; default: uniform, clamped at the ends";

template <class Struct, auto... Path>
Field list(std::string_view key, Hashed hashed, std::string_view unit, Range range,
           std::string_view description) {
  Field out = number<Struct, Path...>(key, hashed, unit, range, description);
  out.max_length = max_control_points;
  return out;
}

template <class Struct>
Table with_tolerance(Table table) {
  table.fields.push_back(number<Struct, &Struct::tolerance>(
      "tolerance", compiled, "m", tolerance, "maximum distance of the triangles from the exact surface"));
  return table;
}

/// Adds the unused key `tolerance`, for compatibility with scenes of version 0.1.
template <class Struct>
Table with_unused_tolerance(Table table) {
  table.fields.push_back(
      number<Struct, &Struct::tolerance>("tolerance", not_hashed, "m", tolerance,
                                         "deprecated, no effect; the body's `cell` sets the resolution"));
  return table;
}

/// Returns the fields of a curve given by control points: a tube's centre line, or a side of a patch.
std::vector<Field> spline_rows(std::vector<std::string_view> kinds, std::string_view about) {
  using C = CurveDesc;
  return {words<C, &C::kind>("kind", compiled, std::move(kinds), about),
          list<C, &C::points>("points", compiled, "m", coordinate, "control points of a bezier or bspline"),
          list<C, &C::weights>("weights", compiled, "", weight, "weights of the points; default: all 1"),
          number<C, &C::degree>("degree", compiled, "", degree,
                                "degree of a bspline; a bezier's is its number of points minus one"),
          list<C, &C::knots>("knots", compiled, "", knot, about_knots)};
}

Table curve_table(std::string_view name, std::string_view about) {
  using C = CurveDesc;
  Table t{name,
          about,
          spline_rows({"bezier", "bspline", "ellipse", "parabola", "hyperbola"},
                      "type of curve; conics in the x-y plane: ellipse (a cos t, b sin t), parabola (a t², 2 "
                      "a t), hyperbola (a cosh t, b sinh t)"),
          {},
          fresh<C>};
  for (Field& field : std::vector<Field>{
           number<C, &C::a>("a", compiled, "m", size, "conics: a in the formula of `kind`"),
           number<C, &C::b>("b", compiled, "m", size, "ellipse, hyperbola: b in the formula of `kind`"),
           number<C, &C::from>("from", compiled, "", {-10, 10},
                               "conics: parameter t where the arc begins; ellipse: rad"),
           number<C, &C::to>("to", compiled, "", {-10, 10},
                             "conics: parameter t where the arc ends; ellipse: at most 2π more than `from`"),
           number<C, &C::diameter>("diameter", compiled, "m", size, "diameter of the tube")})
    t.fields.push_back(std::move(field));
  add_pose<C>(t.fields, "the curve's origin in the body's frame");
  return t;
}

Table side_table(std::string_view name) {
  return {name,
          "A `side` table is the profile of a revolved patch, or one of a Coons patch's four sides, which "
          "meet at the corners. Order of a Coons patch's sides: along u at v = 0, along u at v = 1, along v "
          "at u = 0, along v at u = 1.",
          spline_rows({"bezier", "bspline"}, ""),
          {},
          fresh<CurveDesc>};
}

Table patch_table(std::string_view name, std::string_view about, const Table& (*side)()) {
  using P = PatchDesc;
  Table t{name,
          about,
          {words<P, &P::kind>("kind", compiled, {"bezier", "bspline", "coons", "revolved"},
                              "bezier, bspline: tensor product; coons: between four sides; revolved: one "
                              "profile in the x-y plane, at x >= 0, rotated about y"),
           list<P, &P::points>("points", compiled, "m", coordinate, "control points, row by row along u"),
           number<P, &P::columns>("columns", compiled, "", {2, max_control_points},
                                  "number of control points in a row"),
           list<P, &P::weights>("weights", compiled, "", weight, "weights of the points; default: all 1"),
           number<P, &P::degree_u>("degree_u", compiled, "", degree, "bspline: degree along u"),
           number<P, &P::degree_v>("degree_v", compiled, "", degree, "bspline: degree along v"),
           list<P, &P::knots_u>("knots_u", compiled, "", knot, about_knots),
           list<P, &P::knots_v>("knots_v", compiled, "", knot, about_knots),
           number<P, &P::thickness>("thickness", compiled, "m", size,
                                    "thickness of the patch, half of it on either side of the surface")},
          {{"side", side, true, 4, items<P, &P::sides>}},
          fresh<P>};
  add_pose<P>(t.fields, "the patch's origin in the body's frame");
  return t;
}

const Table& rigid_side_table() {
  static const Table table = side_table("[[rigid.patch.side]]");
  return table;
}

const Table& soft_side_table() {
  static const Table table = side_table("[[soft.patch.side]]");
  return table;
}

}  // namespace

const Table& rigid_curve_table() {
  static const Table table = with_tolerance<CurveDesc>(curve_table(
      "[[rigid.curve]]",
      "A `[[rigid.curve]]` is a tube around a curve, with flat ends; a smoothly closed curve gives a ring."));
  return table;
}

const Table& rigid_patch_table() {
  static const Table table = with_tolerance<PatchDesc>(patch_table(
      "[[rigid.patch]]", "A `[[rigid.patch]]` is a piece of a curved surface with the thickness `thickness`.",
      rigid_side_table));
  return table;
}

const Table& soft_curve_table() {
  static const Table table = with_unused_tolerance<CurveDesc>(
      curve_table("[[soft.curve]]",
                  "A `[[soft.curve]]` is the centre line of a rope at rest, with the rope's diameter; the "
                  "rope's unloaded shape is straight."));
  return table;
}

const Table& soft_patch_table() {
  static const Table table = with_unused_tolerance<PatchDesc>(
      patch_table("[[soft.patch]]",
                  "A `[[soft.patch]]` is the middle surface of a sheet at rest, with the sheet's thickness; "
                  "the sheet's unloaded shape is flat.",
                  soft_side_table));
  return table;
}

}  // namespace prosector
