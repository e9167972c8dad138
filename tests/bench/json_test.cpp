// Tests the JSON report of each subject of prosector-bench, with the smallest settings.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/bench/report.h"
#include "tests/folders.h"
#include "tests/real_data.h"

namespace prosector {
namespace {

struct Subject {
  const char* name;
  const char* smallest;                                   // arguments
  std::vector<const char*> settings, figures;             // keys that each row has
  std::vector<std::vector<const char*>> one_set_of = {};  // each row also has all keys of one of these sets
  friend void PrintTo(const Subject& subject, std::ostream* out) { *out << subject.name; }
};

class Json : public testing::TestWithParam<Subject> {
 protected:
  static nlohmann::json run(const Subject& subject) {
    const auto folder = std::filesystem::temp_directory_path();
    const std::string file =
        folder / ("prosector-bench." + std::to_string(getpid()) + "." + subject.name + ".json");
    const std::string command = "cd " + source_path("") + " && " + build_path("bin/prosector-bench") + " " +
                                subject.name + " " + subject.smallest + " --json " + file + " > /dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream in(file);
    nlohmann::json out = nlohmann::json::parse(in, nullptr, false);
    std::filesystem::remove(file);
    return out;
  }
};

const std::vector<const char*> rung = {"model", "element", "integrator", "solver",
                                       "tets",  "nodes",   "dt",         "threads"};

INSTANTIATE_TEST_SUITE_P(
    Subjects, Json,
    testing::Values(
        Subject{"soft", "--tets 6 --repeats 1", rung, {"ms_iteration", "ms_iteration_per_1000_tets"}},
        Subject{"integrators",
                "",
                {"model", "integrator", "omega_dt"},
                {"order", "growth_per_step", "growth_per_step_theory", "largest_omega_dt"}},
        Subject{"beam",
                "--cells 1 --threads 1 --model fem_corotational --solver multigrid",
                rung,
                {"ms_per_frame", "error_mesh", "error_continuum", "error_dynamic", "residual", "verdict"}},
        Subject{"beam101k",
                "--steps 1 --threads 1 --solver cg",
                rung,
                {"ms_per_frame", "steps_per_s", "error_mesh", "residual", "verdict"}},
        Subject{"press",
                "--cells 2 --threads 1 --solver cg",
                rung,
                {"ms_per_frame", "steps_per_s", "error_mesh", "residual", "verdict"}},
        Subject{"weight",
                "--quick --nu 0.49",
                {"body", "act", "poisson_ratio", "element", "tets"},
                {"error", "ms_per_frame"}},
        Subject{"contact",
                "--case exchange --quick",
                {"case", "setting", "figure", "unit", "dt"},
                {"measured", "reference", "tolerance", "verdict", "ms_per_tick"}},
        Subject{"haptics",
                "--quick",
                {"scheme", "hand", "round_trip", "jitter", "loss"},
                {},
                {{"stable_stiffness"},
                 {"stiffness", "felt_static", "felt_2hz", "felt_8hz", "ripple", "least_energy", "onset",
                  "peak"}}},
        Subject{"camera",
                "--quick",
                {"board", "varied"},
                {"value", "seen", "depth_mm", "turn_deg", "find_ms", "fit_ms"}},
        Subject{"hands",
                "--quick",
                {"trial", "nets", "cameras", "pictures"},
                {"seen", "right_points", "right_side", "sure", "points_median", "lateral_mm", "depth_mm",
                 "turn_deg", "flexion_median", "find_ms", "fit_ms"}},
        Subject{"crowd",
                "deploy/scenes/minimal.toml --users 2 --ticks 3 --threads 1",
                {"scene", "organ", "tets", "threads", "seed", "dt", "users", "hands", "depth"},
                {"contacts", "awake", "islands", "newton_iterations", "solver_iterations", "unconverged",
                 "force", "ms_p50", "ms_p95", "cpu_ms_p50", "ms_narrow", "ms_coupled"}},
        Subject{"refine",
                "--quick --body layer --threads 1",
                {"body", "way", "element", "contact", "threads", "cell_mm", "refine_cell_mm"},
                {"tets_at_most", "force_mN", "error_continuum", "off_trend", "from_tick_to_tick",
                 "cpu_ms_held", "cpu_ms_drawn"}},
        Subject{
            "cut",
            "--quick --threads 1",
            {"stroke", "tets", "tets_after", "threads"},
            {"added_ms_p50", "least_angle_deg_before", "least_angle_deg_after", "volume_error"},
            {{"ticks_that_cut", "ms_p50_cutting", "ms_p50_other"}, {"ms_cutting_mesh", "ms_making_bodies"}}},
        Subject{"trade",
                "--quick --case heavy --model bullet_classic --limit 5",
                rung,
                {"ms_per_frame", "steps_per_s", "memory_kib"}},
        Subject{"trade",
                "--quick --case cube --model bullet_classic --limit 5",
                rung,
                {"ms_per_frame", "steps_per_s", "memory_kib"}},
        Subject{"trade",
                "--quick --case slab --model xpbd --limit 5",
                rung,
                {"ms_per_frame", "steps_per_s", "memory_kib"}},
        Subject{"trade",
                "--quick --case hang --model xpbd --limit 5",
                rung,
                {"ms_per_frame", "steps_per_s", "memory_kib"}},
        Subject{"trade",
                "--quick --case press --model fem_corotational --limit 5",
                rung,
                {"ms_per_frame", "steps_per_s", "memory_kib"}},
        Subject{"trade",
                "--quick --case organ --model xpbd --limit 5",
                rung,
                {"ms_per_frame", "steps_per_s", "memory_kib"}},
        Subject{"references",
                "--quick --case cube",
                {"case", "mesh", "element"},
                {"off", "unsettled", "moved_m"}},
        Subject{"references",
                "--quick --case organ",
                {"case", "mesh", "element"},
                {"off", "unsettled", "force_N"}},
        Subject{"trade",
                "--quick --case free --model xpbd --limit 10",
                rung,
                {"ms_per_frame", "steps_per_s", "memory_kib"}},
        Subject{"stability", "--model xpbd --extreme '1 element'", rung, {"verdict"}},
        Subject{"scaling",
                "--max 100 --threads 1 --model fem_corotational --solver cg",
                rung,
                {"ms_per_frame", "cpu_us_per_tet", "steps_per_s", "residual"}},
        Subject{"estimate",
                "--quick",
                {"case", "act", "poisson_ratio", "model", "element", "tets"},
                {"error_continuum", "unsettled", "estimate", "discretisation", "model_part", "effectivity"}},
        Subject{"collision", "--pairs 10 --ticks 1 --bodies 100 --triangles 128", {"case", "fidelity"}, {}},
        Subject{"contact",
                "--case organ --quick",
                {"case", "setting", "figure", "unit", "dt"},
                {"measured", "reference", "tolerance", "ms_per_tick"}}),
    [](const auto& row) { return std::string(row.param.name) + std::to_string(row.index); });

TEST_P(Json, SaysWhatWasMeasuredOnWhat) {
  if (std::string("hands") == GetParam().name && find_in_data("palm_full.tflite").empty())
    GTEST_SKIP() << "no palm_full.tflite: deploy/fetch_models.sh";
  const nlohmann::json report = run(GetParam());
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report["bench"], GetParam().name);
  EXPECT_TRUE(report["machine"].is_object() && report["machine"].contains("cpu"));
  for (const char* key : {"compiler", "date", "commit"}) {
    EXPECT_TRUE(report[key].is_string()) << key;
    EXPECT_FALSE(report[key].empty()) << key;
  }
  ASSERT_TRUE(report["rows"].is_array());
  ASSERT_FALSE(report["rows"].empty());
  for (const nlohmann::json& row : report["rows"]) {
    for (const char* key : GetParam().settings)
      EXPECT_TRUE(row.contains(key) && !row[key].is_null()) << key << row;
    const auto has = [&row](const char* key) { return row.contains(key); };
    for (const char* key : GetParam().figures) EXPECT_TRUE(has(key)) << key << row;
    const auto& sets = GetParam().one_set_of;
    EXPECT_TRUE(sets.empty() ||
                std::any_of(sets.begin(), sets.end(),
                            [&has](const auto& set) { return std::all_of(set.begin(), set.end(), has); }))
        << row;
    if (row.contains("verdict")) {
      const auto& allowed = verdict_names;
      EXPECT_NE(std::find(allowed.begin(), allowed.end(), row["verdict"].get<std::string>()), allowed.end())
          << row;
    }
  }
}

}  // namespace
}  // namespace prosector
