#include "drivers/fitting/field_fit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

#include "common/error.h"
#include "tests/fitting/simulated_tracker.h"
#include "twins/trackers/distorted_field.h"

namespace prosector {
namespace {

/// A field that is off by `off` (m RMS) in a cube of 0.6 m, by metal beside it.
DistortedField bent_field(const Vec3& metal = {0.52, 0.1, 0.05}, const Vec3& moment = {1, 0.3, 0.2},
                          double off = 15.4e-3) {
  DistortedField field;
  field.metal = metal;
  field.moment = moment.normalized();
  field.shift = field.turn = 1;
  SimulatedTracker tracker(9);
  double squares = 0;
  constexpr int places = 20000;
  for (int i = 0; i < places; ++i) {
    const Vec3 p = tracker.inside(0.3);
    squares += (field.report({p, Quat::Identity()}).p - p).squaredNorm() / places;
  }
  field.shift = off / std::sqrt(squares);
  field.turn = 1.5 * degree / std::sqrt(squares);
  return field;
}

FieldSample sample_at(SimulatedTracker& tracker, const DistortedField& field, const Pose& truth) {
  return {tracker.read(field.report(truth)), truth};
}

std::vector<FieldSample> grid(SimulatedTracker& tracker, const DistortedField& field, int count) {
  std::vector<FieldSample> out;
  const auto at = [&](int i) { return -0.3 + 0.6 * i / (count - 1); };
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      for (int k = 0; k < count; ++k) {
        const Pose truth = {{at(i), at(j), at(k)}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))};
        out.push_back(sample_at(tracker, field, truth));
      }
  return out;
}

/// Places and orientations that nothing was fitted to, without noise: what is left is the map's own error.
std::vector<FieldSample> held_out(const DistortedField& field, int places = 2000) {
  SimulatedTracker tracker(77);
  std::vector<FieldSample> out;
  for (int i = 0; i < places; ++i) {
    const Pose truth = {tracker.inside(0.3), tracker.orientation()};
    out.push_back({field.report(truth), truth});
  }
  return out;
}

TEST(FieldFit, TakesMostOfABentField) {
  const DistortedField field = bent_field();
  const std::vector<FieldSample> judged = held_out(field);
  const PoseErrors raw = pose_errors(judged, nullptr);
  EXPECT_NEAR(raw.position, 15.4e-3, 0.5e-3);
  for (const int count : {5, 7}) {
    SimulatedTracker tracker(static_cast<unsigned>(count));
    const std::vector<FieldSample> samples = grid(tracker, field, count);
    const FieldFit fit = fit_field(samples);
    const PoseErrors left = pose_errors(judged, &fit.map);
    std::cout << fmt::format(
        "{}³ places: {:.1f} mm, {:.2f}° become {:.2f} mm, {:.2f}° (told {:.2f} mm, {:.2f}°)\n", count,
        1e3 * raw.position, raw.turn / degree, 1e3 * left.position, left.turn / degree, 1e3 * fit.after,
        fit.turn_after / degree);
    for (const FieldTrial& trial : fit.trials) {
      const FieldMap map = fit_field_form(samples, trial);
      std::cout << fmt::format("  {:<26} {:.2f} mm, told {:.2f} mm\n", trial.name(),
                               1e3 * pose_errors(judged, &map).position, 1e3 * trial.expected.position);
    }
    if (count == 7) {
      EXPECT_LE(left.position, 2.5e-3);
      EXPECT_LE(left.turn, 0.35 * raw.turn);
      EXPECT_TRUE(fit.chosen.spline);
    }
  }
}

// What is told of the map is what it leaves, whichever way metal bends the field and however fine the grid
// is.
TEST(FieldFit, TellsWhatItLeaves) {
  struct Case {
    const char* name;
    Vec3 metal, moment;
    double off;
  };
  const Case cases[] = {{"beside", {0.52, 0.1, 0.05}, {1, 0.3, 0.2}, 15.4e-3},
                        {"far", {0.9, 0.2, -0.3}, {1, 0.3, 0.2}, 15.4e-3},
                        {"below", {0, -0.5, 0}, {0.2, 1, 0}, 15.4e-3},
                        {"behind", {-0.1, 0.2, -0.6}, {0.3, 0.2, -1}, 15.4e-3},
                        {"at a corner", {0.5, 0.5, 0.45}, {0, 1, 0.5}, 15.4e-3},
                        {"weak", {0.7, 0.3, 0.2}, {1, 0.3, 0.2}, 5e-3}};
  constexpr unsigned repeats = 3;  // noise makes both errors differ from time to time
  for (const Case& c : cases)
    for (const int count : {5, 6, 7}) {
      const DistortedField field = bent_field(c.metal, c.moment, c.off);
      const std::vector<FieldSample> judged = held_out(field, 8000);
      PoseErrors left, told;
      double left_out = 0;
      for (unsigned seed = 0; seed < repeats; ++seed) {
        SimulatedTracker tracker(30 + seed);
        const FieldFit fit = fit_field(grid(tracker, field, count), {fastrak_noise, fastrak_turn_noise});
        const PoseErrors e = pose_errors(judged, &fit.map);
        left.position += e.position * e.position;
        left.turn += e.turn * e.turn;
        told.position += fit.after * fit.after;
        told.turn += fit.turn_after * fit.turn_after;
        left_out += fit.chosen.left_out * fit.chosen.left_out;
      }
      const double share = std::sqrt(told.position / left.position),
                   turn_share = std::sqrt(told.turn / left.turn);
      std::cout << fmt::format(
          "{:<12} {}³: {:.2f} mm, told {:.2f} times it, turn {:.2f} times; left out {:.1f} times\n", c.name,
          count, 1e3 * std::sqrt(left.position / repeats), share, turn_share,
          std::sqrt(left_out / left.position));
      EXPECT_GT(share, 0.7) << c.name << count;
      const double most = count == 5 ? 1.5 : 1.4;  // so few points hardly tell how bent it is between them
      EXPECT_LT(share, most) << c.name << count;
      EXPECT_GT(turn_share, 0.7) << c.name << count;
      EXPECT_LT(turn_share, most) << c.name << count;
    }
}

TEST(FieldFit, ChoosesAPolynomialWhereTheFieldIsOne) {
  SimulatedTracker tracker(3);
  std::vector<FieldSample> samples;
  for (int i = 0; i < 216; ++i) {
    const Vec3 p = tracker.inside(0.3);
    const Vec3 shift(0.2 * p.x() * p.y(), 0.1 * p.z() * p.z(), 0.1 * p.x());
    samples.push_back({{p, Quat::Identity()}, {p + shift + tracker.noise(1e-4), Quat::Identity()}});
  }
  const FieldFit fit = fit_field(samples);
  EXPECT_FALSE(fit.chosen.spline);
  EXPECT_EQ(fit.chosen.degree, 2);
}

TEST(FieldFit, WithoutDistortionNothingGetsWorseThanTheNoise) {
  SimulatedTracker tracker(5);
  const FieldFit fit = fit_field(grid(tracker, DistortedField{}, 5));
  EXPECT_EQ(fit.chosen.degree, 0) << fit.chosen.name();
  EXPECT_LT(pose_errors(held_out(DistortedField{}), &fit.map).position, 0.3e-3);
}

TEST(FieldFit, RefusesTooFewPlacesAndFlatOnes) {
  SimulatedTracker tracker(6);
  EXPECT_THROW((void)fit_field(grid(tracker, DistortedField{}, 2)), InputError);
  std::vector<FieldSample> flat = grid(tracker, DistortedField{}, 5);
  for (FieldSample& s : flat) s.reported.p.y() = 0;
  EXPECT_THROW((void)fit_field(flat), InputError);
}

TEST(FieldMap, IsReadBackAsItWasWritten) {
  SimulatedTracker tracker(7);
  const DistortedField field = bent_field();
  for (const bool spline : {false, true}) {
    const FieldMap map =
        fit_field_form(grid(tracker, field, 4), spline ? spline_form(1e-3) : polynomial_form(2));
    const FieldMap read = parse_field_map(write_field_map(map), "field.toml");
    for (int i = 0; i < 100; ++i) {
      const Pose x = {tracker.inside(0.5), tracker.orientation()};  // beyond the box, too
      const Pose a = map.apply(x), b = read.apply(x);
      EXPECT_EQ(a.p, b.p);
      EXPECT_EQ(a.q.coeffs(), b.q.coeffs());
      EXPECT_LT((a.p - x.p).norm(), 0.2) << "no correction explodes";
    }
  }
}

TEST(FieldMap, BadFilesAreRefusedByKeyAndLine) {
  SimulatedTracker tracker(8);
  const std::string good =
      write_field_map(fit_field_form(grid(tracker, DistortedField{}, 3), polynomial_form(1)));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const std::pair<std::string, const char*> cases[] = {
      {"", "version: is missing"},
      {changed("version = 1", "version = 2"), "f.toml:2: version"},
      {changed("degree = 1", "degree = 99"), "degree: must be a number from 0 to 8"},
      {changed("degree = 1", "degree = 2"), "polynomial: must have 10 rows"},
      {changed("nodes = [", "nodes = [[0, 0, 0],"), "weights: must have a row for each"},
      {changed("half = [", "half = [0,"), "half: must be three numbers"},
      {good + "more = 1\n", "more: unknown key"},
      {good + "[", "f.toml:"},
  };
  for (const auto& [text, says] : cases) {
    try {
      (void)parse_field_map(text, "f.toml");
      ADD_FAILURE() << "accepted, not: " << says;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
    }
  }
}

}  // namespace
}  // namespace prosector
