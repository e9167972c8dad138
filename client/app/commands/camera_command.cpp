#include "client/app/commands/camera_command.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

#include "client/app/commands/configured_device.h"
#include "client/app/commands/guided_run.h"
#include "common/clock.h"
#include "common/error.h"
#include "common/version.h"
#include "drivers/camera/base/camera_frames.h"
#include "drivers/camera/calibration/camera_report.h"
#include "drivers/camera/calibration/stereo_guide.h"
#include "drivers/camera/capture/camera_thread.h"
#include "drivers/camera/tags/standard_boards.h"
#include "drivers/camera/tags/tag_reader.h"
#include "drivers/config/client_config.h"
#include "drivers/device/driver_table.h"
#include "drivers/files/toml_text.h"
#include "drivers/fitting/align_guide.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
constexpr auto image_timeout = 500ms, pair_poll_interval = 100ms;
constexpr double repeat_interval = 2;  // s until an unchanged instruction is printed again

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  if (!out.flush()) throw InputError(fmt::format("{}: cannot be written", file.string()));
}

/// Prints a guide's instructions: each one when it changes, and again every 2 s while it stays the same.
class StepPrinter {
 public:
  /// Prints the progress and the instruction. `kept`: number of views so far.
  void print(const std::string& instruction, std::size_t kept, const std::string& progress) {
    const std::int64_t now_ns = monotonic_ns();
    if (instruction == instruction_ && kept == views_ &&
        static_cast<double>(now_ns - reported_ns_) * 1e-9 < repeat_interval)
      return;
    instruction_ = instruction;
    views_ = kept;
    reported_ns_ = now_ns;
    say(fmt::format("{}: {}", progress, instruction));
  }

 private:
  std::string instruction_;
  std::size_t views_ = 0;
  std::int64_t reported_ns_ = 0;
};

/// Two cameras, each read on its own thread, that view the same board.
class CameraPairReader {
 public:
  explicit CameraPairReader(const CameraCommandOptions& o)
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

  /// Returns the guide's next step. A problem of a camera replaces the instruction.
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
  /// Closes the cameras. Returns the guide with the collected views.
  const StereoGuide& end() {
    threads_ = {};
    return guide_;
  }
  const std::string& identity(std::size_t camera) const { return identities_[camera]; }

 private:
  const std::array<std::string, 2> addresses_;
  mutable std::mutex mutex_;  // guards guide_ and identities_
  StereoGuide guide_;
  std::array<std::string, 2> identities_;
  std::array<std::unique_ptr<CameraThread>, 2> threads_;  // declared last: the threads use the members above
};

/// Prints the result of a lens fit.
void print_lens_fit(const LensFit& fit) {
  const Lens& lens = fit.calibration.lens;
  say(
      fmt::format("lens: focal lengths {:.2f} and {:.2f} px, centre {:.2f}, {:.2f} px; exponent from light "
                  "to brightness {:.2f}",
                  lens.fx, lens.fy, lens.cx, lens.cy, fit.calibration.response));
  say(
      fmt::format("lens fit: error {:.3f} px in views not used for the fit ({:.3f} px in the others); the "
                  "views cover {:.0f} % of the image",
                  fit.held_out, fit.rms, 100 * fit.covered));
  if (!fit.by_edges) say(coarse_lens_warning);
}

/// Returns the file name for the second camera's lens: the first one's with "-second" appended to its stem.
std::filesystem::path second_file(const std::filesystem::path& first) {
  return first.parent_path() / (first.stem().string() + "-second" + first.extension().string());
}

bool is_over(std::int64_t begin_ns, double time_limit) {
  return static_cast<double>(monotonic_ns() - begin_ns) * 1e-9 > time_limit;
}

/// Detects a board in the images of a camera, which is opened on the first call of look().
class BoardDetector {
 public:
  explicit BoardDetector(const CameraCommandOptions& o)
      : address_(o.camera), reader_(o.lens), tracker_(find_board(o.board)) {
    reader_.expect(tracker_.board());
  }

  /// Reads the next image and passes the board's pose to the guide if the board was detected.
  void look(AlignGuide& guide) {
    if (!camera_) {
      camera_ = open_camera(address_);
      reader_.begin(*camera_);
      if (reader_.is_guessed())
        throw InputError(
            fmt::format("camera {}: not calibrated: give the file written by `prosector-client camera "
                        "calibrate` with --lens FILE",
                        address_));
    }
    const auto frame = camera_->next(picture_wait);
    if (!frame) return;
    const auto seen = tracker_.update(reader_.read(*frame), reader_.optics());
    if (seen && !seen->followed) guide.add_board_pose(frame->time_ns, seen->camera_board);
  }

 private:
  static constexpr auto picture_wait = 5ms;

  std::string address_;
  std::unique_ptr<Camera> camera_;
  TagReader reader_;
  BoardTracker tracker_;
};

/// Returns the text of the configuration to which the lens `lens` will be written. Throws InputError if it
/// can't be written there, for example because no tracker is configured, before the user spends time on a
/// calibration.
std::string writable_config_text(const std::filesystem::path& file, const std::filesystem::path& lens) {
  std::string text = read_config_text(file);
  (void)write_client_config(text, {{"tracker.lens", lens.filename().string()}}, file.string());
  return text;
}

}  // namespace

int align_camera(const CameraCommandOptions& options) {
  const std::string before = read_config_text(options.out_config);
  const ConfiguredDevice known = configured_device(options.tracker, options.tracker_config);
  const auto device = open_device(known.address, known.device);
  BoardDetector watch(options);
  AlignGuide guide(options.station - 1, options.poses);
  say(fmt::format("fix the board \"{}\" to receiver {} and show the board to camera {}", options.board,
                  options.station, options.camera));
  run_guide(guide, *device, options.time_limit, [&] {
    if (guide.has_tracker_pose()) watch.look(guide);
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
  say(
      fmt::format("camera {}: show it the board \"{}\" (print it with prosector-board {} --out board.pdf) "
                  "close up, in all parts of the image and tilted in all directions",
                  options.camera, guide.board().name, options.board));
  StepPrinter printer;
  const std::int64_t begin_ns = monotonic_ns();
  for (LensGuideStep step; !step.done;) {
    if (is_over(begin_ns, options.time_limit)) {
      if (guide.views().size() < min_views)
        throw InputError(
            fmt::format("timed out after {:.0f} s: {} of {} views of the board were taken; allow more time "
                        "with --timeout",
                        options.time_limit, guide.views().size(), recommended_views));
      say("timed out: the calibration uses the views of the board taken so far");
      break;
    }
    if (const auto frame = camera->next(image_timeout)) guide.take(frame->image);
    step = guide.step();
    printer.print(
        step.instruction, step.views,
        fmt::format("view {}/{}, {:.0f} % of the image", step.views, recommended_views, 100 * step.covered));
  }
  say("fitting …");
  const LensFit fit = fit_lens(guide.board(), guide.views(), camera->identity());
  print_lens_fit(fit);
  write_file(options.out, write_calibration(fit.calibration));
  say(fmt::format("{}: written; to use this lens, set tracker.lens = \"{}\" in the client configuration",
                  options.out.string(), options.out.filename().string()));
  return 0;
}

int calibrate_pair(const CameraCommandOptions& options) {
  const std::string before =
      options.out_config.empty() ? "" : writable_config_text(options.out_config, options.out);
  CameraPairReader watch(options);
  say(
      fmt::format("cameras {} and {}: show the board \"{}\" to both, close up and tilted in all directions, "
                  "and hold it still each time",
                  options.camera, options.second, options.board));
  StepPrinter printer;
  const std::int64_t begin_ns = monotonic_ns();
  for (StereoGuideStep step = watch.step(); !step.done; step = watch.step()) {
    if (is_over(begin_ns, options.time_limit)) {
      say("timed out: the calibration uses the views of the board taken so far");
      break;
    }
    printer.print(
        step.instruction, step.views[0] + step.views[1] + step.pairs,
        fmt::format("views of the board: {} and {} of {} by each camera, {} of {} by both", step.views[0],
                    step.views[1], recommended_views, step.pairs, recommended_stereo_pairs));
    std::this_thread::sleep_for(pair_poll_interval);
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
  print_lens_fit(first);
  print_lens_fit(second);
  say(fmt::format(
      "{} views by both cameras, {} of them rejected; error {:.3f} px in views not used for the "
      "fit; expected error of positions where the board was held: {:.2f} mm RMS",
      guide.pairs().size(), pair.first_second.left_out.size(), pair.held_out, 1e3 * pair.expected_error));
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
  say(fmt::format("camera {} ({}): measuring its image quality for {:g} s; keep a board at rest in view",
                  options.camera, camera->identity(), options.seconds));
  const std::int64_t begin_ns = monotonic_ns();
  while (static_cast<double>(monotonic_ns() - begin_ns) * 1e-9 < options.seconds)
    if (const auto frame = camera->next(image_timeout)) report.take(*frame, monotonic_ns());
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
