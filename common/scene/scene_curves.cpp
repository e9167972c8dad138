#include "common/scene/scene_curves.h"

#include <fmt/format.h>

#include "common/curves/conic.h"
#include "common/curves/patch_mesh.h"
#include "common/curves/tube.h"
#include "common/error.h"

namespace prosector {
namespace {

NurbsCurve unplaced_curve(const CurveDesc& desc) {
  if (desc.kind == "bezier") return NurbsCurve::bezier(desc.points, desc.weights);
  if (desc.kind == "ellipse") return ellipse_arc(desc.a, desc.b, desc.from, desc.to);
  if (desc.kind == "parabola") return parabola_arc(desc.a, desc.from, desc.to);
  if (desc.kind == "hyperbola") return hyperbola_arc(desc.a, desc.b, desc.from, desc.to);
  if (desc.kind != "bspline")
    throw InputError(fmt::format(
        "unknown kind of curve '{}'; allowed: bezier, bspline, ellipse, parabola, hyperbola", desc.kind));
  if (desc.points.size() < static_cast<std::size_t>(desc.degree) + 1)
    check_knots({}, desc.points.size(), desc.degree);
  return {desc.degree, desc.knots.empty() ? clamped_knots(desc.points.size(), desc.degree) : desc.knots,
          desc.points, desc.weights};
}

/// Returns the degree and knots of a patch along u or v, with `count` control points in that direction.
NurbsSurface::Direction direction_of(const PatchDesc& desc, int degree, const std::vector<double>& knots,
                                     std::size_t count, char name) {
  if (desc.kind == "bezier") {
    if (count < 2 || count > max_degree + 1)
      throw InputError(fmt::format("a bezier patch has {} points along {}: it must have 2 to {}", count, name,
                                   max_degree + 1));
    degree = static_cast<int>(count) - 1;
    return {degree, bezier_knots(degree)};
  }
  const bool enough = count > static_cast<std::size_t>(degree);
  return {degree, knots.empty() && enough ? clamped_knots(count, degree) : knots};
}

/// A patch transformed by a pose.
class PlacedPatch final : public Patch {
 public:
  PlacedPatch(std::unique_ptr<Patch> patch, const Pose& pose) : patch_(std::move(patch)), pose_(pose) {}

  PatchPoint evaluate(double u, double v) const override {
    const PatchPoint p = patch_->evaluate(u, v);
    return {pose_ * p.x, pose_.q * p.u, pose_.q * p.v};
  }
  std::array<std::vector<double>, 2> seams() const override { return patch_->seams(); }

 private:
  std::unique_ptr<Patch> patch_;
  Pose pose_;
};

std::unique_ptr<Patch> make_coons(const PatchDesc& desc) {
  if (desc.sides.size() != 4)
    throw InputError(fmt::format("{} sides: a Coons patch has 4", desc.sides.size()));
  const auto side = [&](std::size_t k) {
    try {
      return make_curve(desc.sides[k]);
    } catch (const InputError& error) {
      throw InputError(fmt::format("side {}: {}", k + 1, error.what()));
    }
  };
  return std::make_unique<CoonsPatch>(std::array<NurbsCurve, 4>{side(0), side(1), side(2), side(3)});
}

std::unique_ptr<Patch> unplaced_patch(const PatchDesc& desc) {
  if (desc.kind == "coons") return make_coons(desc);
  if (desc.kind == "revolved") {
    if (desc.sides.size() != 1)
      throw InputError(fmt::format("a revolved patch has {} sides: it must have 1, which is rotated about y",
                                   desc.sides.size()));
    return std::make_unique<RevolvedPatch>(make_curve(desc.sides.front()));
  }
  const auto columns = static_cast<std::size_t>(std::max(desc.columns, 1));
  const std::size_t rows = desc.points.size() / columns;
  return std::make_unique<NurbsSurface>(direction_of(desc, desc.degree_u, desc.knots_u, columns, 'u'),
                                        direction_of(desc, desc.degree_v, desc.knots_v, rows, 'v'), columns,
                                        desc.points, desc.weights);
}

}  // namespace

NurbsCurve make_curve(const CurveDesc& desc) {
  return unplaced_curve(desc).moved(desc.pose);
}

std::unique_ptr<Patch> make_patch(const PatchDesc& desc) {
  return std::make_unique<PlacedPatch>(unplaced_patch(desc), desc.pose);
}

TriangleMesh mesh_of(std::span<const CurveDesc> curves, std::span<const PatchDesc> patches) {
  TriangleMesh all;
  for (const CurveDesc& curve : curves)
    append(all, tube_around(make_curve(curve), curve.diameter, curve.tolerance));
  for (const PatchDesc& patch : patches)
    append(all, slab_mesh(*make_patch(patch), patch.thickness, patch.tolerance));
  return all;
}

}  // namespace prosector
