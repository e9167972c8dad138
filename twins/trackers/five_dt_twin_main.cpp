// prosector-5dt-twin: a simulated 5DT data glove on a pseudo-terminal.
#include "twins/base/twin_program.h"
#include "twins/trackers/five_dt_twin.h"

int main(int argc, char** argv) {
  using namespace prosector;
  CLI::App app(
      "A simulated 5DT data glove on a pseudo-terminal. Its first output line is the terminal's path.",
      "prosector-5dt-twin");
  TwinProgramOptions options;
  add_options(app, options);
  FiveDtTwinOptions glove;
  std::size_t station = 1;
  app.add_flag("--hid", glove.hid, "send the Ultra's 64-byte USB reports instead of serial packets");
  app.add_flag("--wireless", glove.wireless, "send a wireless glove's 10-byte packets")->excludes("--hid");
  app.add_flag("--left", glove.left, "a left glove");
  app.add_option("--station", station, "number of the script's station whose flexions are used, from 1")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  app.add_option("--noise-counts", glove.noise_counts, "standard deviation of counts")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_option("--rate", glove.rate, "packets per second")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  if (const auto status = parse(app, argc, argv)) return *status;
  return run_twin(options, [&](MotionScript script, std::int64_t now_ns) {
    glove.script = std::move(script);
    glove.station = station - 1;
    glove.timing = options.timing;
    glove.seed = options.seed;
    return std::make_unique<FiveDtTwin>(glove, now_ns);
  });
}
