#pragma once
// Conic arcs as rational quadratic curves, which represent them exactly (Piegl & Tiller, The NURBS Book, 2nd
// ed. 1997, ch. 7; Farin, Curves and Surfaces for CAGD, 5th ed. 2002, ch. 12). The curves are in the x-y
// plane around the origin. The angle or parameter is exact at the ends and at the joints between arcs.

#include "common/curves/nurbs_curve.h"

namespace prosector {

/// Returns the elliptic arc (a cos t, b sin t) for t from `from` to `to`, with from < to <= from + 2π, split
/// into arcs of at most a quarter turn.
NurbsCurve ellipse_arc(double a, double b, double from, double to);
/// Returns the parabolic arc (a t², 2 a t) for t from `from` to `to`. The parabola's focus is at x = a.
NurbsCurve parabola_arc(double a, double from, double to);
/// Returns the hyperbolic arc (a cosh t, b sinh t) for t from `from` to `to`.
NurbsCurve hyperbola_arc(double a, double b, double from, double to);

}  // namespace prosector
