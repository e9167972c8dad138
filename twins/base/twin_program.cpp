#include "twins/base/twin_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <iostream>

#include "common/clock.h"
#include "common/error.h"
#include "common/version.h"

namespace prosector {
namespace {

std::atomic<bool> stop_requested = false;  // the only state that the signal handler accesses
static_assert(std::atomic<bool>::is_always_lock_free);

void request_stop(int) {
  stop_requested = true;
}

}  // namespace

std::optional<FaultSpan> from_to(const std::vector<double>& v) {
  return v.size() == 2 ? std::optional(FaultSpan{v[0], v[1]}) : std::nullopt;
}

namespace {

std::optional<FaultSpan> at_for(const std::vector<double>& v) {
  return v.size() == 2 ? std::optional(FaultSpan{v[0], v[0] + v[1]}) : std::nullopt;
}

}  // namespace

void add_options(CLI::App& app, TwinProgramOptions& o) {
  app.set_version_flag("--version", version_line(app.get_name()));
  app.add_option("--script", o.script,
                 "CSV script of the motion, with keyframes time,station,x,y,z,qw,qx,qy,qz,thumb,...,little");
  app.add_flag("--wait-client", o.timing.wait_client,
               "start the script when a client starts streaming (default: immediately)");
  app.add_flag("--loop", o.timing.loop, "repeat the script");
  app.add_option(
         "--hold", o.timing.holds,
         "T,T,...: script times, s, at which the script pauses until a line is read from standard input")
      ->delimiter(',')
      ->check(CLI::NonNegativeNumber);
  app.add_option(
      "--link", o.server.link,
      "path of a symbolic link to create to the pseudo-terminal; it is updated when the terminal changes");
  app.add_option("--log", o.server.log,
                 "write the sent records to this CSV file: time_ns,station,record,values");
  app.add_option("--seed", o.seed, "seed of the random noise and faults")->capture_default_str();
  app.add_option("--garbage", o.server.garbage,
                 "probability that random bytes are sent before a record, from 0 to 1")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--silence", o.silence, "FROM,TO: send nothing between these times, s")
      ->expected(2)
      ->delimiter(',');
  app.add_option("--unplug", o.unplug, "AT,FOR: disconnect at this time for this duration, s")
      ->expected(2)
      ->delimiter(',');
  app.add_option("--babble", o.babble, "FROM,TO: send only random bytes between these times, s")
      ->expected(2)
      ->delimiter(',');
}

std::optional<int> parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return std::nullopt;
}

int run_twin(TwinProgramOptions& o,
             const std::function<std::unique_ptr<Twin>(MotionScript, std::int64_t now_ns)>& make) try {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  o.server.silence = from_to(o.silence);
  o.server.babble = from_to(o.babble);
  o.server.unplug = at_for(o.unplug);
  o.server.seed = o.seed;
  o.server.reads_stdin_lines = !o.timing.holds.empty();
  if (!std::is_sorted(o.timing.holds.begin(), o.timing.holds.end()))
    throw InputError("--hold: times must rise");
  const auto twin = make(o.script.empty() ? MotionScript() : MotionScript::load(o.script), monotonic_ns());
  serve_twin(*twin, o.server, stop_requested,
             [&](const std::string& path) { std::cout << o.address << path << std::endl; });
  return 0;
} catch (const InputError& e) {
  std::cerr << e.what() << '\n';
  return 2;
}

}  // namespace prosector
