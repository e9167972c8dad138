// prosector-fastrak-twin: a simulated Polhemus FASTRAK on a pseudo-terminal.
#include "twins/base/twin_program.h"
#include "twins/trackers/fastrak_twin.h"

int main(int argc, char** argv) {
  using namespace prosector;
  CLI::App app(
      "A simulated Polhemus FASTRAK on a pseudo-terminal. Its first output line is the terminal's path.",
      "prosector-fastrak-twin");
  TwinProgramOptions options;
  add_options(app, options);
  FastrakTwinOptions fastrak;
  std::vector<double> room = {0, 0, 0, 1, 0, 0, 0};
  app.add_option("--room-device", room, "x,y,z,qw,qx,qy,qz: pose of the transmitter in the room")
      ->expected(7)
      ->delimiter(',');
  std::vector<double> tip = {0, 0, 0}, metal = {0, 0, 0, 0, 0};
  app.add_option(
         "--tip", tip,
         "x,y,z: tip of an instrument in its receiver's frame, m; the script's poses are those of this point")
      ->expected(3)
      ->delimiter(',');
  app.add_option("--distortion", metal,
                 "x,y,z,mm,deg: position of a piece of metal in the transmitter's frame (x right, y up, m), "
                 "and the shift and rotation that it causes at a distance of 0.5 m")
      ->expected(5)
      ->delimiter(',');
  app.add_option("--noise-cm", fastrak.noise_cm, "standard deviation of positions")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--noise-deg", fastrak.noise_deg, "standard deviation of orientations")
      ->check(CLI::Range(0.0, 90.0));
  app.add_option("--baud", fastrak.baud,
                 "baud rate of the simulated serial line, which limits the rate of long records")
      ->check(CLI::Range(1200u, 921600u))
      ->capture_default_str();
  if (const auto status = parse(app, argc, argv)) return *status;
  return run_twin(options, [&](MotionScript script, std::int64_t now_ns) {
    fastrak.script = std::move(script);
    fastrak.room_device = {Vec3(room[0], room[1], room[2]),
                           Quat(room[3], room[4], room[5], room[6]).normalized()};
    fastrak.tip.p = Vec3(tip.data());
    fastrak.field.metal = Vec3(metal.data());
    fastrak.field.shift = 1e-3 * metal[3];
    fastrak.field.turn = metal[4] * M_PI / 180;
    fastrak.timing = options.timing;
    fastrak.seed = options.seed;
    return std::make_unique<FastrakTwin>(fastrak, now_ns);
  });
}
