#pragma once
// What prosector-bench can measure; each prints a table and returns its report.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/report.h"

namespace prosector {

struct SoftBenchOptions {
  unsigned tets = 4000;  // about
  unsigned threads = 1;
  int repeats = 51;
};
/// The calls of a Newton iteration on a pressed box of tetrahedra, for every law and element.
Report bench_soft(const SoftBenchOptions& options);

/// Every integrator by itself on a spring: order, limit and growth, beside theory.
Report bench_integrators();

struct RenderBenchOptions {
  std::string scene;  // file
  int width = 800, height = 600;
  int frames = 10;
  std::string picture_folder;  // where to write the pictures drawn; empty: nowhere
  bool stereo = false;         // two eyes side by side, each half as wide
};
/// Frames of a scene in which a hand presses an organ. LP_NUM_THREADS=1 for steady figures.
Report bench_render(const RenderBenchOptions& options);

struct BeamBenchOptions {
  std::vector<std::uint32_t> cells = {2, 3, 4, 6, 11};  // across; each makes 24n³ tetrahedra
  std::string model, element, solver;                   // only these rows; empty: all
  unsigned threads = 2;                                 // from one to this many
};
/// The cantilever of other codes' figures: time against errors, moving and settled.
Report bench_beam(const BeamBenchOptions& options);

struct Beam101kBenchOptions {
  int steps = 60;
  std::string solver;    // only these rows; empty: all
  unsigned threads = 2;  // from one to this many
};
/// SOFA's published beam of 101,250 tetrahedra.
Report bench_beam101k(const Beam101kBenchOptions& options);

struct PressBenchOptions {
  unsigned cells = 12;   // through the organ; n make 18n³ tetrahedra
  std::string solver;    // only these rows; empty: all
  unsigned threads = 2;  // from one to this many
};
/// An organ pressed by a ball: steps a second in contact, and their error.
Report bench_press(const PressBenchOptions& options);

struct WeightBenchOptions {
  std::string body;          // only this one; empty: all
  double poisson_ratio = 0;  // only this one; 0: all
  bool quick = false;        // coarse: to see that it runs
};
/// Bodies that stand and hang: error against cost, the nearer to incompressible the harder.
Report bench_weight(const WeightBenchOptions& options);

struct ContactBenchOptions {
  std::string only;            // one case; empty: all
  std::string picture_folder;  // where to write contact-hertz.svg; empty: nowhere
  bool quick = false;          // coarse and short: to see that it runs
};
std::vector<std::string> contact_case_names();
/// What bodies make of touching each other, beside what they should; one thread.
Report bench_contact(const ContactBenchOptions& options);

struct CrowdBenchOptions {
  std::string scene;  // file
  std::string organ;  // which is pressed; empty: the one of the most tetrahedra
  std::vector<std::size_t> users = {1, 2, 4, 8, 16, 32, 64};
  std::size_t hands = 2;  // of each user
  double depth = 0.02;    // m: how far in middle fingertips are aimed
  int ticks = 60;         // measured for each crowd
  int threads = 2;
  unsigned seed = 1;  // of the places that are pressed
};
/// A step's cost against how many people press one organ of a scene.
Report bench_crowd(const CrowdBenchOptions& options);

struct RefineBenchOptions {
  bool quick = false;               // a coarse body alone, and refined: to see that it runs
  std::string only;                 // layer or organ; empty: both
  std::string contact = "surface";  // the body's, as a scene names it
  std::string picture_folder;       // where to write refine-BODY.svg; empty: nowhere
  int threads = 1;
};
/// The force of a ball pressed into tissue whose elements are smaller where it presses.
Report bench_refine(const RefineBenchOptions& options);

struct ReferenceBenchOptions {
  std::string only;    // one of trade's cases; empty: all
  bool quick = false;  // the coarsest mesh of each: to see that it runs
};
/// What trade's cases cube, slab, hang, press and organ are judged by, found anew on finer and finer meshes.
Report bench_references(const ReferenceBenchOptions& options);

struct CutBenchOptions {
  int threads = 2;
  bool quick = false;                  // one coarse organ: to see that it runs
  double cell = 0;                     // m, of the one organ; 0: those of the table
  std::string only;                    // one stroke, as rows name it; empty: all
  bool sheets = false;                 // these alone
  std::string model, element, solver;  // the organ's, as a scene names them; empty: a scene's default
  bool self_contact = false;           // of the organ
};
std::vector<std::string> cut_stroke_names();
/// Strokes of a knife through organs of 5, 20 and 50 thousand tetrahedra.
Report bench_cut(const CutBenchOptions& options);

struct TradeBenchOptions {
  bool quick = false;
  std::string only, model;        // one case, one model (as rows name it); empty: all
  std::string picture_folder;     // where to write trade-CASE.svg; empty: nowhere
  std::vector<std::string> from;  // reports whose rows are judged, drawn and advised on, instead of measured
  double limit_ms = 12000;        // CPU time of one run; what would take longer is told as too slow
};
/// Error against cost over the reference cases, one thread, with a recommendation.
Report bench_trade(const TradeBenchOptions& options);

struct StabilityBenchOptions {
  std::string model, extreme;  // only these; empty: all
  std::string picture_folder;  // where to write stability.svg; empty: nowhere
  bool quick = false;          // only what is done in a blink
  double limit_ms = 20000;     // CPU time of one rung under one extreme; what takes longer is left open
};
std::vector<std::string> extreme_names();
/// Extremes over each rung, and a map of the verdicts; one thread.
Report bench_stability(const StabilityBenchOptions& options);

struct ScalingBenchOptions {
  std::string model, solver;  // only these rows; empty: all
  double max_tets = 1e6;
  unsigned threads = 2;    // 1, 2, 4 … up to this many
  double limit_ms = 2000;  // CPU time of a frame after which no finer mesh is tried
};
/// Time against elements, from 100 on, and threads.
Report bench_scaling(const ScalingBenchOptions& options);

struct NeedBenchOptions {
  std::string scene;              // file
  std::string body;               // only this one; empty: all solid soft ones
  std::string cache;              // folder of rungs.json, meshes and trials
  std::vector<std::string> data;  // folders of what scenes name
  bool verbose = false;           // also what is tried
};
/// What each soft body of a scene can have at what price, and what it promises.
Report bench_need(const NeedBenchOptions& options);

struct PromiseBenchOptions {
  int cases = 30;
  unsigned seed = 1;
  std::size_t finest_reference = 24000;  // tetrahedra
  std::string cache;
  std::vector<std::string> data;  // folders where the CT volume is looked up
  bool verbose = false;           // also what is tried
};
/// Random bodies that ask for accuracy: what is promised against a finer reference and other acts.
Report bench_promise(const PromiseBenchOptions& options);

struct EstimateBenchOptions {
  std::string only;            // one case; empty: all
  std::string scene;           // file, of which the cost is measured; empty: it isn't
  std::string picture_folder;  // where to write estimate.svg; empty: nowhere
  bool quick = false;          // one coarse case: to see that it runs
};
/// What bodies tell of their own error against the error that they have, over a table of cases.
Report bench_estimate(const EstimateBenchOptions& options);

struct FeltBenchOptions {
  std::string journal;                               // file of a recorded session
  std::string scene;                                 // file in place of the session's own scene; empty: that
  std::string body = "liver";                        // soft body whose force is told
  std::vector<double> cells = {0.016, 0.012, 0.01};  // m: of the finer models, quadratic and of tissue's law
  unsigned threads = 2;
};
/// What people felt in a recorded session, against what finer models of the organ would have let them feel.
Report bench_felt(const FeltBenchOptions& options);

struct CollisionBenchOptions {
  int pairs = 1000;  // poses a shape
  int ticks = 5;
  int max_bodies = 10000;
  int max_triangles = 131072;
  std::string picture_folder;  // where to write collision.svg; empty: nowhere
  double limit_ms = 5000;      // CPU time of a tick after which no larger scene is tried
};
/// Collision detection at every fidelity: cost, false and missed hits, errors, memory, growth; one thread.
Report bench_collision(const CollisionBenchOptions& options);

struct HapticsBenchOptions {
  bool quick = false;          // coarse: to see that it runs
  std::string picture_folder;  // where to write haptics-stable.svg and haptics-felt.svg; empty: nowhere
};
/// What a hand feels of tissue over a network with an arm, scheme by scheme, in virtual time.
Report bench_haptics(const HapticsBenchOptions& options);

struct CameraBenchOptions {
  bool quick = false;  // few places: to see that it runs
  std::filesystem::path
      picture_folder;          // where to write camera-distance.svg and camera-speed.svg; empty: nowhere
  std::filesystem::path page;  // a picture that is measured as a board, 0.2 m wide; empty: none is
};
/// Printed boards, and a face, before a synthetic camera, by what makes it hard; and CPU time a picture.
Report bench_camera(const CameraBenchOptions& options);

struct HandsBenchOptions {
  bool quick = false;  // few pictures: to see that it runs
};
/// Bare hands before synthetic cameras: found, followed, fitted, their gestures, and CPU time a picture.
Report bench_hands(const HandsBenchOptions& options);

}  // namespace prosector
