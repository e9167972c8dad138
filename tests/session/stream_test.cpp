// What is sent of a deformable, and that a client which lost some of it ends up right.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

#include "server/session/run/step_meter.h"
#include "server/session/run/tick_schedule.h"
#include "server/session/run/timed_turns.h"
#include "server/session/sending/soft_sender.h"
#include "server/session/sending/surface_stream.h"
#include "tests/physics/scenes.h"

namespace prosector {
namespace {

VecX nodes_of(const Anatomy& anatomy) {
  VecX x(3 * static_cast<Eigen::Index>(anatomy.tets.positions.size()));
  for (std::size_t i = 0; i < anatomy.tets.positions.size(); ++i)
    x.segment<3>(3 * static_cast<Eigen::Index>(i)) = anatomy.tets.positions[i];
  return x;
}

/// A finer surface: every vertex of the block `copies` times over, moved inside its element's reach.
Anatomy with_fine_surface(Anatomy a, std::size_t copies) {
  const auto rows = a.embedding.rows;
  for (std::size_t c = 1; c < copies; ++c)
    for (const auto& tet : a.tets.tets) {
      SparseMap::Row row;
      row.node = tet;
      row.weight = {0.4, 0.3, 0.2, 0.1};
      a.embedding.rows.push_back(row);
      a.surface.positions.push_back(Vec3::Zero());
    }
  const VecX x = nodes_of(a);
  for (std::size_t v = 0; v < a.embedding.rows.size(); ++v)
    a.surface.positions[v] = a.embedding.apply(v, x.data());
  return a;
}

/// One coarse surface vertex per tetrahedron over many nodes.
Anatomy with_coarse_surface(Anatomy a) {
  a.embedding.rows.resize(1);
  a.embedding.rows[0].node = a.tets.tets[0];
  a.embedding.rows[0].weight = {0.25, 0.25, 0.25, 0.25};
  const VecX x = nodes_of(a);
  a.surface.positions = {a.embedding.apply(0, x.data())};
  a.surface.triangles.clear();
  return a;
}

TEST(SurfaceStream, SurfaceFollowsFromTheStreamedPointsExactly) {
  const Anatomy block = test::make_block({0.2, 0.1, 0.1}, {10, 5, 5});
  std::mt19937_64 random(1);
  std::normal_distribution<double> shift(0, 0.01);
  for (const Anatomy& anatomy : {block, with_fine_surface(block, 3), with_coarse_surface(block)}) {
    const SurfaceStream stream = make_surface_stream(anatomy, 32);
    EXPECT_LE(stream.points, anatomy.surface.positions.size());
    EXPECT_LE(stream.points, anatomy.tets.positions.size());
    VecX x = nodes_of(anatomy);
    for (double& c : x) c += shift(random);
    VecX points(3 * stream.points);
    for (std::uint32_t i = 0; i < stream.points; ++i)
      points.segment<3>(3 * i) = stream.sources.apply(i, x.data());
    ASSERT_EQ(stream.surface.map.rows.size(), anatomy.surface.positions.size());
    for (std::size_t v = 0; v < anatomy.surface.positions.size(); ++v)
      EXPECT_LT((stream.surface.map.apply(v, points.data()) - anatomy.embedding.apply(v, x.data())).norm(),
                1e-12);
  }
}

// Nodes come and go under a surface that stays: what travels is the same, wherever it hangs.
TEST(SurfaceStream, OfVerticesGoesOnWhenTheyHangOnOtherNodes) {
  const Anatomy block = with_fine_surface(test::make_block({0.2, 0.1, 0.1}, {10, 5, 5}), 3);
  const SurfaceStream stream = make_surface_stream(block, 32, Streamed::vertices);
  ASSERT_EQ(stream.points, block.surface.positions.size());
  EXPECT_FALSE(stream.of_nodes);
  const VecX x = nodes_of(block);
  SparseMap other;  // each vertex a node of its own
  VecX nodes(3 * stream.points);
  for (std::uint32_t v = 0; v < stream.points; ++v) {
    other.rows.push_back({{v}, {1}});
    nodes.segment<3>(3 * Eigen::Index{v}) = block.embedding.apply(v, x.data());
  }
  const SparseMap sources = sources_of(stream, other);
  for (std::uint32_t i = 0; i < stream.points; ++i)
    EXPECT_EQ(sources.apply(i, nodes.data()), stream.sources.apply(i, x.data()));
}

TEST(SurfaceStream, ChunksAreCompact) {
  const Anatomy block = test::make_block({0.2, 0.2, 0.2}, {16, 16, 16});
  const SurfaceStream stream = make_surface_stream(block, 64);
  const VecX x = nodes_of(block);
  double mean_diagonal = 0;
  for (std::uint32_t c = 0; c < stream.chunks(); ++c) {
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = c * 64; i < std::min(stream.points, (c + 1) * 64); ++i)
      box.extend(stream.sources.apply(i, x.data()));
    mean_diagonal += box.diagonal().norm() / stream.chunks();
  }
  EXPECT_LT(mean_diagonal, 0.6 * 0.2 * std::sqrt(3.0));
}

/// A block whose one end swings, as the sender sees it.
struct Swing {
  Anatomy anatomy = test::make_block({0.2, 0.1, 0.1}, {20, 10, 10});
  std::shared_ptr<const SurfaceStream> shared =
      std::make_shared<const SurfaceStream>(make_surface_stream(anatomy, 64));
  const SurfaceStream& stream = *shared;
  SoftSender sender{0, 60};
  VecX rest = nodes_of(anatomy);
  std::uint64_t tick = 0;

  std::vector<Message> step(double amplitude, bool asleep = false, bool everything = false) {
    auto x = std::make_shared<VecX>(rest);
    for (Eigen::Index i = 0; i < x->size(); i += 3)
      if ((*x)[i] > 0.05) (*x)[i + 1] += amplitude * ((*x)[i] - 0.05);
    std::vector<Message> out;
    sender.update({0, asleep, 0, x, std::make_shared<VecX>(VecX::Zero(x->size())), shared}, {0, ++tick},
                  everything, out);
    return out;
  }
};

TEST(SoftSender, SendsOnlyWhatMovedAndRefreshesTheRest) {
  Swing swing;
  EXPECT_EQ(swing.step(0).size(), swing.stream.chunks());  // nobody has anything yet
  const std::size_t moving = swing.step(0.1).size();
  EXPECT_GT(moving, 0u);
  EXPECT_LT(moving, swing.stream.chunks());
  EXPECT_EQ(swing.step(0.1, false, true).size(), swing.stream.chunks());
  std::vector<int> seen(swing.stream.chunks());
  for (std::uint64_t t = 0; t < soft_refresh_ticks; ++t)
    for (const Message& m : swing.step(0.1)) ++seen[std::get<SoftState>(m).chunk];
  for (int count : seen) EXPECT_GE(count, 1);
}

TEST(SoftSender, SettledIsSaidOnceWholeAndAgainAfterAReset) {
  Swing swing;
  swing.step(0.1);
  auto out = swing.step(0.1, true);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(std::get<Settled>(out[0]).positions.size(), swing.stream.points);
  EXPECT_TRUE(swing.step(0.1, true).empty());
  EXPECT_EQ(swing.step(0, true).size(), 1u);  // put back while asleep
}

TEST(SoftSender, WhatIsHeldBackStaysBelowTheThreshold) {
  Swing swing;
  std::vector<Vec3> client(swing.stream.points);
  double worst = 0;
  for (int t = 0; t < 200; ++t) {
    const double amplitude = 0.05 * std::sin(0.02 * t);
    for (const Message& m : swing.step(amplitude)) {
      const auto& s = std::get<SoftState>(m);
      for (std::uint32_t i = 0; i < s.positions.size(); ++i)
        client[s.first_point + i] = swing.stream.surface.rest[s.first_point + i] + s.positions[i];
    }
    for (std::uint32_t i = 0; i < swing.stream.points; ++i) {
      Vec3 x = swing.stream.sources.apply(i, swing.rest.data());
      if (x.x() > 0.05) x.y() += amplitude * (x.x() - 0.05);
      worst = std::max(worst, (x - client[i]).norm());
    }
  }
  EXPECT_LE(worst, soft_send_threshold);
}

TEST(TickSchedule, CatchesUpOneTickAndSlipsBeyond) {
  TickSchedule schedule(100, 0);  // 10 ms
  const std::int64_t ms = 1'000'000;
  schedule.finished(3 * ms);
  EXPECT_EQ(schedule.due_ns(), 10 * ms);
  schedule.finished(28 * ms);  // 8 ms late: caught up
  EXPECT_EQ(schedule.due_ns(), 20 * ms);
  EXPECT_EQ(schedule.slips(), 0u);
  schedule.finished(100 * ms);  // far too late: time slows
  EXPECT_EQ(schedule.due_ns(), 90 * ms);
  EXPECT_EQ(schedule.slips(), 1u);
  EXPECT_EQ(schedule.slipped_ns(), 60 * ms);
}

TEST(TimedTurns, GoAtTheRateAndThePaceUntilToldToStop) {
  const auto turns_at = [](double pace) {
    int turns = 0, seconds = 0;
    const std::atomic<bool> stop{false};
    take({.tick_rate = 200,
          .seconds = 0.2,
          .turn = [&] { ++turns; },
          .pace = [=] { return pace; },
          .each_second = [&] { ++seconds; }},
         stop);
    EXPECT_EQ(seconds, 0);
    return turns;
  };
  EXPECT_LE(turns_at(1), 41);
  EXPECT_LE(turns_at(0), 41) << "as often as it would run";
  EXPECT_LE(turns_at(0.25), 11);
  EXPECT_GE(turns_at(0.25), 2);
  int turns = 0;
  std::atomic<bool> stop{false};
  take({.tick_rate = 1000,
        .turn = [&] { stop = ++turns == 7; },
        .pace = [] { return 1.0; },
        .each_second = [] {}},
       stop);
  EXPECT_EQ(turns, 7);
}

TEST(TimedTurns, TellOfEachSecondOnceAlsoAfterALongTurn) {
  const std::atomic<bool> stop{false};
  int turns = 0, reports = 0;
  take({.tick_rate = 10,
        .seconds = 2.15,
        .turn =
            [&] {
              if (++turns == 1) std::this_thread::sleep_for(std::chrono::milliseconds(2100));
            },
        .pace = [] { return 1.0; },
        .each_second = [&] { ++reports; }},
       stop);
  EXPECT_EQ(reports, 1) << "one line after a turn of two seconds";
}

TEST(StepMeter, SaysWhatIsSlowAndWhoIsDegraded) {
  StepMeter meter(100);
  StepReport report;
  report.bodies = {{.body = "liver",
                    .newton_iterations = 3,
                    .solver_iterations = 60,
                    .residual = 0.5,
                    .converged = false,
                    .note = {}},
                   {.body = "kidney",
                    .newton_iterations = 1,
                    .solver_iterations = 1,
                    .residual = 0.1,
                    .reset = true,
                    .note = {}}};
  std::int64_t now = 0;
  for (int i = 0; i < 100; ++i, now += 20'000'000) meter.add(report, i >= 50, now, now + 15'000'000);
  const LastSecond last = meter.last_second();
  EXPECT_NEAR(last.real_time_factor, 0.5, 1e-9);
  EXPECT_NEAR(last.step_ms_p50, 15, 1e-9);
  EXPECT_EQ(meter.late(), 100u);
  EXPECT_EQ(meter.awake().count(), 50u);
  EXPECT_EQ(last.solver_residual, 0.5);
  EXPECT_NE(last.degraded.find("liver not converged"), std::string::npos);
  EXPECT_NE(last.degraded.find("kidney reset"), std::string::npos);
  EXPECT_NEAR(meter.all().quantile(0.5), 15, 0.15);
}

TEST(DurationHistogram, QuantilesAreWithinOnePercent) {
  DurationHistogram histogram;
  std::vector<double> values;
  std::mt19937_64 random(2);
  std::lognormal_distribution<double> duration(1, 1);
  for (int i = 0; i < 20000; ++i) histogram.add(values.emplace_back(duration(random)));
  std::sort(values.begin(), values.end());
  for (double q : {0.01, 0.5, 0.9, 0.99}) {
    const double exact = values[static_cast<std::size_t>(std::ceil(q * 20000)) - 1];
    EXPECT_NEAR(histogram.quantile(q) / exact, 1, 0.01);
  }
}

}  // namespace
}  // namespace prosector
