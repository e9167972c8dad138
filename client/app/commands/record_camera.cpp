#include "client/app/commands/record_camera.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <fstream>

#include "client/app/output/recorder.h"
#include "common/clock.h"
#include "common/error.h"
#include "drivers/camera/base/camera_calibration.h"
#include "twins/camera/synthetic_scene.h"

namespace prosector {
namespace {

constexpr double film_rate = 30;  // images/s, frame rate of recordings of live cameras
constexpr std::string_view synthetic_prefix = "synthetic:";

std::ofstream open_beside(const std::filesystem::path& film, const char* ending) {
  std::filesystem::path file = film;
  std::ofstream out(file.replace_extension(ending));
  if (!out) throw InputError(fmt::format("{}: cannot be written", file.string()));
  return out;
}

/// Appends an image. Throws InputError if the recording failed, for instance because the disk is full.
void add_to(Recorder& film, const Image& image) {
  film.add(image);
  if (!film.failure().empty()) throw InputError(film.failure());
}

void write_place(std::ofstream& out, double seconds, const std::string& name, const Pose& room) {
  out << fmt::format("{:.6f},{},{:.6f},{:.6f},{:.6f},{:.7f},{:.7f},{:.7f},{:.7f}\n", seconds, name,
                     room.p.x(), room.p.y(), room.p.z(), room.q.w(), room.q.x(), room.q.y(), room.q.z());
}

void record_synthetic(const SyntheticScene& scene, const CameraCommandOptions& options) {
  const SceneRenderer painter(scene);
  Recorder film(options.out, scene.lens.width, scene.lens.height, scene.rate);
  open_beside(options.out, ".toml") << write_calibration(
      {.camera = options.out.string(), .lens = scene.lens, .response = scene.sensor.response});
  std::ofstream truth = open_beside(options.out, ".csv");
  truth << "time,thing,x,y,z,qw,qx,qy,qz\n";
  const auto pictures = static_cast<std::uint64_t>(std::ceil(options.seconds * scene.rate));
  for (std::uint64_t number = 0; number < pictures; ++number) {
    add_to(film, painter.paint(number));
    const SyntheticTruth now = scene.truth(scene.seconds_of(number));
    write_place(truth, now.seconds, "camera", now.room_camera);
    for (std::size_t k = 0; k < now.room_things.size(); ++k)
      write_place(truth, now.seconds, scene.carriers[k].name, now.room_things[k]);
  }
}

void record_live(const CameraCommandOptions& options) {
  constexpr std::chrono::milliseconds time_limit(500);
  const std::unique_ptr<Camera> camera = open_camera(options.camera);
  std::optional<Recorder> film;
  std::int64_t begin_ns = monotonic_ns();
  while (seconds_since(begin_ns) < options.seconds) {
    const std::optional<Frame> frame = camera->next(time_limit);
    if (!frame) continue;
    if (!film) {
      film.emplace(options.out, frame->image.width, frame->image.height, film_rate);
      begin_ns = monotonic_ns();
    }
    // A video has a fixed frame rate: an image is repeated until the next one arrives.
    const auto due = static_cast<std::size_t>(seconds_since(begin_ns) * film_rate) + 1;
    while (film->frames() < due) add_to(*film, frame->image);
  }
  if (!film) throw InputError(fmt::format("{}: delivered no image", options.camera));
}

}  // namespace

int record_camera(const CameraCommandOptions& options) {
  const bool is_synthetic = options.camera.starts_with(synthetic_prefix);
  if (is_synthetic)
    record_synthetic(SyntheticScene::load(options.camera.substr(synthetic_prefix.size())), options);
  else
    record_live(options);
  fmt::print(
      "{}: recorded {:g} s of video; the file can be used as a camera, e.g. with --camera or --tracker "
      "tags:FILE{}\n",
      options.out.string(), options.seconds,
      is_synthetic ? "; the lens calibration (.toml) and the true poses (.csv) are in files of the same name"
                   : "");
  return 0;
}

}  // namespace prosector
