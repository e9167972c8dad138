#pragma once
// Subjects of prosector-bench. Each function runs one benchmark, prints a table and returns its report.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/report.h"

namespace prosector {

struct SoftBenchOptions {
  unsigned tets = 4000;  // approximate number of tetrahedra
  unsigned threads = 1;
  int repeats = 51;
};
/// Measures the parts of a Newton iteration on a pressed box of tetrahedra, for every law and element.
Report bench_soft(const SoftBenchOptions& options);

/// Measures every integrator on a spring: order, stability limit and growth, with theory.
Report bench_integrators();

struct RenderBenchOptions {
  std::string scene;  // file
  int width = 800, height = 600;
  int frames = 10;
  std::string picture_folder;  // folder of the rendered images; empty: not written
  bool stereo = false;         // two eyes side by side, each half as wide
};
/// Measures frames of a scene in which a hand presses an organ. Set LP_NUM_THREADS=1 for reproducible times.
Report bench_render(const RenderBenchOptions& options);

struct BeamBenchOptions {
  std::vector<std::uint32_t> cells = {2, 3, 4, 6, 11};  // cells across; n cells give 24n³ tetrahedra
  std::string model, element, solver;                   // filter; empty: all
  unsigned threads = 2;                                 // maximum; runs start with one thread
};
/// Measures the cantilever of other codes' published results: time against error, moving and static.
Report bench_beam(const BeamBenchOptions& options);

struct Beam101kBenchOptions {
  int steps = 60;
  std::string solver;    // filter; empty: all
  unsigned threads = 2;  // maximum; runs start with one thread
};
/// Measures SOFA's published beam of 101,250 tetrahedra.
Report bench_beam101k(const Beam101kBenchOptions& options);

struct PressBenchOptions {
  unsigned cells = 12;   // cells through the organ; n cells give 18n³ tetrahedra
  std::string solver;    // filter; empty: all
  unsigned threads = 2;  // maximum; runs start with one thread
};
/// Measures an organ pressed by a ball: steps per second in contact, and their error.
Report bench_press(const PressBenchOptions& options);

struct WeightBenchOptions {
  std::string body;          // filter; empty: all
  double poisson_ratio = 0;  // filter; 0: all
  bool quick = false;        // coarse smoke test
};
/// Measures standing and hanging bodies for several ν: error against cost of each element.
Report bench_weight(const WeightBenchOptions& options);

struct ContactBenchOptions {
  std::string only;            // case; empty: all
  std::string picture_folder;  // folder of contact-hertz.svg; empty: not written
  bool quick = false;          // coarse, short smoke test
};
std::vector<std::string> contact_case_names();
/// Runs the contact test suite: measured values against references, one thread.
Report bench_contact(const ContactBenchOptions& options);

struct CrowdBenchOptions {
  std::string scene;  // file
  std::string organ;  // pressed organ; empty: the one with the most tetrahedra
  std::vector<std::size_t> users = {1, 2, 4, 8, 16, 32, 64};
  std::size_t hands = 2;  // hands per user
  double depth = 0.02;    // m, target depth of the middle fingertips
  int ticks = 60;         // measured ticks per row
  int threads = 2;
  unsigned seed = 1;  // random seed of the pressed points
};
/// Measures step time against the number of users who press one organ of a scene.
Report bench_crowd(const CrowdBenchOptions& options);

struct RefineBenchOptions {
  bool quick = false;               // smoke test: one coarse body, without and with refinement
  std::string only;                 // layer, organ or liver; empty: all
  std::string contact = "surface";  // contact points of the body, as in scenes
  std::string picture_folder;       // folder of refine-BODY.svg; empty: not written
  int threads = 1;
};
/// Measures the force of a ball pressed into locally refined tissue, and its cost.
Report bench_refine(const RefineBenchOptions& options);

struct ReferenceBenchOptions {
  std::string only;    // case of trade; empty: all
  bool quick = false;  // smoke test on the coarsest mesh of each
};
/// Recomputes the reference solutions of the cases cube, slab, hang, press, organ and liver on finer meshes.
Report bench_references(const ReferenceBenchOptions& options);

struct CutBenchOptions {
  int threads = 2;
  bool quick = false;                  // smoke test with one coarse organ
  double cell = 0;                     // m, cell size of the organ; 0: all default sizes
  std::string only;                    // stroke, as named in rows; empty: all
  bool sheets = false;                 // only the sheets
  std::string model, element, solver;  // of the organ; empty: a scene's default
  bool self_contact = false;           // self-contact of the organ
};
std::vector<std::string> cut_stroke_names();
/// Measures strokes of a blade through organs of 5, 20 and 50 thousand tetrahedra, and through sheets.
Report bench_cut(const CutBenchOptions& options);

struct TradeBenchOptions {
  bool quick = false;
  std::string only, model;        // case, model (as named in rows); empty: all
  std::string picture_folder;     // folder of trade-CASE.svg; empty: not written
  std::vector<std::string> from;  // reports to evaluate instead of measuring
  double limit_ms = 12000;        // limit of one run's CPU time; longer runs are reported as stopped
};
/// Measures error against cost of all model configurations over the test cases, with a recommendation; one
/// thread.
Report bench_trade(const TradeBenchOptions& options);

struct StabilityBenchOptions {
  std::string model, extreme;     // filters; empty: all
  std::string picture_folder;     // folder of stability.svg; empty: not written
  std::vector<std::string> from;  // reports that are mapped instead of runs; empty: measure
  bool quick = false;             // only fast extremes
  double limit_ms =
      20000;  // limit of CPU time of one configuration under one extreme; longer runs have no verdict
};
std::vector<std::string> extreme_names();
/// Runs every configuration under every extreme and maps the verdicts; one thread.
Report bench_stability(const StabilityBenchOptions& options);

struct ScalingBenchOptions {
  std::string model, solver;  // filter; empty: all
  double max_tets = 1e6;
  unsigned threads = 2;    // 1, 2, 4 … up to this many
  double limit_ms = 2000;  // CPU time of a frame beyond which no finer mesh is run
};
/// Measures frame time against the number of elements, from 100, and of threads.
Report bench_scaling(const ScalingBenchOptions& options);

struct NeedBenchOptions {
  std::string scene;              // file
  std::string body;               // filter; empty: all solid soft bodies
  std::string cache;              // cache folder: rungs.json, meshes and trials
  std::vector<std::string> data;  // folders of data files that scenes name
  bool verbose = false;           // print each trial
};
/// Chooses configurations of each soft body of a scene for several accuracies: cost and predicted error.
Report bench_need(const NeedBenchOptions& options);

struct PromiseBenchOptions {
  int cases = 30;
  unsigned seed = 1;
  std::size_t finest_reference = 24000;  // tetrahedra
  std::string cache;
  std::vector<std::string> data;  // folders searched for the CT volume
  bool verbose = false;           // print each trial
};
/// Measures the predicted accuracy of random bodies against finer references and other loads.
Report bench_promise(const PromiseBenchOptions& options);

struct EstimateBenchOptions {
  std::string only;            // case; empty: all
  std::string scene;           // scene file for the cost of estimates; empty: not measured
  std::string picture_folder;  // folder of estimate.svg; empty: not written
  bool quick = false;          // smoke test with one coarse case
};
/// Measures the estimated error of soft bodies against their true error.
Report bench_estimate(const EstimateBenchOptions& options);

struct FeltBenchOptions {
  std::string journal;         // file of a recorded session
  std::string scene;           // scene file that replaces the recorded scene; empty: none
  std::string body = "liver";  // soft body whose force is reported
  std::vector<double> cells = {
      0.016, 0.012, 0.01};  // m: cells of the finer models, with quadratic elements and the tissue law
  unsigned threads = 2;
};
/// Re-runs a recorded session's inputs on finer models of the organ and compares the contact forces.
Report bench_felt(const FeltBenchOptions& options);

struct CollisionBenchOptions {
  int pairs = 1000;  // poses per shape
  int ticks = 5;
  int max_bodies = 10000;
  int max_triangles = 131072;
  std::string picture_folder;  // folder of collision.svg; empty: not written
  double limit_ms = 5000;      // CPU time of a tick beyond which no larger scene is run
};
/// Measures collision detection at every fidelity: cost, false and missed hits, errors, memory, scaling; one
/// thread.
Report bench_collision(const CollisionBenchOptions& options);

struct HapticsBenchOptions {
  bool quick = false;          // coarse smoke test
  std::string picture_folder;  // folder of haptics-stable.svg and haptics-felt.svg; empty: not written
};
/// Measures haptic rendering of tissue over a network, for each scheme, in virtual time.
Report bench_haptics(const HapticsBenchOptions& options);

struct CameraBenchOptions {
  bool quick = false;  // smoke test with few poses
  std::filesystem::path
      picture_folder;          // folder of camera-distance.svg and camera-speed.svg; empty: not written
  std::filesystem::path page;  // image measured as a board 0.2 m wide; empty: none
};
/// Measures detection of printed boards and a face with a synthetic camera under varied conditions: errors,
/// CPU time per image.
Report bench_camera(const CameraBenchOptions& options);

struct HandsBenchOptions {
  bool quick = false;  // smoke test with few images
};
/// Measures bare hands before synthetic cameras: detection, tracking, fitting, gestures, CPU time per image.
Report bench_hands(const HandsBenchOptions& options);

}  // namespace prosector
