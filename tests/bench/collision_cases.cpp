#include "tests/bench/collision_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/calibration/stopwatch.h"
#include "server/physics/collision/self_contact.h"
#include "server/physics/simulation.h"
#include "tests/bench/memory.h"

namespace prosector {
namespace {

using namespace test;

constexpr double scene_margin = 0.002;  // m
const Vec3 organ_size(0.12, 0.07, 0.09);

double diameter(const std::vector<ShapePart>& parts) {
  const CollisionObject object = rigid(parts, Fidelity::sphere);
  return 2 * std::get<SphereShape>(object.pieces().front()).radius;
}

double median_or_nothing(std::vector<double> values) {
  return values.empty() ? std::nan("") : median(std::move(values));
}

double share(int part, int whole) {
  return whole > 0 ? static_cast<double>(part) / whole : std::nan("");
}

}  // namespace

CollisionPairs::CollisionPairs(const NamedParts& shape, int pairs)
    : name_(shape.name), table_(shape_table()), parts_(shape.parts), size_(diameter(shape.parts)) {
  Random random(1);
  CollisionObject a = rigid(parts_, Fidelity::mesh);
  std::vector<CollisionObject> others;
  std::vector<double> reach;
  for (const NamedParts& other : table_) {
    others.push_back(rigid(other.parts, Fidelity::mesh));
    reach.push_back((size_ + diameter(other.parts)) / 2);
  }
  for (int i = 0; i < pairs; ++i) {
    const std::size_t other = static_cast<std::size_t>(i) % table_.size();
    const Vec3 away = between(random, 0.2, 1) * reach[other] * random_unit(random);
    pairs_.push_back({other, {Vec3::Zero(), random_turn(random)}, {away, random_turn(random)}, std::nullopt});
    a.place(pairs_.back().a);
    others[other].place(pairs_.back().b);
    pairs_.back().truth = proximity(a, others[other], 0);
  }
}

ReportRow CollisionPairs::measure(Fidelity fidelity) const {
  constexpr std::size_t copies = 32;  // malloc hands out again what was freed: one alone would tell nothing
  const std::size_t before = allocated_bytes();
  std::vector<CollisionObject> same;
  for (std::size_t i = 0; i < copies; ++i) same.push_back(rigid(parts_, fidelity));
  const std::size_t bytes = (allocated_bytes() - before) / copies;
  CollisionObject& a = same.front();
  std::vector<CollisionObject> others;
  for (const NamedParts& other : table_) others.push_back(rigid(other.parts, fidelity));
  int hits = 0, false_hits = 0, missed = 0;
  double us = 0;
  std::vector<double> depth_errors, normal_errors;
  for (const Placed& pair : pairs_) {
    CollisionObject& b = others[pair.other];
    a.place(pair.a);
    b.place(pair.b);
    const double start = cpu_ms();
    const std::optional<Proximity> found = proximity(a, b, 0);
    us += 1e3 * (cpu_ms() - start);
    hits += pair.truth ? 1 : 0;
    false_hits += found && !pair.truth ? 1 : 0;
    missed += !found && pair.truth ? 1 : 0;
    if (!found || !pair.truth) continue;
    depth_errors.push_back(std::abs(found->gap - pair.truth->gap) / size_);
    const double cosine = std::clamp(found->normal.dot(pair.truth->normal), -1., 1.);
    normal_errors.push_back(std::acos(cosine) * 180 / std::numbers::pi);
  }
  const int count = static_cast<int>(pairs_.size());
  ReportRow row;
  row["case"] = "pairs";
  row["shape"] = name_;
  row["fidelity"] = fidelity_name(fidelity);
  row["pairs"] = count;
  row["hits"] = hits;
  row["us_per_pair"] = us / count;
  row["false_hits"] = share(false_hits, count - hits);
  row["missed_hits"] = share(missed, hits);
  row["depth_error"] = median_or_nothing(depth_errors);
  row["normal_error_deg"] = median_or_nothing(normal_errors);
  row["bytes_per_object"] = bytes;
  return row;
}

ReportRow measure_bodies(Fidelity fidelity, int bodies, int ticks) {
  Random random(2);
  const std::size_t before = allocated_bytes();
  std::vector<std::shared_ptr<const RigidOutline>> outlines;
  for (const NamedParts& shape : shape_table())
    outlines.push_back(std::make_shared<RigidOutline>(shape.parts, fidelity));
  CollisionWorld world(scene_margin);
  const double side = 0.13 * std::cbrt(bodies);  // m: most have a neighbour that they touch
  std::vector<Pose> poses;
  for (int i = 0; i < bodies; ++i) {
    world.add(CollisionObject(outlines[static_cast<std::size_t>(i) % outlines.size()]));
    poses.push_back(random_pose(random, side / 2));
  }
  std::vector<double> place, detect;
  std::size_t touches = 0, broad_pairs = 0;
  for (int tick = 0; tick < ticks + 1; ++tick) {
    const double start = cpu_ms();
    for (std::uint32_t id = 0; id < poses.size(); ++id) {
      poses[id].p += random_point(random, 0.002);
      world.place(id, poses[id]);
    }
    const double placed = cpu_ms();
    const CollisionReport& report = world.detect();
    if (tick == 0) continue;  // fills the trees
    place.push_back(placed - start);
    detect.push_back(cpu_ms() - placed);
    touches = report.touches.size();
    broad_pairs = report.broad_pairs;
  }
  ReportRow row;
  row["case"] = "bodies";
  row["fidelity"] = fidelity_name(fidelity);
  row["bodies"] = bodies;
  row["ms_place"] = median(place);
  row["ms_detect"] = median(detect);
  row["ms_scene"] = median(place) + median(detect);
  row["broad_pairs"] = broad_pairs;
  row["touches"] = touches;
  row["bytes_per_body"] = static_cast<double>(allocated_bytes() - before) / bodies;
  return row;
}

ReportRow measure_surface(int levels, int ticks) {
  const TriangleMesh mesh = organ_mesh(levels, organ_size);
  const std::size_t before = allocated_bytes();
  const double start = cpu_ms();
  CollisionObject organ(mesh, Fidelity::mesh);
  const double build = cpu_ms() - start;
  const std::size_t bytes = allocated_bytes() - before;
  const CollisionObject other(moved(mesh, {{0, 0, 0}, Quat(Eigen::AngleAxisd(1, Vec3::UnitX()))}),
                              Fidelity::mesh);

  std::vector<double> refit, apart, crossing, self;
  for (int tick = 0; tick < ticks; ++tick) {
    std::vector<Vec3> positions = mesh.positions;
    const double bend = 0.002 * tick / ticks;
    for (Vec3& x : positions) x.y() += bend * std::sin(60 * x.x());
    // Beside the other: a thousandth of the size away, then a tenth inside.
    const double reach = other.box().hi.x() - organ.box().lo.x();
    const auto at = [&](double gap) {
      std::vector<Vec3> out = positions;
      for (Vec3& x : out) x.x() += reach + gap;
      return out;
    };
    const std::vector<Vec3> beside = at(0.001 * organ_size.x()), inside = at(-0.1 * organ_size.x());
    const double t0 = cpu_ms();
    organ.move(beside);
    const double t1 = cpu_ms();
    proximity(organ, other, organ_size.x());
    const double t2 = cpu_ms();
    organ.move(inside);
    const double t3 = cpu_ms();
    proximity(organ, other, 0);
    const double t4 = cpu_ms();
    self_contacts(*organ.surface(), 1e-4, mesh.positions);
    const double t5 = cpu_ms();
    refit.push_back(t1 - t0);
    apart.push_back(t2 - t1);
    crossing.push_back(t4 - t3);
    self.push_back(t5 - t4);
    organ.move(mesh.positions);
  }
  const auto triangles = static_cast<double>(mesh.triangles.size());
  ReportRow row;
  row["case"] = "surface";
  row["fidelity"] = fidelity_name(Fidelity::mesh);
  row["triangles"] = mesh.triangles.size();
  row["ms_build"] = build;
  row["ms_refit"] = median(refit);
  row["ms_apart"] = median(apart);
  row["ms_crossing"] = median(crossing);
  row["ms_self"] = median(self);
  row["bytes_per_triangle"] = static_cast<double>(bytes) / triangles;
  return row;
}

ReportRow measure_soft_session(int bodies, int ticks) {
  SceneDesc scene;
  const int side = static_cast<int>(std::ceil(std::cbrt(bodies)));
  for (int i = 0; i < bodies; ++i) {
    SoftDesc& soft = scene.soft.emplace_back();
    soft.name = fmt::format("ball{}", i);
    soft.shape = "ball";
    soft.size = Vec3::Constant(0.05);
    soft.cell = soft.surface_cell = 0.03;
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
