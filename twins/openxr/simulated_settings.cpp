#include "twins/openxr/simulated_settings.h"

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "common/former_option_name.h"

namespace prosector {
namespace {

void add_span(CLI::App& app, const std::string& name, Span& span, const std::string& help) {
  app.add_option_function<std::vector<double>>(
         name,
         [&span](const std::vector<double>& v) {
           span = {v[0], v[1]};
         },
         help)
      ->expected(2);
}

}  // namespace

SimulatedRuntimeSettings simulated_runtime_settings() {
  SimulatedRuntimeSettings out;
  const char* words = std::getenv("PROSECTOR_OPENXR");
  if (words == nullptr) return out;
  CLI::App app("", "PROSECTOR_OPENXR");
  app.add_option("--script", out.script, "CSV script of the motion of the headset's wearer");
  app.add_option("--waits-for", out.waits_for, "File; simulated time is paused while it does not exist");
  app.add_option("--pictures", out.pictures,
                 "Folder to write each eye's frames to, as left.ppm and right.ppm");
  app.add_option("--rate", out.rate, "Frames per second");
  app.add_option("--width", out.width, "Width of each eye's image, pixels");
  app.add_option("--height", out.height, "Height of each eye's image, pixels");
  app.add_flag("--controllers", out.controllers, "Simulate controllers instead of bare hands");
  app.add_flag("--held", out.held, "Simulate tracked hands that hold controllers");
  app.add_flag("--no-stage", out.no_stage, "Offer no stage space, so that the floor height is unknown");
  app.add_flag("--glx", out.glx, "Accept images by GLX only, not by EGL");
  add_span(app, "--unfocused", out.unfocused,
           "FROM,TO: another program has the input focus between these times, s");
  add_span(app, "--away", out.away, "FROM,TO: no runtime is available between these times, s");
  add_span(app, "--garbage", out.garbage, "FROM,TO: poses and angles are NaN between these times, s");
  app.add_option("--session-lost", out.session_lost, "Time at which the session is lost, s");
  app.add_option("--instance-lost", out.instance_lost, "Time at which the instance is lost, s");
  app.add_option("--frame-refused", out.frame_refused, "Time at which a submitted frame is rejected, s");
  CLI::Option* recentred = app.add_option("--recentred", out.recentre_time,
                                          "Time at which the stage's origin moves by 0.1 m to the right, s");
  accept_former_name(app, *recentred, "--centred-anew");
  app.add_option("--left", out.left,
                 "Time at which the wearer leaves the program and the session is stopped, s");
  try {
    app.parse(words, false);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return {};
  }
  return out;
}

}  // namespace prosector
