#include "tests/ledger/sessions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "server/physics/mechanics/soft/rungs.h"
#include "tests/physics/scalpel.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

using Kind = HandEvent::Kind;
using Script = std::function<TickInput(int, Simulation&)>;

Session session(const std::string& name, int ticks, std::vector<std::string> reaches,
                const SceneDesc& scene = {}) {
  Session out;
  out.name = name;
  out.ticks = ticks;
  out.reaches = std::move(reaches);
  out.scene = scene;
  return out;
}

TickInput nothing(int, Simulation&) {
  return {};
}

/// Adds another one's input to this.
TickInput together(TickInput a, const TickInput& b) {
  a.events.insert(a.events.end(), b.events.begin(), b.events.end());
  a.targets.insert(a.targets.end(), b.targets.begin(), b.targets.end());
  return a;
}

TickInput by(ParticipantId who, TickInput input) {
  for (HandEvent& e : input.events) e.participant = who;
  for (HandTarget& t : input.targets) t.participant = who;
  return input;
}

SoftDesc sheet(const std::string& name, const std::string& model, const Vec3& at) {
  SoftDesc out;
  out.name = name;
  out.geometry.shape = "sheet";
  out.configuration.model = model;
  out.geometry.size = {0.1, 0.003, 0.1};
  out.geometry.cell = out.geometry.surface_cell = 0.0125;
  out.material.youngs_modulus = 3e4;
  out.pose.p = at;
  return out;
}

/// Rigid bodies that fall on each other and on tissue that a hand presses and grasps.
Session busy() {
  Session out = session("busy", 100, {"pressed", "hold"});
  out.scene.rigid = {table(), part_body("ball", "sphere", {0.03, 0, 0}, {0.02, 0.1, 0}),
                     part_body("a", "box", {0.05, 0.05, 0.05}, {0.3, 0.1, 0}),
                     part_body("b", "box", {0.05, 0.05, 0.05}, {0.31, 0.16, 0.01})};
  out.scene.soft = {block()};
  out.input = [](int tick, Simulation&) {
    const Vec3 at(0.01, 0.12 - 0.001 * std::min(tick, 60), 0.045);
    if (tick == 0) return appear(at);
    if (tick == 70) return event(Kind::grasp, at);
    return target(at, Quat::Identity(), 0.01 * std::min(tick, 50));
  };
  return out;
}  // namespace

/// The same, handed over to another server in the middle.
Session handed_over() {
  Session out = busy();
  out.name = "handed over";
  out.handed_over = 55;
  return out;
}

/// A hand takes the scalpel and draws it through what is there at 0.1 m/s; then takes cuts back and goes
/// back.
Script cut_and_go_back(int undo_at, int save_at, int rewind_at) {
  auto saved = std::make_shared<std::vector<std::uint8_t>>();
  return [=](int tick, Simulation& simulation) {
    const Vec3 at(-0.12 + 0.0016 * std::clamp(tick - 2, 0, 150), 0.14, 0.02);
    if (tick == save_at) *saved = simulation.save();
    TickInput input = tick == 0 ? appear(at) : tick == 1 ? event(Kind::grasp, at) : target(at);
    if (tick == undo_at) input.cuts = undo().cuts;
    if (tick == rewind_at)
      input.cuts = {{CutEvent::Kind::rewind, somebody, 0, 0,
                     std::make_shared<const std::vector<std::uint8_t>>(*saved)}};
    return input;
  };
}

Session cut_block() {
  Session out = session("cut block, undo, rewind", 220, {"hold", "cut", "piece", "undo", "rewind"},
                        block_and_scalpel());
  out.scene.soft[0].material.toughness = 0;
  out.input = cut_and_go_back(170, 60, 190);
  return out;
}

/// A tough block of quadratic elements, which holds the blade back, and pieces that fall.
Session cut_quadratic() {
  Session out = session("cut quadratic block", 200, {"hold", "cut", "piece"}, block_and_scalpel());
  out.scene.gravity = {0, -9.81, 0};
  out.scene.rigid.push_back(table());
  out.scene.rigid[0].balanced = true;
  out.scene.soft[0].configuration.element = "tet10";
  out.scene.soft[0].geometry.cell = out.scene.soft[0].geometry.surface_cell = 0.03;
  out.input = cut_and_go_back(-1, -1, -1);
  return out;
}

Session cut_sheet(bool ray) {
  Session out = session(ray ? "sheet under a ray" : "cut sheet", 180,
                        {"hold", "cut", "piece", "undo", "rewind"}, membrane_and_scalpel());
  out.scene.soft[0].material.toughness = 1;
  out.scene.rigid[0].edges[0].ray = ray;
  out.input = cut_and_go_back(150, 50, 160);
  return out;
}

/// Sheets that fall on each other and on a block, minimised and position-based.
Session layers() {
  Session out = session("layers", 80, {"squeezed"});
  out.scene.rigid = {table()};
  out.scene.soft = {block(), sheet("lower", "mass_spring", {0, 0.07, 0}),
                    sheet("upper", "xpbd", {0.02, 0.085, 0.01})};
  for (SoftDesc& soft : out.scene.soft) soft.contact.self_contact = true;
  out.input = [](int tick, Simulation&) {
    const Vec3 at(0, 0.16 - 0.0012 * std::min(tick, 70), 0.03);
    return tick == 0 ? appear(at) : target(at);
  };
  return out;
}

/// Fingers that close around a box and a soft block, whose pads carry them.
Session pads() {
  Session out = session("pads", 150, {"pressed"});
  out.scene.rigid = {table(), part_body("rod", "cylinder", {0.03, 0.12, 0.03}, {0, 0.06, 0})};
  out.scene.soft = {block()};
  out.scene.soft[0].geometry.size = {0.03, 0.08, 0.03};
  out.scene.soft[0].geometry.cell = out.scene.soft[0].geometry.surface_cell = 0.01;
  out.scene.soft[0].pose.p = {0.15, 0.04, 0};
  out.input = [](int tick, Simulation&) {
    const double lift = 0.0008 * std::max(0, tick - 90), bent = std::min(1.0, 0.015 * tick);
    const auto hand = [&](double x) {
      const Vec3 at(x, 0.09 + lift, 0.08);
      return tick == 0 ? appear(at) : target(at, Quat::Identity(), bent);
    };
    return together(by(1, hand(0)), by(2, hand(0.15)));
  };
  return out;
}

/// Parts of the anatomy that people take out, press, look at and put back, by panels and without.
Session parts_and_panels() {
  Session out = session("parts and panels", 140, {"panel", "obeyed"});
  out.scene.rigid = {table(), part_body("bone", "box", {0.02, 0.1, 0.02}, {0.1, 0.1, 0})};
  out.scene.rigid[1].part = true;
  out.scene.soft = {block()};
  out.scene.soft[0].part = true;
  out.scene.soft[0].attach = {{{0, 0, 0}, 0.2, 1e7}};
  out.input = [](int tick, Simulation&) {
    const Vec3 at(0, 0.14 - 0.001 * std::min(tick, 60), 0.04);
    TickInput input = tick == 0 ? appear(at) : target(at);
    input.heads = {{somebody, {0, 0.5, 0.4}}};
    const auto panel = [&](panel::PanelEvent::Kind kind, PanelControl control, double value) {
      input.panels.push_back({kind, somebody, 2, control, value});
    };
    const auto part = [&](PartEvent::Kind kind, BodyId body, double value = 0) {
      input.parts.push_back({kind, somebody, body, {}, value});
    };
    if (tick == 10) panel(panel::PanelEvent::Kind::open, PanelControl::attach, 0);
    if (tick == 20) panel(panel::PanelEvent::Kind::set, PanelControl::stiffness, 0.8);
    if (tick == 30) panel(panel::PanelEvent::Kind::set, PanelControl::light_shaft, 1);
    if (tick == 40) part(PartEvent::Kind::detach, 1);
    if (tick == 60) part(PartEvent::Kind::detach, 2);
    if (tick == 80) part(PartEvent::Kind::attach, 2);
    if (tick == 90) part(PartEvent::Kind::hide, 1);
    if (tick == 100) part(PartEvent::Kind::inspect, 2);
    if (tick == 110) part(PartEvent::Kind::end_inspect, 2);
    if (tick == 120) part(PartEvent::Kind::show, 1);
    return input;
  };
  return out;
}

/// Two people break a bone, whose halves fall on tissue.
Session fracture() {
  Session out = session("fracture", 160, {"hold", "break", "pressed"});
  out.scene.rigid = {table(), part_body("bone", "box", {0.2, 0.02, 0.02}, {0, 0.12, 0})};
  out.scene.rigid[1].break_force = 15;
  out.scene.rigid[1].fractures = {{{0, 0.12, 0}, {1, 0, 0}}};
  out.scene.soft = {block()};
  out.input = [](int tick, Simulation&) {
    const auto hand = [&](double side) {
      const Vec3 at(side * (0.07 + 2e-4 * std::max(0, tick - 2)), 0.15, 0.045);
      return tick == 0 ? appear(at) : tick == 1 ? event(Kind::grasp, at) : target(at);
    };
    return together(by(1, hand(-1)), by(2, hand(1)));
  };
  return out;
}

/// A plate that a machine drives into tissue, and away.
Session press() {
  Session out = session("kinematic press", 120, {"pressed"});
  out.scene.rigid = {table(), part_body("plate", "box", {0.14, 0.02, 0.14}, {0, 0.08, 0})};
  out.scene.rigid[1].fixed = true;
  out.scene.soft = {block()};
  out.scene.soft[0].material.relaxation = {{0.3, 0.2}, {0.2, 1}};
  out.scene.soft[0].material.regions.push_back(
      {.center = {0, 0.03, 0}, .radius = 0.03, .youngs_modulus = 2e4});
  out.input = [](int tick, Simulation&) {
    TickInput input;
    input.kinematic_targets = {{1, {{0, 0.08 - 0.0004 * std::min(tick, 120 - tick), 0}, Quat::Identity()}}};
    return input;
  };
  return out;
}

/// Things that fall on tissue which collides as every proxy there is.
Session proxies() {
  Session out = session("proxies", 120, {"pressed"});
  out.scene.rigid = {table()};
  double x = -0.4;
  for (const Fidelity collision :
       {Fidelity::sphere, Fidelity::aabb, Fidelity::obb, Fidelity::hull, Fidelity::mesh}) {
    const std::string name(fidelity_name(collision));
    RigidDesc box = part_body("box " + name, "box", {0.03, 0.04, 0.05}, {x + 0.01, 0.12, 0.01});
    box.contact.collision = collision;
    box.pose.q = Quat(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()));
    out.scene.rigid.push_back(box);
    SoftDesc soft = block(name);
    soft.contact.collision = collision;
    soft.geometry.cell = soft.geometry.surface_cell = 0.03;
    soft.pose.p.x() = x;
    out.scene.soft.push_back(soft);
    x += 0.2;
  }
  out.input = nothing;
  return out;
}

/// Every model and method on tetrahedra under a ball each.
Session models_of_solids() {
  Session out = session("models", 80, {"pressed", "substeps", "reset"});
  out.scene.rigid = {table()};
  double x = -1, z = -0.6;
  for (const soft::ModelRow& model : soft::models()) {
    if (!model.tets) continue;
    for (const std::string& integrator : soft::integrators_for(model)) {
      SoftDesc soft = block(model.name + " " + integrator);
      soft.configuration.model = model.name;
      soft.configuration.integrator = integrator;
      soft.geometry.cell = soft.geometry.surface_cell = 0.05;
      soft.pose.p = {x, 0.03, z};
      out.scene.soft.push_back(soft);
      out.scene.rigid.push_back(part_body("ball " + soft.name, "sphere", {0.03, 0, 0}, {x + 0.01, 0.1, z}));
      x += 0.15;
      if (x > 0.9) x = -1, z += 0.15;
    }
  }
  out.input = nothing;
  return out;
}

/// Position-based tissue and cloth under balls and each other.
Session position_based() {
  Session out = session("xpbd in contact", 120, {"pressed", "squeezed", "substeps"});
  out.scene.rigid = {table(), part_body("ball", "sphere", {0.04, 0, 0}, {0.01, 0.2, 0})};
  out.scene.soft = {block(), sheet("cloth", "xpbd", {0, 0.1, 0})};
  out.scene.soft[0].configuration.model = "xpbd";
  out.scene.soft[1].contact.self_contact = true;
  out.input = nothing;
  return out;
}

/// Two people pull one organ apart, which has stepped down, and let go.
Session two_people() {
  Session out = session("two people, one organ", 150, {"shared"});
  out.scene.rigid = {table()};
  out.scene.soft = {block(), block("other")};
  out.scene.soft[0].attach = {{{0, 0, 0}, 0.03, 1e7}};
  out.scene.soft[1].pose.p = {0.13, 0.03, 0};
  out.input = [](int tick, Simulation&) {
    const auto hand = [&](double side) {
      const Vec3 at(side * (0.03 + 4e-4 * std::max(0, tick - 40)), 0.12 - 0.001 * std::min(tick, 40), 0.045);
      TickInput input = tick == 0     ? appear(at)
                        : tick == 41  ? event(Kind::grasp, at)
                        : tick == 110 ? event(Kind::release, at)
                                      : target(at);
      if (tick == 140) input.events.push_back({Kind::vanish, somebody, right_hand, 0});
      return input;
    };
    TickInput input = together(by(1, hand(-1)), by(2, hand(1)));
    if (tick == 60) input.efforts = {{1, 2}};
    if (tick == 145) input.events.push_back({Kind::reset_body, 1, right_hand, 1});
    return input;
  };
  return out;
}

/// Bodies that get into each other and are led apart, and one that is lost.
Session entangled() {
  Session out = session("entangled and lost", 150, {"squeezed"});
  out.scene.room.emplace();
  out.scene.rigid = {table(), part_body("shot", "sphere", {0.03, 0, 0}, {0, 0.5, 0.5})};
  out.scene.rigid[0].pose.p.y() = 0.95;
  for (RigidDesc& rigid : out.scene.rigid) rigid.contact.continuous = true;
  out.scene.soft = {block(), block("other")};
  out.scene.soft[0].pose.p.y() = 1.03;
  out.scene.soft[1].pose.p = {0.11, 1.03, 0};
  out.input = [](int tick, Simulation&) {
    const Vec3 at(-0.25 + 0.02 * std::min(tick, 20), 1.05, 0.045);
    if (tick == 0) return appear(at);
    TickInput input = target(at);
    if (tick == 40) input.events.push_back({Kind::vanish, somebody, right_hand, 0});
    if (tick >= 40) input.targets.clear();
    return input;
  };
  return out;
}

}  // namespace

std::set<std::string> events(const Simulation& simulation, const StepReport& report) {
  std::set<std::string> out;
  for (const TopologyChange& change : report.topology) {
    if (change.cause == TopologyCause::cut) out.insert(change.piece_of ? "piece" : "cut");
    if (change.cause == TopologyCause::undo) out.insert("undo");
    if (change.cause == TopologyCause::rewind) out.insert("rewind");
  }
  std::set<BodyId> held;
  for (const HandState& hand : simulation.hands())
    if (hand.holding) out.insert(held.insert(*hand.holding).second ? "hold" : "shared");
  if (!report.broken.empty()) out.insert("break");
  if (!simulation.panels().empty()) out.insert("panel");
  for (const Refusal& refusal : report.part_answers)
    if (!refusal) out.insert("obeyed");
  for (const BodyReport& body : report.bodies) {
    if (body.reset) out.insert("reset");
    if (body.substep > 0) out.insert("substeps");
  }
  const auto is_soft = [&](BodyId body) { return simulation.kind(body) == BodyKind::soft; };
  for (const Exchange& exchange : simulation.exchanges()) {
    if (exchange.points == 0) continue;
    if (is_soft(exchange.a) || is_soft(exchange.b)) out.insert("pressed");
    if (is_soft(exchange.a) && is_soft(exchange.b)) out.insert("squeezed");
  }
  return out;
}

std::vector<Session> sessions() {
  return {busy(),
          handed_over(),
          cut_block(),
          cut_quadratic(),
          cut_sheet(false),
          cut_sheet(true),
          layers(),
          pads(),
          parts_and_panels(),
          fracture(),
          press(),
          proxies(),
          models_of_solids(),
          position_based(),
          two_people(),
          entangled()};
}

}  // namespace prosector::test
