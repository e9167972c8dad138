// From a scene to its choices: what is measured, kept, measured again, and put into the description.

#include "server/calibration/choose_scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "common/anatomy/kuhn_box.h"
#include "common/error.h"
#include "server/calibration/table_file.h"
#include "tests/calibration/tables.h"

namespace prosector {
namespace {

struct Chooser {
  std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("rungs." + std::to_string(getpid()) + ".json");
  std::string machine = "a machine";
  int measured = 0;
  double share = 1;  // of the processor, while measuring
  bool on_the_body = false;
  std::function<void(RungFigures&, const RungTrial&)> on_measure = [](RungFigures&, const RungTrial&) {};
  std::vector<std::string> log;

  ~Chooser() { std::filesystem::remove(file); }

  static SceneDesc scene() {
    SceneDesc scene;
    scene.name = "choice";
    SoftDesc plain, needs;
    plain.name = "plain";
    needs.name = "liver";
    needs.choice.accuracy.value = 2;
    scene.soft = {plain, needs};
    return scene;
  }
  std::vector<Choice> choose(SceneDesc& scene) {
    log.clear();
    measured = 0;
    ChoiceOptions options{.table_file = file,
                          .machine = machine,
                          .measure =
                              [this](const RungTrial& trial) {
                                ++measured;
                                RungFigures figures = test::made_up(trial);
                                figures.share = share;
                                on_measure(figures, trial);
                                return figures;
                              },
                          .on_the_body = on_the_body,
                          .sources = {}};
    options.sources.progress = [this](const std::string& line) { log.push_back(line); };
    options.sources.anatomy = [](const SoftDesc& desc) {
      const auto across = static_cast<std::uint32_t>(std::max(1.0, std::round(0.1 / desc.geometry.cell)));
      return Anatomy{kuhn_box({0.4, 0.1, 0.1}, 4 * across, across, across), {}, {}};
    };
    return choose_rungs(scene, options);
  }
  bool said(const std::string& what) const {
    for (const std::string& line : log)
      if (line.find(what) != std::string::npos) return true;
    return false;
  }
};

TEST(ChooseScene, MeasuresOnceAndKeepsTheTable) {
  Chooser chooser;
  SceneDesc scene = Chooser::scene();
  const auto first = chooser.choose(scene);
  EXPECT_GT(chooser.measured, 20);
  EXPECT_TRUE(chooser.said("measuring"));
  EXPECT_TRUE(chooser.said("liver: accuracy 2 % requested, chosen configuration: ")) << chooser.log.back();
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(scene.soft[0].geometry.cell, SoftDesc{}.geometry.cell) << "nothing was asked for this one";
  EXPECT_EQ(scene.soft[1].geometry.cell, first[0].cell);
  EXPECT_EQ(scene.soft[1].configuration.element, first[0].rung.element);

  SceneDesc again = Chooser::scene();
  const auto second = chooser.choose(again);
  EXPECT_EQ(chooser.measured, 0);
  EXPECT_EQ(encode(second), encode(first));
}

TEST(ChooseScene, WhatWasMeasuredUnderLoadIsSaidAndMeasuredAgain) {
  Chooser chooser;
  chooser.share = 0.6;
  SceneDesc scene = Chooser::scene();
  EXPECT_EQ(chooser.choose(scene).size(), 1u) << "it serves this once";
  EXPECT_TRUE(chooser.said("measured while other programs used the processor"));
  const int all = chooser.measured;
  chooser.share = 1;
  scene = Chooser::scene();
  chooser.choose(scene);
  EXPECT_EQ(chooser.measured, all);
  EXPECT_FALSE(chooser.said("other programs"));
  scene = Chooser::scene();
  chooser.choose(scene);
  EXPECT_EQ(chooser.measured, 0);
}

TEST(ChooseScene, MeasuresWhatIsMissingOnly) {
  Chooser chooser;
  SceneDesc scene = Chooser::scene();
  chooser.choose(scene);
  scene = Chooser::scene();
  scene.soft[1].choice.fixed.solver = true;
  scene.soft[1].configuration.solver = "direct";
  chooser.choose(scene);
  EXPECT_GT(chooser.measured, 0);
  EXPECT_EQ(scene.soft[1].configuration.solver, "direct");
}

TEST(ChooseScene, ForeignAndDamagedTablesAreMeasuredAgainAndSaid) {
  Chooser chooser;
  SceneDesc scene = Chooser::scene();
  chooser.choose(scene);
  chooser.machine = "another machine";
  scene = Chooser::scene();
  chooser.choose(scene);
  EXPECT_GT(chooser.measured, 0);
  EXPECT_TRUE(chooser.said("another machine or by another build"));

  std::string text;
  std::getline(std::ifstream(chooser.file), text, '\0');
  const std::string spoiled[] = {"", "{", text.substr(0, text.size() / 2), "[1, 2]",
                                 text.substr(0, text.rfind("\"ms_per_frame\"")) + "\"ms_per_frame\": -3}]}"};
  for (const std::string& bad : spoiled) {
    std::ofstream(chooser.file) << bad;
    scene = Chooser::scene();
    chooser.choose(scene);
    EXPECT_GT(chooser.measured, 0);
    EXPECT_TRUE(chooser.said("is damaged")) << bad.substr(0, 40);
  }
}

/// A figure with one bit changed may be a figure still.
TEST(ChooseScene, AFlippedBitOfATableGivesTheSameTableOrNone) {
  Chooser chooser;
  SceneDesc scene = Chooser::scene();
  chooser.choose(scene);
  std::string whole;
  std::getline(std::ifstream(chooser.file), whole, '\0');
  const auto rows = read_table(chooser.file, chooser.machine).table.rows();
  const auto figures = [](const RungTable::Row& row) {
    const RungFigures& f = row.figures;
    return std::array{f.elements, f.settled_sag, f.drift, f.iterations, f.ms};
  };
  std::mt19937_64 random(3);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string flipped = whole;
    const std::size_t at = random() % flipped.size();
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << random() % 8));
    std::ofstream(chooser.file) << flipped;
    const FoundTable found = read_table(chooser.file, chooser.machine);
    refused += !found.error.empty();
    const bool same = std::ranges::equal(found.table.rows(), rows, {}, figures, figures);
    EXPECT_TRUE(same || !found.error.empty()) << "byte " << at;
  }
  EXPECT_GT(refused, 200);  // the others are in white space
}

/// Two servers that measure at once keep what both found.
TEST(ChooseScene, KeepsWhatAnotherWroteMeanwhile) {
  Chooser one;
  RungTable elsewhere;
  RungTrial trial;
  trial.rung = {.model = "fem_linear", .integrator = "implicit_euler", .solver = "direct"};
  trial.poisson_ratio = 0.3;
  elsewhere.add(trial, {10, 0.1, 0, 1, 1, 1});
  one.on_measure = [&](RungFigures&, const RungTrial&) {
    EXPECT_TRUE(write_table(one.file, one.machine, elsewhere));
  };
  SceneDesc scene = Chooser::scene();
  one.choose(scene);
  const FoundTable found = read_table(one.file, one.machine);
  EXPECT_TRUE(found.table.find(trial));
  EXPECT_GT(found.table.rows().size(), 1u);
}

TEST(ChooseScene, ATableThatCannotBeKeptIsNoError) {
  Chooser chooser;
  chooser.file = "/proc/no/such/rungs.json";
  SceneDesc scene = Chooser::scene();
  EXPECT_EQ(chooser.choose(scene).size(), 1u);
  EXPECT_TRUE(chooser.said("cannot be written"));
}

TEST(ChooseScene, NothingAskedForMeasuresNothing) {
  Chooser chooser;
  SceneDesc scene = Chooser::scene();
  scene.soft.pop_back();
  EXPECT_TRUE(chooser.choose(scene).empty());
  EXPECT_EQ(chooser.measured, 0);
}

/// What is expected is of the mesh that the body really gets.
TEST(ChooseScene, ExpectsWhatTheMeshHolds) {
  Chooser chooser;
  SceneDesc scene = Chooser::scene();
  const Choice choice = chooser.choose(scene).front();
  const auto across = std::round(0.1 / choice.cell);
  BodyGeometry body = geometry_of(kuhn_box({0.4, 0.1, 0.1}, 8, 2, 2));
  body.elements = 24 * across * across * across;
  const auto right = test::made_up_table(scene.soft[1]).prospect(choice.rung, 0.45, body, false);
  EXPECT_NEAR(choice.expected.ms / right->ms, 1, 0.35) << "cells come in whole numbers";
}

/// What is chosen was tried on the body itself, and is expected to be what that told.
TEST(ChooseScene, JudgesOnTheBodyItself) {
  Chooser chooser;
  chooser.on_the_body = true;
  SceneDesc scene = Chooser::scene();
  scene.soft[1].choice.accuracy.value = 40;
  scene.soft[1].choice.accuracy_of = {"shape"};
  const Choice choice = chooser.choose(scene).front();
  ASSERT_FALSE(choice.acts.empty());
  EXPECT_TRUE(choice.good_enough);
  EXPECT_LE(choice.expected.error, 0.4);
  EXPECT_GE(choice.expected.error, worst(choice.acts).error);
  EXPECT_TRUE(chooser.said("on this body: under its weight ")) << chooser.log.back();
  EXPECT_EQ(encode(decode_choices(encode({choice}))), encode({choice}));
}

/// What is held at a face is tried with and without smaller elements at its rim, unless the author chose.
TEST(ChooseScene, GradesAtRimsWhereThatServes) {
  Chooser chooser;
  chooser.on_the_body = true;
  chooser.on_measure = [](RungFigures& figures, const RungTrial&) { figures.settled_sag = 1; };
  const auto chosen = [&](std::optional<Grading> grade) {
    SceneDesc scene = Chooser::scene();
    SoftDesc& liver = scene.soft[1];
    constexpr double flat = 1e4;
    liver.attach.push_back({Vec3(0, -flat, 0), flat + 1e-4, 1e13});
    liver.material.youngs_modulus = 1e5;
    liver.configuration.model = "fem_neo_hookean";
    liver.configuration.element = "tet10";
    liver.geometry.cell = 0.05;
    liver.choice.fixed = {.model = true, .element = true, .cell = true, .grade = grade.has_value()};
    if (grade) liver.geometry.grade = *grade;
    liver.choice.accuracy.value = 1;
    liver.choice.accuracy_of = {"shape"};
    const Choice choice = chooser.choose(scene).front();
    EXPECT_EQ(scene.soft[1].geometry.grade, choice.grade);
    return choice;
  };
  const Choice by_need = chosen(std::nullopt), uniform = chosen(Grading::none),
               graded = chosen(Grading::rims);
  EXPECT_EQ(by_need.grade, Grading::rims);
  EXPECT_EQ(uniform.grade, Grading::none);
  EXPECT_EQ(graded.grade, Grading::rims);
  EXPECT_EQ(by_need.expected.error, graded.expected.error);
  EXPECT_LT(graded.expected.error, 0.8 * uniform.expected.error);
  EXPECT_EQ(decode_choices(encode({graded})).front().grade, Grading::rims);
}

/// A way that the table makes too dark is tried all the same, and chosen where it suits the body.
TEST(ChooseScene, TriesWhatTheTableMakesTooDark) {
  Chooser chooser;
  chooser.on_the_body = true;
  chooser.on_measure = [](RungFigures& figures, const RungTrial& trial) {
    if (trial.rung.element == "tet4")
      figures.settled_sag *= 0.1;  // nine tenths off, whatever the mesh
    else
      figures.ms *= 100;
  };
  SceneDesc scene = Chooser::scene();
  SoftDesc& liver = scene.soft[1];
  constexpr double flat = 1e4;
  liver.attach.push_back({Vec3(0, -flat, 0), flat + 1e-4, 1e13});  // tilted, linear ones would not suit it
  liver.configuration.model = "fem_neo_hookean";
  liver.choice.fixed.model = liver.choice.fixed.grade = true;
  liver.material.poisson_ratio = 0.3;
  liver.choice.accuracy.value = 60;
  liver.choice.accuracy_of = {"shape"};
  const Choice choice = chooser.choose(scene).front();
  EXPECT_EQ(choice.rung.element, "tet4");
  EXPECT_TRUE(choice.good_enough);
  EXPECT_FALSE(choice.acts.empty());
}

TEST(Choices, AsTextComeBackAndAreChecked) {
  Chooser chooser;
  SceneDesc scene = Chooser::scene();
  const auto choices = chooser.choose(scene);
  const std::string text = encode(choices);
  EXPECT_EQ(encode(decode_choices(text)), text);
  SceneDesc other = Chooser::scene();
  adopt(decode_choices(text), other);
  EXPECT_EQ(other.soft[1].geometry.cell, scene.soft[1].geometry.cell);
  EXPECT_EQ(other.soft[1].configuration.solver_tolerance, scene.soft[1].configuration.solver_tolerance);
  EXPECT_THROW(adopt(decode_choices("[]"), other), InputError);
  std::string bad = text;
  bad.replace(bad.find("\"substeps\":"), 11, "\"substeps\":-");
  for (const std::string& spoiled : {std::string(), std::string("{"), std::string("[{}]"), bad})
    EXPECT_THROW(decode_choices(spoiled), InputError) << spoiled;
}

}  // namespace
}  // namespace prosector
