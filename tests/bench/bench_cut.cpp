// Cost of cutting: ticks that cut and other ticks, growth of the mesh, element angles, volume, and solver
// iterations.

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "server/physics/mechanics/contact/surface_detector.h"
#include "server/physics/mechanics/cutting/cut_through.h"
#include "server/physics/mechanics/cutting/missing_nodes.h"
#include "server/physics/mechanics/cutting/tet_shape.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/mechanics/organs/organ_geometry.h"
#include "server/physics/mechanics/soft/mesh_follower.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/bench/subjects.h"
#include "tests/physics/scenes.h"

namespace prosector {
namespace {

constexpr double reach = 0.2;  // m: a stroke goes from −reach to reach along x
constexpr double nick = 0.03;  // m deep
constexpr int ticks_before = 30, ticks_after = 30, runs_through = 7;
constexpr BodyId knife = 0, liver = 1;

/// A cut right through in one tick.
struct Through {
  const char* name;
  double height;    // height of the cut, as a fraction of the organ's upper half
  bool cut_before;  // nicked before, so that the surface is already that of the tetrahedra
};
constexpr Through through[] = {
    {"through at once", 0, false}, {"through, cut before", 0, true}, {"a tip off, cut before", 0.8, true}};

struct Stroke {
  const char* name;
  double speed;                         // m/s
  std::function<double(double)> aside;  // z (m) at x (m)
};

const std::vector<Stroke>& strokes() {
  static const std::vector<Stroke> all = {
      {"straight", 0.15, [](double) { return 0.0; }},
      {"curved", 0.15, [](double x) { return 0.03 * std::sin(std::numbers::pi * x / 0.1); }},
      {"as fast as a hand", 3, [](double) { return 0.0; }}};
  return all;
}

/// Returns a scene with an attached liver without toughness, and a blade longer than the liver is high.
SceneDesc scene_of(double cell, const CutBenchOptions& options = {}) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {test::part_body("knife", "box", {0.01, 0.08, 0.01}, {-reach, 0.18, 0})};
  scene.rigid[knife].edges = {{{0, -0.04, 0}, {0, -0.28, 0}}};
  SoftDesc& soft = scene.soft.emplace_back();
  soft.name = "liver";
  soft.geometry.shape = "liver";
  soft.geometry.size = {0.24, 0.11, 0.17};
  soft.geometry.cell = cell;
  soft.geometry.surface_cell = cell;
  soft.material.toughness = 0;
  soft.attach = {{Vec3::Zero(), 1, 1e7}};
  if (!options.model.empty()) soft.configuration.model = options.model;
  if (!options.element.empty()) soft.configuration.element = options.element;
  if (!options.solver.empty()) soft.configuration.solver = options.solver;
  soft.contact.self_contact = options.self_contact;
  return scene;
}

/// Returns a scene with a membrane attached at two sides.
SceneDesc sheet_scene(const char* model, double cell) {
  SceneDesc scene = scene_of(cell);
  SoftDesc& soft = scene.soft[0];
  soft.name = "membrane";
  soft.geometry.shape = "sheet";
  soft.geometry.size = {0.2, 0.001, 0.2};
  soft.configuration.model = model;
  soft.material.youngs_modulus = 1e5;
  soft.material.damping_mass = 5;
  soft.attach = {{{0, 0, 0.15}, 0.1, 1e9}, {{0, 0, -0.15}, 0.1, 1e9}};
  return scene;
}

std::size_t cells(const Simulation& simulation) {
  std::size_t sum = tet_count(simulation);
  for (BodyId body = liver; body < simulation.body_count(); ++body) {
    const Anatomy& anatomy = simulation.soft(body).anatomy();
    if (!simulation.surface(body).triangles.empty())
      sum += 2 * anatomy.quads.size() + anatomy.triangles.size();
  }
  return sum;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// Returns the volume of the tetrahedra, m³; for sheets, mass over density.
double rest_volume(const Simulation& simulation) {
  double sum = 0;
  for (BodyId body = liver; body < simulation.body_count(); ++body) {
    if (simulation.surface(body).triangles.empty()) continue;
    const soft::SoftBody& soft = simulation.soft(body);
    const TetMesh& mesh = soft.anatomy().tets;
    if (mesh.tets.empty()) sum += soft.total_mass() / soft.desc().material.density;
    for (const auto& t : mesh.tets) {
      Mat3 edges;
      for (std::size_t k = 1; k < 4; ++k)
        edges.col(static_cast<Eigen::Index>(k) - 1) = mesh.positions[t[k]] - mesh.positions[t[0]];
      sum += edges.determinant() / 6;
    }
  }
  return sum;
}

double degrees(double cosine) {
  return 180 / std::numbers::pi * std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// Returns the smallest dihedral angle of each undeformed tetrahedron, or the smallest angle of each triangle
/// of a sheet, degrees.
std::vector<double> least_angles(const soft::SoftBody& body) {
  const Anatomy& anatomy = body.anatomy();
  const std::vector<Vec3>& x = anatomy.tets.positions;
  std::vector<double> out;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    out.push_back(degrees(cutting::cos_least_angle(x[a], x[b], x[c])));
  };
  for (const auto& t : anatomy.tets.tets)
    out.push_back(degrees(cutting::cos_least_dihedral({x[t[0]], x[t[1]], x[t[2]], x[t[3]]})));
  for (const auto& q : anatomy.quads) {
    add(q[0], q[1], q[2]);
    add(q[0], q[2], q[3]);
  }
  for (const auto& t : anatomy.triangles) add(t[0], t[1], t[2]);
  return out;
}

std::vector<double> least_angles(const Simulation& simulation) {
  std::vector<double> out;
  for (BodyId body = liver; body < simulation.body_count(); ++body) {
    if (simulation.surface(body).triangles.empty()) continue;
    const std::vector<double> of_body = least_angles(simulation.soft(body));
    out.insert(out.end(), of_body.begin(), of_body.end());
  }
  return out;
}

/// Adds angles to the row. `when`: before or after.
void add_quality(ReportRow& row, const std::string& when, const std::vector<double>& angles) {
  row["least_angle_deg_" + when] = quantile(angles, 0);
  row["p1_angle_deg_" + when] = quantile(angles, 0.01);
  row["median_angle_deg_" + when] = quantile(angles, 0.5);
}

/// Returns the solver iterations per tick, summed over all bodies.
struct Effort {
  double iterations = 0;
  std::size_t ticks = 0;
  void add(const StepReport& report) {
    ++ticks;
    for (const BodyReport& row : report.bodies) iterations += row.solver_iterations;
  }
  double mean() const { return ticks > 0 ? iterations / static_cast<double>(ticks) : 0; }
};

/// Measures the wall time of the ticks of a stroke through an organ or a sheet (triangles count as
/// tetrahedra).
ReportRow measure(const SceneDesc& scene, const Stroke& stroke, int threads) {
  CompileOptions options;
  options.threads = threads;
  Simulation simulation(scene, options);
  const std::size_t tets = cells(simulation);
  const double volume = rest_volume(simulation);
  const std::vector<double> angles = least_angles(simulation);
  Vec3 at(-reach, 0.19, 0.02);
  simulation.step(test::appear(at));
  simulation.step(test::event(HandEvent::Kind::grasp, at));
  std::vector<double> cutting, idle, cutting_phase;
  Effort while_cutting, between, after;
  const double h = 1 / simulation.scene().tick_rate;
  const int stroke_ticks = static_cast<int>(2 * reach / (stroke.speed * h));
  for (int tick = 0; tick < ticks_before + stroke_ticks + ticks_after; ++tick) {
    if (tick >= ticks_before) at.x() = std::min(reach, at.x() + stroke.speed * h);
    at.z() = 0.02 + stroke.aside(at.x());
    const StepReport& report = simulation.step(test::target(at));
    const double ms = 1e3 * report.total_seconds;
    const bool still = tick >= ticks_before + stroke_ticks;
    if (!report.topology.empty())
      while_cutting.add(report);
    else if (!cutting.empty())
      (still ? after : between).add(report);
    if (!report.topology.empty()) {
      cutting.push_back(ms);
      cutting_phase.push_back(1e3 * report.seconds[static_cast<std::size_t>(Phase::constraints)]);
    } else if (!cutting.empty()) {
      idle.push_back(ms);
    }
  }
  ReportRow row;
  const SoftDesc& tissue = scene.soft[0];
  row["stroke"] = stroke.name;
  row["tissue"] = tissue.geometry.is_sheet() ? tissue.configuration.model + " sheet" : tissue.name;
  row["model"] = tissue.configuration.model;
  row["element"] = tissue.configuration.element;
  row["solver"] = tissue.configuration.solver;
  row["self_contact"] = tissue.contact.self_contact;
  row["tets"] = tets;
  row["tets_after"] = cells(simulation);
  row["threads"] = threads;
  row["bodies_after"] = simulation.body_count() - liver;
  row["ticks_that_cut"] = cutting.size();
  row["ms_p50_cutting"] = quantile(cutting, 0.5);
  row["ms_p99_cutting"] = quantile(cutting, 0.99);
  row["ms_p50_other"] = quantile(idle, 0.5);
  row["added_ms_p50"] = quantile(cutting_phase, 0.5);
  add_quality(row, "before", angles);
  add_quality(row, "after", least_angles(simulation));
  row["volume_error"] = std::abs(rest_volume(simulation) / volume - 1);
  row["solver_iterations_cutting"] = while_cutting.mean();
  row["solver_iterations_between"] = between.mean();
  row["solver_iterations_after"] = after.mean();
  return row;
}

struct Made {
  std::unique_ptr<soft::SoftBody> solver, retired;
  Numbering numbering;
  std::optional<contact::SurfaceDetector> surface;

  void rebuild(const SoftDesc& desc, Anatomy anatomy) {
    retired = std::exchange(solver, std::make_unique<soft::SoftBody>(desc, std::move(anatomy)));
    find_surface();
  }
  void find_surface() { surface.emplace(solver->anatomy().embedding, solver->anatomy().surface); }
};

/// Updates the bodies after a topology edit, as the simulation does, or rebuilds them if `rebuilt`.
void fit_bodies(organs::Organ& organ, const SoftDesc& desc, bool rebuilt, std::vector<Made>& bodies) {
  const organs::Regrouped changed = organ.regroup(bodies.size());
  bodies.resize(std::max(bodies.size(), changed.bodies.back() + 1));
  tbb::parallel_for(std::size_t{0}, changed.bodies.size(), [&](std::size_t i) {
    Made& body = bodies[changed.bodies[i]];
    const organs::OrganPiece& piece = organ.piece(changed.bodies[i]);
    const auto edit = rebuilt ? std::nullopt : organs::edit_since(organ, changed, piece);
    if (!edit || !organs::is_worth_following(*edit) || !body.solver->follower().can_follow(edit->mesh)) {
      body.rebuild(desc, organs::anatomy_of(organ, piece, body.numbering));
    } else if (const auto surface = organs::surface_edit_since(
                   organ, changed, piece, body.solver->anatomy().surface, body.numbering)) {
      apply(*surface, body.numbering);
      body.solver->follower().follow(edit->mesh, *surface);
      body.surface->follow(*surface);
    } else {
      organs::PieceSurface skin = organs::surface_of(organ, piece);
      body.numbering = std::move(skin.numbering);
      body.solver->follower().follow(edit->mesh, std::move(skin.surface), std::move(skin.embedding));
      body.find_surface();
    }
  });
}

/// The search for missing parts of the cut after a stroke has left the tissue.
void end_stroke(const cutting::TetComplex& complex, const cutting::BladeStroke& stroke) {
  const cutting::Marks marks(stroke.marks, complex.node_end());
  cutting::missing_nodes(complex, marks, cutting::most_missing(complex, marks));
  cutting::faces_between_parts(complex, marks, cutting::least_piece_share * complex.tables().mean_volume);
}

double ms_between(std::chrono::steady_clock::time_point begin, std::chrono::steady_clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// Measures that search with half of the cut missing. Median wall time, ms.
double ms_end_of_half_a_stroke(const soft::SoftBody& body, const std::vector<Vec3>& from,
                               const std::vector<Vec3>& to) {
  organs::Organ organ(0, body.anatomy(), body.desc().material.density);
  cutting::BladeStroke blade = cutting::begin_stroke(from);
  organ.cut(body.anatomy().tets.positions, to, blade, 1, 1);
  std::vector<double> ending;
  for (int run = 0; run < runs_through; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    end_stroke(organ.complex(), blade);
    ending.push_back(ms_between(begin, std::chrono::steady_clock::now()));
  }
  return quantile(ending, 0.5);
}

/// Measures a cut right through in one tick, and its undo: preparation (normally done when the scene is
/// compiled), cutting the mesh, and updating or rebuilding the pieces' bodies. Wall times, ms.
ReportRow cut_through(const Through& way, const SceneDesc& scene, int threads) {
  CompileOptions options;
  options.threads = threads;
  const Simulation simulation(scene, options);
  const soft::SoftBody& body = simulation.soft(liver);
  Vec3 lowest = Vec3::Zero(), highest = lowest;
  for (const Vec3& at : body.anatomy().tets.positions) {
    lowest = lowest.cwiseMin(at);
    highest = highest.cwiseMax(at);
  }
  const auto edge = [](double x, double z) { return std::vector<Vec3>{{x, -reach, z}, {x, reach, z}}; };
  const double z = 1e-3 + way.height * highest.z();
  std::vector<double> preparing, cutting, making[2], all, undoing[2];  // updated, rebuilt
  std::vector<double> ending;
  std::size_t split = 0, after = 0, kept = 0;
  double mass = 0;             // kg, total of all pieces
  std::vector<double> angles;  // of all pieces, degrees
  tbb::task_arena arena(threads);
  for (int run = 0; run < 2 * runs_through; ++run) {
    const bool rebuilt = run % 2 == 1;
    const auto first = std::chrono::steady_clock::now();
    organs::Organ organ(0, body.anatomy(), body.desc().material.density);
    const auto prepared = std::chrono::steady_clock::now();
    std::vector<Made> bodies(1);
    bodies[0].rebuild(body.desc(), body.anatomy());
    cutting::BladeStroke blade;
    const auto cut_to = [&](double end, double at, std::uint64_t stroke) {
      std::vector<Vec3> x;
      for (cutting::NodeId node = 0; node < organ.complex().node_end(); ++node)
        x.push_back(organ.complex().rest(node));
      blade = cutting::begin_stroke(edge(-reach, at));
      const auto begin = std::chrono::steady_clock::now();
      split = organ.cut(x, edge(end, at), blade, 1, stroke).split_tets;
      return begin;
    };
    if (way.cut_before) {
      cut_to(lowest.x() + nick, lowest.z() / 3, 1);
      fit_bodies(organ, body.desc(), rebuilt, bodies);
    }
    arena.execute([&] {
      const auto begin = cut_to(reach, z, 2);
      const auto cut = std::chrono::steady_clock::now();
      end_stroke(organ.complex(), blade);
      const auto ended = std::chrono::steady_clock::now();
      fit_bodies(organ, body.desc(), rebuilt, bodies);
      const auto end = std::chrono::steady_clock::now();
      after = 0;
      mass = 0;
      angles.clear();
      kept = bodies[0].solver->elements();
      for (Made& piece : bodies) {
        after += piece.solver->elements();
        mass += piece.solver->total_mass();
        const std::vector<double> of_piece = least_angles(*piece.solver);
        angles.insert(angles.end(), of_piece.begin(), of_piece.end());
        piece.retired.reset();
      }
      const auto undo = std::chrono::steady_clock::now();
      static_cast<void>(organ.undo(1));
      fit_bodies(organ, body.desc(), rebuilt, bodies);
      const auto undone = std::chrono::steady_clock::now();
      making[rebuilt].push_back(ms_between(ended, end));
      undoing[rebuilt].push_back(ms_between(undo, undone));
      if (rebuilt) return;
      preparing.push_back(ms_between(first, prepared));
      cutting.push_back(ms_between(begin, cut));
      ending.push_back(ms_between(cut, ended));
      all.push_back(cutting.back() + making[rebuilt].back());
    });
  }
  ReportRow row;
  row["stroke"] = way.name;
  row["tissue"] = body.desc().name;
  row["model"] = body.desc().configuration.model;
  row["element"] = body.desc().configuration.element;
  row["solver"] = body.desc().configuration.solver;
  row["tets"] = body.elements();
  row["tets_after"] = after;
  row["tets_that_stay"] = kept;
  row["threads"] = threads;
  row["split_tets"] = split;
  row["ms_made_ready"] = quantile(preparing, 0.5);
  row["ms_cutting_mesh"] = quantile(cutting, 0.5);
  row["ms_end_of_stroke"] = quantile(ending, 0.5);
  row["ms_end_of_half_a_stroke"] = ms_end_of_half_a_stroke(body, edge(-reach, z), edge(0, z));
  row["ms_undoing"] = quantile(undoing[0], 0.5);
  row["ms_undoing_anew"] = quantile(undoing[1], 0.5);
  row["ms_making_bodies"] = quantile(making[0], 0.5);
  row["ms_making_bodies_anew"] = quantile(making[1], 0.5);
  row["added_ms_p50"] = quantile(all, 0.5);
  add_quality(row, "before", least_angles(body));
  add_quality(row, "after", angles);
  row["volume_error"] = std::abs(mass / body.total_mass() - 1);  // mass ratio equals volume ratio
  return row;
}

void add_through(Report& report, const Through& way, const SceneDesc& scene, int threads) {
  report.add(cut_through(way, scene, threads));
  const ReportRow& row = report.rows().back();
  fmt::print(
      "{:21} {:6} tets, {:6} after, {:6} unchanged: preparation {:7.2f} ms p50, mesh {:7.2f}, bodies "
      "{:7.2f} (rebuilt {:7.2f}), undo {:7.2f} (rebuilt {:7.2f}); end of a stroke "
      "{:5.2f}, of half a stroke {:5.2f}\n",
      way.name, row["tets"].get<std::size_t>(), row["tets_after"].get<std::size_t>(),
      row["tets_that_stay"].get<std::size_t>(), figure(row, "ms_made_ready"), figure(row, "ms_cutting_mesh"),
      figure(row, "ms_making_bodies"), figure(row, "ms_making_bodies_anew"), figure(row, "ms_undoing"),
      figure(row, "ms_undoing_anew"), figure(row, "ms_end_of_stroke"),
      figure(row, "ms_end_of_half_a_stroke"));
}

void add_stroke(Report& report, const SceneDesc& scene, const Stroke& stroke, int threads) {
  report.add(measure(scene, stroke, threads));
  const ReportRow& row = report.rows().back();
  fmt::print(
      "{:18} {:6} {:17}, {:6} after: {:3} cutting ticks, {:7.2f} ms p50 {:7.2f} p99, others {:6.2f}; cutting "
      "{:6.2f} ms; volume error {:.1e}\n",
      stroke.name, row["tets"].get<std::size_t>(), row["tissue"].get<std::string>(),
      row["tets_after"].get<std::size_t>(), row["ticks_that_cut"].get<std::size_t>(),
      figure(row, "ms_p50_cutting"), figure(row, "ms_p99_cutting"), figure(row, "ms_p50_other"),
      figure(row, "added_ms_p50"), figure(row, "volume_error"));
}

}  // namespace

std::vector<std::string> cut_stroke_names() {
  std::vector<std::string> names;
  for (const Through& way : through) names.emplace_back(way.name);
  for (const Stroke& stroke : strokes()) names.emplace_back(stroke.name);
  return names;
}

Report bench_cut(const CutBenchOptions& options) {
  Report report("cut");
  const auto asked = [&](const char* stroke) { return options.only.empty() || options.only == stroke; };
  const std::vector<double> cells = options.sheets     ? std::vector<double>{}
                                    : options.quick    ? std::vector<double>{0.04}
                                    : options.cell > 0 ? std::vector<double>{options.cell}
                                                       : std::vector<double>{0.01475, 0.00918, 0.00672};
  for (const double cell : cells) {
    const SceneDesc scene = scene_of(cell, options);
    for (const Stroke& stroke : strokes())
      if (asked(stroke.name)) add_stroke(report, scene, stroke, options.threads);
    for (const Through& way : through)
      if (asked(way.name)) add_through(report, way, scene, options.threads);
  }
  for (const char* model : {"mass_spring", "xpbd"})
    for (const Stroke& stroke : strokes())
      if (asked(stroke.name) && options.cell == 0)
        add_stroke(report, sheet_scene(model, options.quick ? 0.02 : 0.004), stroke, options.threads);
  return report;
}

}  // namespace prosector
