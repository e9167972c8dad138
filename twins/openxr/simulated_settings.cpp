#include "twins/openxr/simulated_settings.h"

#include <CLI/CLI.hpp>
#include <cstdlib>

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
  app.add_option("--script", out.script, "CSV of the wearer's motion");
  app.add_option("--waits-for", out.waits_for, "Time is paused while this file does not exist");
  app.add_option("--pictures", out.pictures, "Folder for left.ppm and right.ppm");
  app.add_option("--rate", out.rate, "Frames per second");
  app.add_option("--width", out.width, "Size of an eye's image");
  app.add_option("--height", out.height, "Size of an eye's image");
  app.add_flag("--controllers", out.controllers, "Controllers instead of bare hands");
  app.add_flag("--held", out.held, "Controllers in bare hands");
  app.add_flag("--no-stage", out.no_stage, "The floor height is unknown");
  app.add_flag("--glx", out.glx, "Images by GLX, not by EGL");
  add_span(app, "--unfocused", out.unfocused, "Another program has the hands");
  add_span(app, "--away", out.away, "No runtime is available");
  add_span(app, "--garbage", out.garbage, "Poses and angles are no numbers");
  app.add_option("--session-lost", out.session_lost, "Time at which the session is lost");
  app.add_option("--instance-lost", out.instance_lost, "Time at which the instance is lost");
  app.add_option("--frame-refused", out.frame_refused, "Time at which a frame is rejected");
  app.add_option("--centred-anew", out.recentre_time, "Time at which the stage moves by 0.1 m to the right");
  app.add_option("--left", out.left, "Time at which the wearer leaves the program");
  try {
    app.parse(words, false);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return {};
  }
  return out;
}

}  // namespace prosector
