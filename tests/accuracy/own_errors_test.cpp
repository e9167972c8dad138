// What is known of ways of modelling on a body, found and inferred.

#include "server/calibration/own_errors.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "common/error.h"
#include "tests/accuracy/boxes.h"

namespace prosector {
namespace {

struct Judged {
  SoftDesc desc = test::pinned(0, 3e5, 0.3);
  int meshes = 0, lines = 0;
  std::filesystem::path cache;
  bool prove = false;
  std::size_t most_tets = TrialSettings{}.most_tets;

  OwnErrors errors() {
    return OwnErrors({.desc = desc,
                      .gravity = test::gravity,
                      .mesh = [this](double cell) { return mesh(cell); },
                      .cache_dir = cache,
                      .say = [this](const std::string&) { ++lines; },
                      .prove = prove,
                      .most_tets = most_tets,
                      .most_tets_proving = 8 * 96});
  }
  Anatomy mesh(double cell) {
    ++meshes;
    if (cell > 0.06) throw InputError("too coarse");
    const auto n = static_cast<std::uint32_t>(std::max(1., std::round(0.1 / cell)));
    return test::box({0.2, 0.1, 0.1}, 2 * n, n, n);
  }
};

std::filesystem::path new_folder() {
  return std::filesystem::temp_directory_path() / ("trials." + std::to_string(getpid()));
}

double elements(double cell) {
  return 12 * std::pow(0.1 / cell, 3);
}

TEST(OwnErrors, KnowNothingBeforeATrial) {
  Judged judged;
  EXPECT_TRUE(judged.errors().at("fem_corotational", "tet4", 0.02).empty());
}

TEST(OwnErrors, AreOfTheActsThatTheSceneAsksFor) {
  Judged judged;
  judged.desc.choice.accuracy_of = {"shape"};
  OwnErrors own = judged.errors();
  EXPECT_TRUE(own.attempt("fem_neo_hookean", "tet4", 0.05, elements(0.05)));
  EXPECT_FALSE(own.attempt("fem_neo_hookean", "tet4", 0.05, elements(0.05))) << "tried already";
  EXPECT_EQ(own.at("fem_neo_hookean", "tet4", 0.05).size(), 3u);
  judged.desc.choice.accuracy_of = {"touch"};
  OwnErrors touched = judged.errors();
  touched.attempt("fem_neo_hookean", "tet4", 0.05, elements(0.05));
  EXPECT_EQ(touched.at("fem_neo_hookean", "tet4", 0.05).size(),
            static_cast<std::size_t>(TrialSettings{}.presses));
}

/// Where a trial is too dear, coarser ones tell: no more than these, but for caution.
TEST(OwnErrors, AreInferredWhereATrialIsTooDear) {
  Judged judged;
  judged.desc.choice.accuracy_of = {"shape"};
  OwnErrors own = judged.errors();
  EXPECT_TRUE(own.attempt("fem_neo_hookean", "tet10", 0.01, elements(0.01)));
  const double fine = worst(own.at("fem_neo_hookean", "tet10", 0.01)).error;
  const double tried = worst(own.at("fem_neo_hookean", "tet10", 0.045)).error;
  EXPECT_GT(fine, 0);
  EXPECT_LE(fine, 1.25 * tried * (1 + 1e-9));
  EXPECT_LT(tried, 0.05);
  EXPECT_FALSE(own.attempt("fem_neo_hookean", "tet10", 0.01, elements(0.01))) << "nothing more to be found";
}

TEST(OwnErrors, AreKeptFromRunToRun) {
  Judged judged;
  judged.cache = new_folder();
  OwnErrors first = judged.errors();
  first.attempt("fem_corotational", "tet4", 0.05, elements(0.05));
  EXPECT_EQ(judged.lines, 1);
  OwnErrors second = judged.errors();
  second.attempt("fem_corotational", "tet4", 0.05, elements(0.05));
  EXPECT_EQ(judged.lines, 1) << "found in the cache";
  const auto one = first.at("fem_corotational", "tet4", 0.05),
             other = second.at("fem_corotational", "tet4", 0.05);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].error, other[k].error);
  judged.desc.material.youngs_modulus *= 2;
  OwnErrors stiffer = judged.errors();
  stiffer.attempt("fem_corotational", "tet4", 0.05, elements(0.05));
  EXPECT_EQ(judged.lines, 2) << "another material is tried anew";
  std::filesystem::remove_all(judged.cache);
}

/// Linear elements on a mesh too fine for a divided reference: quadratic ones on it are off themselves where
/// nearly incompressible tissue hangs on a corner. What proves divides them.
TEST(OwnErrors, AreProvedByADividedReference) {
  Judged judged;
  judged.desc = test::pinned(0, 2e4, 0.49);
  judged.desc.attach = {{Vec3(0, 0.05, 0.05), 0.055, 1e13}};
  judged.desc.choice.accuracy_of = {"shape"};
  judged.most_tets = 96;
  judged.cache = new_folder();
  EXPECT_FALSE(judged.errors().prove("fem_neo_hookean", "tet4", 0.05, 96))
      << "none is kept, none is to be made";
  judged.prove = true;
  OwnErrors own = judged.errors();
  EXPECT_TRUE(own.attempt("fem_neo_hookean", "tet4", 0.05, 96));
  const auto tried = own.at("fem_neo_hookean", "tet4", 0.05);
  EXPECT_TRUE(own.prove("fem_neo_hookean", "tet4", 0.05, 96));
  const auto proved = own.at("fem_neo_hookean", "tet4", 0.05);
  const BodyTrial divided(judged.desc, test::gravity, judged.mesh(0.05),
                          {.most_tets = 8 * 96, .presses = 0, .weight = 1.2});
  const auto right = divided.measure("fem_neo_hookean", "tet4");
  ASSERT_EQ(proved.size(), right.size());
  for (std::size_t act = 0; act < right.size(); ++act) {
    EXPECT_DOUBLE_EQ(proved[act].error, 1.5 * right[act].error) << "half as much again is promised";
    EXPECT_NE(proved[act].error, tried[act].error);
  }
  EXPECT_FALSE(own.prove("fem_neo_hookean", "tet4", 0.05, 96)) << "nothing more to be found";

  judged.prove = false;
  OwnErrors later = judged.errors();
  EXPECT_TRUE(later.prove("fem_neo_hookean", "tet4", 0.05, 96)) << "it is kept";
  EXPECT_EQ(worst(later.at("fem_neo_hookean", "tet4", 0.05)).error, worst(proved).error);
  std::filesystem::remove_all(judged.cache);
}

TEST(OwnErrors, CellsWithoutAMeshAreNotKnown) {
  Judged judged;
  OwnErrors own = judged.errors();
  EXPECT_FALSE(own.attempt("fem_neo_hookean", "tet4", 0.1, elements(0.1)));
  EXPECT_TRUE(own.at("fem_neo_hookean", "tet4", 0.1).empty());
}

}  // namespace
}  // namespace prosector
