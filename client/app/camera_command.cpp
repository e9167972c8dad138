#include "client/app/camera_command.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

#include "client/app/configured_device.h"
#include "client/app/guided_run.h"
#include "common/clock.h"
#include "common/error.h"
#include "common/version.h"
#include "drivers/camera/calibration/stereo_guide.h"
#include "drivers/camera/camera_frames.h"
#include "drivers/camera/camera_report.h"
#include "drivers/camera/camera_thread.h"
#include "drivers/camera/tags/known_boards.h"
#include "drivers/camera/tags/tag_reader.h"
#include "drivers/client_config.h"
#include "drivers/fitting/align_guide.h"
#include "drivers/toml_text.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
constexpr auto picture_patience = 500ms, look_again = 100ms;
constexpr double said_again_after = 2;  // s, where nothing new is to be said

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  if (!out.flush()) throw InputError(fmt::format("{}: cannot be written", file.string()));
}

/// Says a step's words, once, and again where they stay for long.
class StepTeller {
 public:
  /// Tells what to do, after how far one is. `kept`: views so far.
  void tell(const std::string& instruction, std::size_t kept, const std::string& progress) {
    const std::int64_t now_ns = monotonic_ns();
    if (instruction == told_ && kept == kept_ &&
        static_cast<double>(now_ns - told_ns_) * 1e-9 < said_again_after)
      return;
    told_ = instruction;
    kept_ = kept;
    told_ns_ = now_ns;
    say(fmt::format("{}: {}", progress, instruction));
  }

 private:
  std::string told_;
  std::size_t kept_ = 0;
  std::int64_t told_ns_ = 0;
};

/// Two cameras, each looked at on a thread of its own, that one board is shown to.
class PairWatch {
 public:
  explicit PairWatch(const CameraCommandOptions& o)
      : addresses_{o.camera, o.second}, guide_(find_board(o.board)) {
    for (std::size_t k = 0; k < addresses_.size(); ++k)
      threads_[k] = std::make_unique<CameraThread>(
          addresses_[k],
          [this, k](const Camera& camera) {
            const std::lock_guard lock(mutex_);
            identities_[k] = camera.identity();
          },
          [this, k](const Frame& frame) {
            const std::lock_guard lock(mutex_);
            guide_.take(k, frame);
          });
  }

  /// Returns what to do next: first of all to a camera that gives no pictures.
  StereoGuideStep step() const {
    StereoGuideStep out;
    {
      const std::lock_guard lock(mutex_);
      out = guide_.step();
    }
    if (out.done) return out;
    for (std::size_t k = 0; k < addresses_.size(); ++k)
      if (const std::string problem = threads_[k]->state().problem; !problem.empty())
        out.instruction = fmt::format("camera {}: {}", addresses_[k], problem);
    return out;
  }
  /// Lets the cameras go. Returns what was seen.
  const StereoGuide& end() {
    threads_ = {};
    return guide_;
  }
  const std::string& identity(std::size_t camera) const { return identities_[camera]; }

 private:
  const std::array<std::string, 2> addresses_;
  mutable std::mutex mutex_;  // guards what follows
  StereoGuide guide_;
  std::array<std::string, 2> identities_;
  std::array<std::unique_ptr<CameraThread>, 2> threads_;  // last: they use what is above
};

/// Says what a fit found.
void tell_fit(const LensFit& fit) {
  const Lens& lens = fit.calibration.lens;
  say(fmt::format("focal lengths {:.2f} and {:.2f} px, centre {:.2f}, {:.2f}; response {:.2f}", lens.fx,
                  lens.fy, lens.cx, lens.cy, fit.calibration.response));
  say(fmt::format(
      "{:.3f} px off at views that weren't fitted ({:.3f} at the others); {:.0f} % of the picture is covered",
      fit.held_out, fit.rms, 100 * fit.covered));
  if (!fit.by_edges) say(rough_lens_words);
}

/// Returns the file of the second camera's lens: beside the first one's.
std::filesystem::path second_file(const std::filesystem::path& first) {
  return first.parent_path() / (first.stem().string() + "-second" + first.extension().string());
}

bool is_over(std::int64_t begin_ns, double patience) {
  return static_cast<double>(monotonic_ns() - begin_ns) * 1e-9 > patience;
}

/// Watches a board before a camera, which is opened when it is first looked at.
class BoardWatch {
 public:
  explicit BoardWatch(const CameraCommandOptions& o)
      : address_(o.camera), reader_(o.lens), tracker_(find_board(o.board)) {
    reader_.expect(tracker_.board());
  }

  /// Looks at the next picture and hands out where the board is, if it is read.
  void look(AlignGuide& guide) {
    if (!camera_) {
      camera_ = open_camera(address_);
      reader_.begin(*camera_);
      if (reader_.is_guessed())
        throw InputError(fmt::format("{}: isn't calibrated: give --lens FILE (camera calibrate)", address_));
    }
    const auto frame = camera_->next(picture_wait);
    if (!frame) return;
    const auto seen = tracker_.update(reader_.read(*frame), reader_.optics());
    if (seen && !seen->followed) guide.take_board(frame->time_ns, seen->camera_board);
  }

 private:
  static constexpr auto picture_wait = 5ms;

  std::string address_;
  std::unique_ptr<Camera> camera_;
  TagReader reader_;
  BoardTracker tracker_;
};

}  // namespace

int align_camera(const CameraCommandOptions& options) {
  const std::string before = read_config_text(options.out_config);
  const ConfiguredDevice known = configured_device(options.tracker, options.tracker_config);
  const auto device = open_device(known.address, known.device);
  BoardWatch watch(options);
  AlignGuide guide(options.station - 1, options.poses);
  say(fmt::format("fix the board \"{}\" to receiver {} and let {} see it", options.board, options.station,
                  options.camera));
  run_guide(guide, *device, options.patience, [&] {
    if (guide.has_tracker()) watch.look(guide);
  });
  const GuideOutcome outcome = guide.outcome();
  for (const std::string& line : outcome.words) say(line);
  save_config_text(options.out_config,
                   write_client_config(before, outcome.changes, options.out_config.string()));
  for (const ConfigChange& change : outcome.changes) say(change.key + " = " + to_toml(change.value));
  say(fmt::format("wrote {}", options.out_config.string()));
  return 0;
}

int calibrate_camera(const CameraCommandOptions& options) {
  if (!options.second.empty()) return calibrate_pair(options);
  const std::unique_ptr<Camera> camera = open_camera(options.camera);
  LensGuide guide(find_board(options.board));
  say(fmt::format(
      "{}: show it the board \"{}\" (prosector-board {} --out board.pdf), near, in all parts of the picture, "
      "tilted in all directions",
      options.camera, guide.board().name, options.board));
  StepTeller teller;
  const std::int64_t begin_ns = monotonic_ns();
  for (LensGuideStep step; !step.done;) {
    if (is_over(begin_ns, options.patience)) {
      if (guide.views().size() < least_views)
        throw InputError(fmt::format("not done after {:.0f} s: {} views of {} came", options.patience,
                                     guide.views().size(), usual_views));
      say("time is over: what there is must do");
      break;
    }
    if (const auto frame = camera->next(picture_patience)) guide.take(frame->image);
    step = guide.step();
    teller.tell(
        step.instruction, step.views,
        fmt::format("view {}/{}, {:.0f} % of the picture", step.views, usual_views, 100 * step.covered));
  }
  say("fitting …");
  const LensFit fit = fit_lens(guide.board(), guide.views(), camera->identity());
  tell_fit(fit);
  write_file(options.out, write_calibration(fit.calibration));
  say(fmt::format("{}: written; name it in the configuration: tracker.lens = \"{}\"", options.out.string(),
                  options.out.filename().string()));
  return 0;
}

int calibrate_pair(const CameraCommandOptions& options) {
  const std::string before = options.out_config.empty() ? "" : read_config_text(options.out_config);
  PairWatch watch(options);
  say(fmt::format("{} and {}: show both the board \"{}\", near, tilted in all directions, and hold it still",
                  options.camera, options.second, options.board));
  StepTeller teller;
  const std::int64_t begin_ns = monotonic_ns();
  for (StereoGuideStep step = watch.step(); !step.done; step = watch.step()) {
    if (is_over(begin_ns, options.patience)) {
      say("time is over: what there is must do");
      break;
    }
    teller.tell(step.instruction, step.views[0] + step.views[1] + step.pairs,
                fmt::format("views {} and {} of {}, {} of {} in both", step.views[0], step.views[1],
                            usual_views, step.pairs, usual_stereo_pairs));
    std::this_thread::sleep_for(look_again);
  }
  const StereoGuide& guide = watch.end();
  say("fitting …");
  auto other = std::async(std::launch::async, [&] {
    return fit_lens(guide.of(1).board(), guide.of(1).views(), watch.identity(1));
  });
  const LensFit first = fit_lens(guide.of(0).board(), guide.of(0).views(), watch.identity(0));
  const LensFit second = other.get();
  const StereoFit pair =
      fit_stereo(guide.of(0).board(), guide.pairs(), first.calibration, second.calibration);
  tell_fit(first);
  tell_fit(second);
  say(fmt::format(
      "{} views of both, {} of them left out; {:.3f} px off in views that weren't fitted; error to "
      "expect amid the boards: {:.2f} mm RMS",
      guide.pairs().size(), pair.first_second.left_out.size(), pair.held_out, 1e3 * pair.told));
  const std::filesystem::path second_out = second_file(options.out);
  write_file(options.out, write_calibration(first.calibration));
  write_file(second_out, write_calibration(second.calibration));
  say(fmt::format("{}, {}: written", options.out.string(), second_out.string()));
  const Pose first_second = device_camera * pair.first_second.pose * device_camera;
  const std::vector<ConfigChange> changes = {{"tracker.lens", options.out.filename().string()},
                                             {"tracker.second_lens", second_out.filename().string()},
                                             {"tracker.second.position", written(first_second.p)},
                                             {"tracker.second.orientation", written(first_second.q)}};
  for (const ConfigChange& change : changes) say(change.key + " = " + to_toml(change.value));
  if (options.out_config.empty()) return 0;
  save_config_text(options.out_config, write_client_config(before, changes, options.out_config.string()));
  say(fmt::format("wrote {}", options.out_config.string()));
  return 0;
}

int test_camera(const CameraCommandOptions& options) {
  const std::unique_ptr<Camera> camera = open_camera(options.camera);
  std::optional<CameraCalibration> calibration;
  if (!options.lens.empty()) calibration = load_calibration(options.lens);
  CameraReport report(calibration);
  say(fmt::format("{} ({}): looked at for {:g} s; let a board lie still before it", options.camera,
                  camera->identity(), options.seconds));
  const std::int64_t begin_ns = monotonic_ns();
  while (static_cast<double>(monotonic_ns() - begin_ns) * 1e-9 < options.seconds)
    if (const auto frame = camera->next(picture_patience)) report.take(*frame, monotonic_ns());
  std::string text = fmt::format("{}\ncamera {} ({})\n", version_line("prosector-client camera selftest"),
                                 options.camera, camera->identity());
  for (const std::string& line : report.lines()) text += line + "\n";
  fmt::print("{}", text);
  if (!options.out.empty()) {
    write_file(options.out, text);
    say(fmt::format("the report is in {}", options.out.string()));
  }
  return report.is_good() ? 0 : 1;
}

}  // namespace prosector
