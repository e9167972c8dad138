// Sheets: the same three operations on triangles, and masses that are shared along edges.

#include <gtest/gtest.h>

#include <cmath>

#include "common/anatomy/sheets_and_ropes.h"
#include "server/physics/mechanics/cutting/carry.h"
#include "server/physics/mechanics/cutting/pieces.h"
#include "server/physics/mechanics/cutting/sheet_mass.h"
#include "tests/cutting/strokes.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr double density = 1000, thickness = 0.002;  // kg/m³, m

Anatomy square(double side, double cell) {
  return make_sheet({side, thickness, side}, cell);
}

cutting::TetComplex complex_of(const Anatomy& sheet, std::vector<std::uint8_t> held = {}) {
  return cutting::TetComplex::of_sheet(sheet, density, std::move(held));
}

double total_mass(const cutting::TetComplex& complex) {
  double sum = 0;
  for (const cutting::NodeId node : cutting::node_ids(complex)) sum += complex.mass(node);
  return sum;
}

double total_volume(const cutting::TetComplex& complex) {
  double sum = 0;
  for (const cutting::TetId t : cutting::tet_ids(complex)) sum += complex.volume(t);
  return sum;
}

/// A blade that stands upright in the sheet is drawn from one point to the other, in so many ticks.
Stroke drawn(const Vec3& from, const Vec3& to, int ticks) {
  Stroke out;
  for (int i = 0; i <= ticks; ++i) {
    const Vec3 at = from + (to - from) * i / ticks;
    out.push_back({at + Vec3(0, 0.03, 0.002), at - Vec3(0, 0.03, 0.002)});
  }
  return out;
}

/// What a test cuts, as the simulation does.
struct CutSheet {
  explicit CutSheet(const Anatomy& sheet) : complex(complex_of(sheet)), x(rest_positions(complex)) {}
  void make(const Stroke& stroke) {
    cutting::BladeStroke state = cutting::begin_stroke(stroke.front());
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      const cutting::CutResult result = cut_and_carry(complex, tree, x, stroke[i], state);
      ops.insert(ops.end(), result.ops.begin(), result.ops.end());
      least_angle = std::min(least_angle, result.least_dihedral_deg);
    }
  }
  cutting::TetComplex complex;
  cutting::TetTree tree;
  std::vector<Vec3> x;
  std::vector<cutting::TopologyOp> ops;
  double least_angle = 180;
};

TEST(SheetMass, OfFreeEndsIsSharedByTheWayBetween) {
  const cutting::EdgeMasses m = cutting::share_mass({2, false}, {4, false}, 0.25);
  const double node = 2.5, f = 6 / 8.5;
  EXPECT_DOUBLE_EQ(m.a, 2 * f);
  EXPECT_DOUBLE_EQ(m.b, 4 * f);
  EXPECT_DOUBLE_EQ(m.node, node * f);
  EXPECT_DOUBLE_EQ(m.a + m.b + m.node, 6);
}

TEST(SheetMass, OfAFreeEndIsHalvedWhereTheOtherIsHeld) {
  const cutting::EdgeMasses m = cutting::share_mass({2, true}, {4, false}, 0.9),
                            n = cutting::share_mass({2, false}, {4, true}, 0.9);
  EXPECT_EQ(m.a, 2);
  EXPECT_EQ(m.b, 2);
  EXPECT_EQ(m.node, 2);
  EXPECT_EQ(n.a, 1);
  EXPECT_EQ(n.b, 4);
  EXPECT_EQ(n.node, 1);
}

TEST(SheetMass, BetweenHeldEndsIsAHeldNode) {
  cutting::TetComplex complex = complex_of(square(0.1, 0.1), {1, 1, 0, 0});
  const double whole = total_mass(complex);
  complex.apply(cutting::SplitEdge{0, 1, 4, 0.5, 2, 1});
  EXPECT_TRUE(complex.is_held(4));
  EXPECT_NEAR(total_mass(complex), whole, 1e-15 * whole);
  complex.apply(cutting::SplitEdge{1, 3, 5, 0.5, 4, 1});  // one end held
  EXPECT_FALSE(complex.is_held(5));
  EXPECT_EQ(complex.mass(5), complex.mass(3));
  EXPECT_NEAR(total_mass(complex), whole, 1e-15 * whole);
}

// Nodes 0 1 / 2 3; cell 0, 2, 3, 1: triangles 0 2 3 and 0 3 1.
TEST(SheetComplex, OneCellIsCutAcrossIntoTwo) {
  CutSheet sheet(square(0.1, 0.1));
  const double mass = total_mass(sheet.complex), volume = total_volume(sheet.complex);
  EXPECT_DOUBLE_EQ(volume, 0.1 * 0.1 * thickness);
  EXPECT_DOUBLE_EQ(mass, density * volume);
  const std::uint64_t hash = cutting::content_hash(sheet.complex);
  sheet.make(drawn({0.01, 0, -0.08}, {0.01, 0, 0.08}, 1));  // along z at x = 0.01
  EXPECT_EQ(cutting::pieces(sheet.complex).size(), 2U);
  EXPECT_NEAR(total_mass(sheet.complex), mass, 1e-12 * mass);
  EXPECT_NEAR(total_volume(sheet.complex), volume, 1e-12 * volume);
  int on_cut = 0;
  for (const cutting::NodeId node : cutting::node_ids(sheet.complex))
    if (node > 3) {
      EXPECT_NEAR(sheet.complex.rest(node).x(), 0.01, 1e-3);  // the blade leans by as much at most
      ++on_cut;
    }
  EXPECT_EQ(on_cut, 6);  // on two borders and the diagonal, each on both sides
  for (std::size_t i = sheet.ops.size(); i-- > 0;) sheet.complex.take_back(sheet.ops[i]);
  EXPECT_EQ(cutting::content_hash(sheet.complex), hash);
}

TEST(SheetComplex, ANewNodeIsAndMovesAsTheEdgeDoesThere) {
  const cutting::SplitEdge op{0, 3, 4, 0.25, 2, 2};
  std::vector<Vec3> x = {{0, 0, 0}, {}, {}, {4, 8, -4}};
  cutting::carry(op, x);
  EXPECT_EQ(x[4], Vec3(1, 2, -1));
}

TEST(SheetComplex, StraightStrokesPartItWhateverTheirWay) {
  for (int i = 0; i < 24; ++i) {
    const double angle = 0.1 + i * M_PI / 24, off = 0.03 * std::sin(7.0 * i);
    const Vec3 way(std::cos(angle), 0, std::sin(angle)), side(-way.z(), 0, way.x());
    for (const int ticks : {1, 7, 60}) {
      CutSheet sheet(square(0.1, 0.01));
      const double mass = total_mass(sheet.complex);
      sheet.make(drawn(off * side - 0.11 * way, off * side + 0.11 * way, ticks));
      EXPECT_EQ(cutting::pieces(sheet.complex).size(), 2U) << "angle " << angle << ", " << ticks << " ticks";
      EXPECT_NEAR(total_mass(sheet.complex), mass, 1e-12 * mass);
      EXPECT_GE(sheet.least_angle, 4.99);
    }
  }
}

/// Bent over a cylinder's radius about z: of the flat sheet's point, so far above it.
Vec3 over_cylinder(const Vec3& flat, double above, double radius) {
  const double angle = flat.x() / radius, r = radius + above;
  return {r * std::sin(angle), r * std::cos(angle), flat.z()};
}

Anatomy bent(double radius, double cell) {
  Anatomy sheet = square(0.1, cell);
  for (Vec3& x : sheet.tets.positions) x = over_cylinder(x, 0, radius);
  return sheet;
}

void expect_in_two(const CutSheet& sheet, double mass, double volume, const std::string& which) {
  EXPECT_EQ(cutting::pieces(sheet.complex).size(), 2U) << which;
  EXPECT_NEAR(total_mass(sheet.complex), mass, 1e-12 * mass);
  EXPECT_NEAR(total_volume(sheet.complex), volume, 1e-12 * volume);
  EXPECT_GE(sheet.least_angle, 4.99);
}

// Over two fifths of a cylinder: the blade stands upright on it and goes along its axis, around it, or
// slanting, and so twists as it goes.
TEST(SheetComplex, StrokesPartASheetThatIsCurved) {
  constexpr double radius = 0.04;
  const Anatomy curved = bent(radius, 0.01);
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.07 + i * M_PI / 12, off = 0.02 * std::sin(5.0 * i);
    const Vec3 way(std::cos(angle), 0, std::sin(angle)), aside(-way.z(), 0, way.x());
    for (const int ticks : {20, 60}) {
      CutSheet sheet(curved);
      const double mass = total_mass(sheet.complex), volume = total_volume(sheet.complex);
      Stroke stroke;
      for (int tick = 0; tick <= ticks; ++tick) {
        const Vec3 at = off * aside + (0.22 * tick / ticks - 0.11) * way;
        stroke.push_back({over_cylinder(at, 0.02, radius), over_cylinder(at, -0.02, radius)});
      }
      sheet.make(stroke);
      expect_in_two(sheet, mass, volume,
                    "angle " + std::to_string(angle) + ", ticks " + std::to_string(ticks));
    }
  }
}

/// Through sheets bent one way or the other, by blades that lean, and lean otherwise as they go.
void part_curved_sheets(unsigned seed, int strokes) {
  Random random(seed);
  for (int i = 0; i < strokes; ++i) {
    const double radius = random.uniform(0.03, 0.2), angle = random.uniform(0, 2 * M_PI);
    const Vec3 way(std::cos(angle), 0, std::sin(angle)), aside(-way.z(), 0, way.x());
    const double off = random.uniform(-0.025, 0.025);
    const auto lean = [&] {
      return Vec3(random.uniform(-0.012, 0.012) * way + random.uniform(-0.012, 0.012) * aside);
    };
    const Vec3 first = lean(), last = lean();
    const int ticks = 4 + static_cast<int>(random.below(80)), points = 2 + static_cast<int>(random.below(8));
    CutSheet sheet(bent(radius, random.uniform(0.006, 0.015)));
    const double mass = total_mass(sheet.complex), volume = total_volume(sheet.complex);
    Stroke stroke;
    for (int tick = 0; tick <= ticks; ++tick) {
      const double share = static_cast<double>(tick) / ticks;
      const Vec3 at = off * aside + (0.22 * share - 0.11) * way, leaning = first + share * (last - first);
      const Vec3 upper = over_cylinder(at + leaning, 0.02, radius),
                 lower = over_cylinder(at - leaning, -0.02, radius);
      auto& edge = stroke.emplace_back();
      for (int k = 0; k < points; ++k) edge.push_back(upper + (lower - upper) * k / (points - 1));
    }
    sheet.make(stroke);
    expect_in_two(sheet, mass, volume, "stroke " + std::to_string(i));
  }
}

TEST(SheetStrokes, ThroughCurvedSheetsOfAFixedSeed) {
  part_curved_sheets(test_seed(true), 100);
}

TEST(SheetStrokes, ThroughCurvedSheetsOfAnySeed) {
  part_curved_sheets(test_seed(false), 100);
}

TEST(SheetComplex, ACutEndsInsideAndGoesOn) {
  CutSheet sheet(square(0.1, 0.01));
  const Stroke stroke = drawn({0.003, 0, -0.06}, {0.003, 0, 0.06}, 40);
  cutting::BladeStroke state = cutting::begin_stroke(stroke.front());
  std::size_t opened = 0, parted_at = 0;
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    opened += cut_and_carry(sheet.complex, sheet.tree, sheet.x, stroke[i], state).slit_faces;
    if (parted_at == 0 && cutting::pieces(sheet.complex).size() == 2) parted_at = i;
    if (i == 20) {
      EXPECT_GE(opened, 4U);  // 6 cm of cells of 1 cm
      EXPECT_EQ(cutting::pieces(sheet.complex).size(), 1U);
    }
  }
  EXPECT_GE(parted_at, 36U);
}

/// Who neighbours whom, and masses, as going through the operations afresh has them.
void expect_as_rebuilt(const CutSheet& sheet, const Anatomy& uncut) {
  cutting::TetComplex again = complex_of(uncut);
  for (const cutting::TopologyOp& op : sheet.ops) again.apply(op);
  EXPECT_EQ(cutting::content_hash(again), cutting::content_hash(sheet.complex));
  std::vector<std::vector<cutting::TetId>> star(sheet.complex.node_end());
  for (const cutting::TetId t : cutting::tet_ids(sheet.complex)) {
    const auto c = sheet.complex.corners(t);
    for (const cutting::NodeId node : c) star[node].push_back(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const cutting::TetId beyond = sheet.complex.neighbor(t, k);
      if (beyond == cutting::TetComplex::none) continue;
      ASSERT_TRUE(sheet.complex.has_tet(beyond));
      EXPECT_TRUE(cutting::has_corner(sheet.complex, beyond, c[(k + 1) % 3]));
      EXPECT_TRUE(cutting::has_corner(sheet.complex, beyond, c[(k + 2) % 3]));
    }
    const Vec3 n = (sheet.complex.rest(c[1]) - sheet.complex.rest(c[0]))
                       .cross(sheet.complex.rest(c[2]) - sheet.complex.rest(c[0]));
    EXPECT_GT(n.y(), 0) << "triangle " << t << " turned over";
  }
  for (const cutting::NodeId node : cutting::node_ids(sheet.complex)) {
    const auto is = sheet.complex.star(node);
    EXPECT_TRUE(std::equal(is.begin(), is.end(), star[node].begin(), star[node].end()));
    EXPECT_GT(sheet.complex.mass(node), 0);
  }
}

void make_random_strokes(unsigned seed) {
  Random random(seed);
  const Anatomy uncut = square(0.1, 0.02);
  CutSheet sheet(uncut);
  const double mass = total_mass(sheet.complex), volume = total_volume(sheet.complex);
  std::vector<std::pair<std::uint64_t, std::size_t>> before;  // hash, operations
  for (int i = 0; i < 400; ++i) {
    before.emplace_back(cutting::content_hash(sheet.complex), sheet.ops.size());
    const auto place = [&] { return Vec3(random.point(1).cwiseProduct(Vec3(0.07, 0.01, 0.07))); };
    const Vec3 from = place(), to = i % 10 == 0 ? Vec3(from + Vec3(1e-6, 0, 0)) : place();
    sheet.make(drawn(from, to, 1 + static_cast<int>(random.below(8))));
    for (const cutting::NodeId node : cutting::node_ids(sheet.complex))  // it moves
      sheet.x[node] =
          sheet.complex.rest(node) + Vec3(0, 3 * sheet.complex.rest(node).x() * random.uniform(0, 0.01), 0);
    ASSERT_NEAR(total_mass(sheet.complex), mass, 1e-12 * mass) << "after stroke " << i;
    ASSERT_NEAR(total_volume(sheet.complex), volume, 1e-12 * volume) << "after stroke " << i;
    if (i % 50 == 49) expect_as_rebuilt(sheet, uncut);
  }
  EXPECT_GE(sheet.least_angle, 4.99);
  EXPECT_GT(cutting::pieces(sheet.complex).size(), 10U);
  std::size_t left = sheet.ops.size();
  for (std::size_t i = before.size(); i-- > 0;) {
    while (left > before[i].second) sheet.complex.take_back(sheet.ops[--left]);
    ASSERT_EQ(cutting::content_hash(sheet.complex), before[i].first) << "stroke " << i << " taken back";
  }
}

TEST(SheetStrokes, AtRandomOfAFixedSeed) {
  make_random_strokes(test_seed(true));
}

TEST(SheetStrokes, AtRandomOfAnySeed) {
  make_random_strokes(test_seed(false));
}

}  // namespace
}  // namespace prosector
