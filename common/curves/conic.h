#pragma once
// Arcs of conics as rational quadratic curves, which meet them exactly (Piegl & Tiller, The NURBS Book, 2nd
// ed. 1997, ch. 7; Farin, Curves and Surfaces for CAGD, 5th ed. 2002, ch. 12). In the x-y plane around the
// origin; at the ends, and at an arc's joints, at the angle or parameter that is asked for.

#include "common/curves/nurbs_curve.h"

namespace prosector {

/// Returns (a cos t, b sin t), from < to <= from + 2π, in arcs of at most a quarter turn.
NurbsCurve ellipse_arc(double a, double b, double from, double to);
/// Returns (a t², 2 a t), whose focus lies at x = a.
NurbsCurve parabola_arc(double a, double from, double to);
/// Returns (a cosh t, b sinh t).
NurbsCurve hyperbola_arc(double a, double b, double from, double to);

}  // namespace prosector
