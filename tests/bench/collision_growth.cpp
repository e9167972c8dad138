// Scaling of soft-body collision detection with size and number of bodies.

#include <fmt/format.h>

#include <cmath>

#include "common/anatomy/sheets_and_ropes.h"
#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/contact/layers.h"
#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/mechanics/contact/self_collision.h"
#include "server/physics/mechanics/contact/soft_meeting.h"
#include "server/physics/simulation.h"
#include "tests/bench/collision_cases.h"
#include "tests/bench/memory.h"

namespace prosector {
namespace {

using namespace test;

const Vec3 organ_size(0.12, 0.07, 0.09);

/// Returns an anatomy whose nodes are the vertices of its surface.
Anatomy carried_by_itself(const TriangleMesh& mesh) {
  Anatomy out;
  out.tets.positions = mesh.positions;
  out.surface = mesh;
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) out.embedding.rows.push_back({{i}, {1}});
  return out;
}

VecX flat(const std::vector<Vec3>& positions) {
  VecX out(static_cast<Eigen::Index>(3 * positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
    out.segment<3>(static_cast<Eigen::Index>(3 * i)) = positions[i];
  return out;
}

/// A solid's surface as in TissueSurface: vertices and faces for collision detection.
struct Solid {
  explicit Solid(const Anatomy& anatomy)
      : vertices(anatomy.embedding, anatomy.surface),
        faces(anatomy.surface),
        cell(contact::mean_edge(anatomy.surface)) {
    move(flat(anatomy.tets.positions));
  }
  void move(const VecX& x) {
    vertices.update(x.data());
    faces.move(vertices.positions());
  }
  contact::SoftSkin skin() const { return {&vertices, &faces, 0, cell}; }

  contact::SurfaceDetector vertices;
  collision::TriangleSurface faces;
  double cell;  // m
};

/// Finds the contacts that add_vertex_contacts() would find.
void meet(const Solid& a, const Solid& b, std::vector<contact::VertexMeeting>& out) {
  out.clear();
  contact::find_meetings(a.skin(), b.skin(), contact::contact_margin, out);
  contact::find_meetings(b.skin(), a.skin(), contact::contact_margin, out);
}

}  // namespace

ReportRow measure_surface(int levels, int ticks) {
  const Anatomy anatomy = carried_by_itself(organ_mesh(levels, organ_size));
  const std::vector<Vec3>& rest = anatomy.surface.positions;
  const Anatomy other_anatomy =
      carried_by_itself(moved(anatomy.surface, {Vec3::Zero(), Quat(Eigen::AngleAxisd(1, Vec3::UnitX()))}));
  const std::size_t before = allocated_bytes();
  const double start = cpu_ms();
  Solid solid(anatomy);
  const double build = cpu_ms() - start;
  const std::size_t bytes = allocated_bytes() - before;
  const Solid other(other_anatomy);
  contact::SelfCollision itself(anatomy, solid.cell);

  std::vector<contact::VertexMeeting> found;
  std::vector<double> refit, apart, crossing, self;
  const double list_start = cpu_ms();
  itself.find(solid.skin(), contact::contact_margin, found);
  const double list = cpu_ms() - list_start;
  for (int tick = 0; tick < ticks; ++tick) {
    std::vector<Vec3> positions = rest;
    const double bend = 0.002 * tick / ticks;
    for (Vec3& x : positions) x.y() += bend * std::sin(60 * x.x());
    solid.move(flat(positions));
    const double t0 = cpu_ms();
    found.clear();
    itself.find(solid.skin(), contact::contact_margin, found);
    const double t1 = cpu_ms();
    // Beside the other surface: separated by 0.1 % of the size, then overlapping by 10 %.
    const double reach = other.faces.box().hi.x() - solid.faces.box().lo.x();
    const auto at = [&](double gap) {
      std::vector<Vec3> out = positions;
      for (Vec3& x : out) x.x() += reach + gap;
      return flat(out);
    };
    const VecX beside = at(0.001 * organ_size.x()), inside = at(-0.1 * organ_size.x());
    const double t2 = cpu_ms();
    solid.move(beside);
    const double t3 = cpu_ms();
    meet(solid, other, found);
    const double t4 = cpu_ms();
    solid.move(inside);
    const double t5 = cpu_ms();
    meet(solid, other, found);
    const double t6 = cpu_ms();
    self.push_back(t1 - t0);
    refit.push_back(t3 - t2);
    apart.push_back(t4 - t3);
    crossing.push_back(t6 - t5);
  }
  const auto triangles = static_cast<double>(anatomy.surface.triangles.size());
  ReportRow row;
  row["case"] = "surface";
  row["fidelity"] = fidelity_name(Fidelity::mesh);
  row["triangles"] = anatomy.surface.triangles.size();
  row["ms_build"] = build;
  row["ms_refit"] = median(refit);
  row["ms_apart"] = median(apart);
  row["ms_crossing"] = median(crossing);
  row["ms_list"] = list;
  row["ms_self"] = median(self);
  row["bytes_per_triangle"] = static_cast<double>(bytes) / triangles;
  return row;
}

ReportRow measure_layers(int cells, int ticks) {
  const Vec3 size(0.2, 0.002, 0.2);
  const Anatomy anatomy = make_sheet(size, size.x() / cells);
  contact::ElementSurface lower(anatomy), upper(anatomy);
  lower.move(flat(anatomy.tets.positions));
  contact::LayerSearch search;
  search.thickness = size.y();
  search.margin = contact::contact_margin;
  std::vector<contact::LayerSide> sides;
  std::vector<contact::LayerMeeting> meetings;
  std::vector<double> refit, find;
  for (int tick = 0; tick < ticks; ++tick) {
    std::vector<Vec3> positions = anatomy.tets.positions;
    for (Vec3& x : positions)
      x += Vec3(0.003, 1.5 * size.y() + 5e-4 * std::sin(60 * x.x() + 0.1 * tick), 0.002);
    const VecX now = flat(positions);
    const double start = cpu_ms();
    upper.move(now);
    const double placed = cpu_ms();
    meetings.clear();
    contact::find_layers(upper, lower, search, sides, meetings);
    find.push_back(cpu_ms() - placed);
    refit.push_back(placed - start);
  }
  ReportRow row;
  row["case"] = "layers";
  row["fidelity"] = fidelity_name(Fidelity::mesh);
  row["cells"] = cells * cells;
  row["ms_refit"] = median(refit);
  row["ms_layers"] = median(find);
  row["meetings"] = meetings.size();
  return row;
}

ReportRow measure_soft_session(int bodies, int ticks) {
  SceneDesc scene;
  const int side = static_cast<int>(std::ceil(std::cbrt(bodies)));
  for (int i = 0; i < bodies; ++i) {
    SoftDesc& soft = scene.soft.emplace_back();
    soft.name = fmt::format("ball{}", i);
    soft.geometry.shape = "ball";
    soft.geometry.size = Vec3::Constant(0.05);
    soft.geometry.cell = soft.geometry.surface_cell = 0.03;
    soft.pose.p = 0.1 * Vec3(i % side, i / side % side, i / side / side);
  }
  CompileOptions options;
  options.threads = 1;
  Simulation simulation(scene, options);
  std::vector<double> narrow;
  for (int tick = 0; tick < ticks + 1; ++tick) {
    const StepReport& report = simulation.step({});
    if (tick > 0) narrow.push_back(1e3 * report.seconds[static_cast<std::size_t>(Phase::narrow)]);
  }
  ReportRow row;
  row["case"] = "soft_session";
  row["fidelity"] = fidelity_name(Fidelity::mesh);
  row["bodies"] = bodies;
  row["all_pairs"] = bodies * (bodies - 1) / 2;
  row["ms_narrow"] = median(narrow);
  return row;
}

}  // namespace prosector
