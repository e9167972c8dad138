// prosector-server: hosts a session on a scene.

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <new>

#include "common/error.h"
#include "common/process_limits.h"
#include "common/scene/load_scene.h"
#include "common/session_name.h"
#include "server/calibration/table_file.h"
#include "server/physics/base/freed_memory.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/session/journal/journal_reader.h"
#include "server/session/journal/replay.h"
#include "server/session/run/options.h"
#include "server/session/run/place.h"
#include "server/session/run/playback.h"
#include "server/session/run/remodeller.h"
#include "server/session/run/scene_reloader.h"
#include "server/session/run/server_loop.h"
#include "server/session/run/summary.h"

namespace prosector {
namespace {

std::atomic<bool> interrupted{false};  // the session ends
std::atomic<bool> over{false};         // the run ends: the session ends, or continues on another scene

/// Ends the session.
void end() {
  interrupted = true;
  over = true;
}

void say(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

CompileOptions sources(const ServerOptions& options) {
  CompileOptions compile;
  compile.threads = options.threads;
  compile.data_dirs = options.data;
  compile.cache_dir = options.cache;
  compile.progress = [](const std::string& line) { say("  " + line); };
  return compile;
}

/// Returns how rungs are chosen: by measurements on this machine.
ChoiceOptions choosing(const ServerOptions& options) {
  const auto meter = std::make_shared<RungMeter>();
  return {.table_file = options.cache / "rungs.json",
          .machine = machine_and_build(),
          .measure = [meter](const RungTrial& trial) { return meter->measure(trial); },
          .sources = sources(options)};
}

std::unique_ptr<Simulation> compile(const SceneDesc& scene, const ServerOptions& options) {
  say(fmt::format("compiling scene {} ({})", scene.name, scene.file.string()));
  return std::make_unique<Simulation>(scene, sources(options));
}

/// Compiles a scene with the rungs that were chosen for it.
ReadyScene ready(SceneDesc& scene, const std::vector<Choice>& choices, const ServerOptions& options) {
  adopt(choices, scene);
  return {choices, compile(scene, options)};
}

/// Prints what the scene models, and its cost.
void describe(const Simulation& simulation) {
  const SceneDesc& scene = simulation.scene();
  Eigen::Index nodes = 0;
  std::size_t triangles = 0;
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    triangles += simulation.surface(b).triangles.size();
    if (simulation.kind(b) == BodyKind::soft) nodes += simulation.soft(b).nodes();
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  say(fmt::format(
      "{}: {} rigid and {} soft bodies, {} tetrahedra on {} nodes, {} surface triangles, {} MB of memory",
      scene.name, scene.rigid.size(), scene.soft.size(), tet_count(simulation), nodes, triangles,
      usage.ru_maxrss / 1024));
  for (const SoftDesc& soft : scene.soft) say(fmt::format("  {}: {}", soft.name, soft::in_words(soft)));
  for (const std::string& hint : scene_hints(scene)) say("  " + hint);
}

void print_error(const JournalReader& journal) {
  if (!journal.error().empty()) say(journal.error());
}

/// Writes a whole journal as one file, and verifies that file tick by tick.
void export_journal(const std::vector<std::filesystem::path>& from_to) {
  const JournalReader from(from_to[0]);
  print_error(from);
  from.export_to(from_to[1]);
  const JournalReader exported(from_to[1]);
  std::uint64_t ticks = 0;
  exported.for_each_tick(exported.header().begins_at, [&](const JournalTick&) { return ++ticks, true; });
  const std::vector<std::uint64_t> checkpoints = exported.checkpoint_ticks();
  const auto damaged =
      std::ranges::count_if(checkpoints, [&](std::uint64_t t) { return !exported.checkpoint(t); });
  say(fmt::format("{}: {} ticks, {} checkpoints{}", from_to[1].string(), ticks, checkpoints.size(),
                  damaged > 0 ? fmt::format(", {} of them damaged", damaged) : ""));
}

/// Restores the state that the journal begins with.
void begin_as_recorded(const JournalReader& journal, Simulation& simulation) {
  require_same_scene(journal, simulation);
  if (!journal.header().beginning.empty()) simulation.restore(journal.header().beginning);
}

/// Compiles the scene that a journal recorded, in the state that it begins with.
std::unique_ptr<Simulation> compile_recorded(const JournalReader& journal, const ServerOptions& options) {
  print_error(journal);
  const JournalHeader& header = journal.header();
  SceneDesc scene = parse_scene(header.scene_text, header.scene_file);
  adopt(header.choices, scene);
  std::unique_ptr<Simulation> simulation = compile(scene, options);
  begin_as_recorded(journal, *simulation);
  return simulation;
}

int replay_journal(const ServerOptions& options) {
  const JournalReader journal(options.replay);
  const std::unique_ptr<Simulation> simulation = compile_recorded(journal, options);
  const std::uint64_t last = journal.last_tick();
  const ReplayResult result = replay(journal, *simulation, [&](std::uint64_t tick) {
    if (tick % 600 == 0) say(fmt::format("  tick {} of {}", tick, last));
  });
  if (!result) {
    say(fmt::format("DIFFERENT: the first tick whose state hash differs from the recorded one is {}",
                    *result.first_difference));
    if (const auto& value = result.differing_value)
      say(fmt::format("the first value that differs at the checkpoint of tick {} is: {}", value->tick,
                      value->name));
    return 1;
  }
  say(fmt::format("equal: {} ticks, state hash {}", result.ticks, to_hex(result.last_hash)));
  return 0;
}

/// Makes signals end the session cleanly. Before, while a scene is compiled, a signal ends the process
/// immediately.
void end_session_on_signals() {
  std::signal(SIGINT, [](int) { end(); });
  std::signal(SIGTERM, [](int) { end(); });
}

/// Plays a recorded session to the clients that join.
void play_journal(const ServerOptions& options) {
  const JournalReader journal(options.play);
  const std::string session = options.session.empty() ? journal.header().session : options.session;
  std::unique_ptr<HostConflictMonitor> watch = watch_for_others(options, session);
  const std::unique_ptr<Simulation> simulation = compile_recorded(journal, options);
  describe(*simulation);
  end_session_on_signals();
  BusConfig place;
  const std::unique_ptr<Bus> bus = open_bus(options, session, *watch, place);
  Playback playback({journal, *simulation}, *bus, session, say);
  std::optional<SessionInfo> rival;
  guard_place(*watch, playback.server_run(), [&](const SessionInfo& other) {
    rival = other;
    end();
  });
  say(how_to_watch(place));
  playback.run(over, options.seconds, say);
  watch.reset();
  if (rival) refuse_for(*rival, session);
}

/// Returns the first free file name that is numbered after `first`, in the same folder: "demo-2.journal".
std::filesystem::path next_journal(const std::filesystem::path& first) {
  for (int number = 2;; ++number) {
    std::filesystem::path next = first;
    next.replace_filename(fmt::format("{}-{}{}", first.stem().string(), number, first.extension().string()));
    if (!std::filesystem::exists(next)) return next;
  }
}

void resume_journal(const JournalReader& journal, Simulation& simulation) {
  print_error(journal);
  const ReplayResult result = resume(journal, simulation, say);
  if (!result)
    throw InputError(
        fmt::format("the journal cannot be resumed: replaying tick {} gives another state. Use the build "
                    "that recorded it",
                    *result.first_difference));
  say(fmt::format("resumed at tick {}, state hash {}", simulation.time().tick, to_hex(result.last_hash)));
}

/// Data of the hosted session that stay the same from run to run.
struct Hosting {
  const ServerOptions& options;
  std::string scene_text;
  std::string session;
};

/// Opens the journal that a run writes to, if any. A run that continues a remodelled session starts another
/// file, with the state that was taken over.
std::unique_ptr<Journal> open_journal(const Hosting& hosting, const ReadyScene& scene, bool continues) {
  const ServerOptions& options = hosting.options;
  Simulation& simulation = *scene.simulation;
  JournalLimits limits;
  limits.file_bytes = static_cast<std::uint64_t>(options.journal_mb * 1024 * 1024);
  if (!continues && !options.resume.empty()) return Journal::append_to(options.resume, limits);
  const std::filesystem::path first = options.resume.empty() ? options.journal : options.resume;
  if (first.empty()) return nullptr;
  JournalHeader header{simulation.scene().file, hosting.scene_text, hosting.session,
                       simulation.content_hash(), scene.choices};
  if (!continues) return Journal::create(first, header, limits);
  header.begins_at = simulation.time().tick;
  try {
    header.beginning = simulation.checkpoint();  // this run and a restored one begin alike
  } catch (const InputError& error) {
    say(
        fmt::format("internal error: the state cannot be saved; the session continues without a journal: {}. "
                    "Please report this.",
                    error.what()));
    return nullptr;
  }
  const std::filesystem::path file = next_journal(first);
  say(fmt::format("the journal continues in {}", file.string()));
  return Journal::create(file, header, limits);
}

/// Writes the figures of a run to the console, and to the requested file.
void sum_up(const ServerOptions& options, const ServerLoop& loop, const Simulation& simulation,
            const Journal* journal) {
  const RunFigures f = loop.figures();
  say(
      fmt::format("ended after {} ticks: x{:.3f} real time, step {:.1f} ms p50, {:.1f} p99, {} late ticks, "
                  "{} messages dropped, state hash {}",
                  f.ticks, f.real_time_factor, loop.meter().all().quantile(0.5),
                  loop.meter().all().quantile(0.99), f.late_ticks, f.invalid_dropped, to_hex(f.state_hash)));
  if (!options.summary.empty() &&
      !write_summary(options.summary, loop, simulation, journal ? journal->file() : std::filesystem::path()))
    throw std::runtime_error(fmt::format("--summary {}: cannot be written", options.summary.string()));
}

/// Runs a session on one scene, until `over`, or for `seconds` of wall time when above 0. `continues`:
/// continues with the state that was taken over from another model of the scene.
void serve(const Hosting& hosting, ReadyScene& scene, bool continues, Remodeller& remodeller,
           std::unique_ptr<HostConflictMonitor> watch, double seconds) {
  const ServerOptions& options = hosting.options;
  Simulation& simulation = *scene.simulation;
  BusConfig place;
  const std::unique_ptr<Bus> bus = open_bus(options, hosting.session, *watch, place);
  const std::unique_ptr<Journal> journal = open_journal(hosting, scene, continues);
  remodeller.begin(scene.choices);
  ServerLoop loop(simulation, *bus, hosting.session, journal.get(), say,
                  {.choices = scene.choices,
                   .reign = journal ? journal->reign() : first_reign,
                   .remodeller = &remodeller});
  std::optional<SessionInfo> rival;
  guard_place(*watch, loop.server_run(), [&](const SessionInfo& other) {
    rival = other;
    end();
  });
  say(how_to_join(place));
  loop.run(over, seconds, say);
  watch.reset();
  loop.finish();
  if (rival) refuse_for(*rival, hosting.session);
  sum_up(options, loop, simulation, journal.get());
}

/// Starts to reload the scene when its files change, if that is requested.
std::unique_ptr<SceneReloader> reload_on_change(const ServerOptions& options, const SceneDesc& scene) {
  if (!options.watch) return nullptr;
  const auto load = [&] {
    SceneDesc changed = parse_scene(read_scene_text(options.scene), options.scene);
    ReadyScene made = ready(changed, choose_rungs(changed, choosing(options)), options);
    describe(*made.simulation);
    return made;
  };
  return std::make_unique<SceneReloader>(
      scene, options.data, SceneReloader::Hooks{.load = load, .ready = [] { over = true; }, .say = say});
}

/// Creates the remodeller, which changes the models of bodies at the host's request.
std::unique_ptr<Remodeller> remodel_on_wish(const Hosting& hosting, const std::filesystem::path& file) {
  const ServerOptions& options = hosting.options;
  const auto described = [&options, &hosting, file] {
    return parse_scene(options.watch ? read_scene_text(file) : hosting.scene_text, file);
  };
  return std::make_unique<Remodeller>(
      Remodeller::Hooks{.describe = described,
                        .choosing = choosing(options),
                        .compile = [&options](const SceneDesc& scene) { return compile(scene, options); },
                        .ready = [] { over = true; },
                        .say = say});
}

/// Runs the session on one scene after the other, as the scene's files or the models of bodies change. To
/// clients each is a new run, as after a restart of the server: they rejoin automatically.
void serve_while_it_changes(const Hosting& hosting, ReadyScene scene,
                            std::unique_ptr<HostConflictMonitor> watch) {
  const ServerOptions& options = hosting.options;
  const auto started = std::chrono::steady_clock::now();
  const std::unique_ptr<SceneReloader> reloader = reload_on_change(options, scene.simulation->scene());
  const std::unique_ptr<Remodeller> remodeller = remodel_on_wish(hosting, scene.simulation->scene().file);
  bool continues = false;
  for (double left = options.seconds;;) {
    if (!watch) watch = watch_for_others(options, hosting.session);
    serve(hosting, scene, continues, *remodeller, std::move(watch), left);
    over = false;
    const double so_far = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    left = options.seconds - so_far;
    if (interrupted || (options.seconds > 0 && left <= 0)) return;
    left = std::max(left, 0.);
    continues = true;
    if (std::optional<ReadyScene> next = remodeller->take()) {
      if (const Refusal why = next->simulation->take_over(*scene.simulation))
        say(fmt::format("{}; the session continues unchanged", why.why()));
      else
        scene = std::move(*next);
    } else if (std::optional<ReadyScene> changed = reloader ? reloader->take() : std::nullopt) {
      scene = std::move(*changed);
    }
  }
}

/// Warns if compiled meshes can't be cached.
void warn_of_cache(const std::filesystem::path& cache) {
  std::error_code error;
  std::filesystem::create_directories(cache, error);
  if (error || access(cache.c_str(), W_OK | X_OK) != 0)
    say(
        fmt::format("cannot write the cache {}: meshes will be rebuilt at each start (choose another folder "
                    "with --cache DIR)",
                    cache.string()));
}

void host(const ServerOptions& options) {
  std::optional<JournalReader> past;
  if (!options.resume.empty()) past.emplace(options.resume);
  const std::string text = past ? past->header().scene_text : read_scene_text(options.scene);
  SceneDesc desc = parse_scene(text, past ? past->header().scene_file : options.scene);
  const std::string session = !options.session.empty() ? options.session
                              : past                   ? past->header().session
                                                       : desc.session.name;
  check_session_name(session);
  warn_of_cache(options.cache);
  std::unique_ptr<HostConflictMonitor> watch = options.check ? nullptr : watch_for_others(options, session);
  // A resumed session keeps its rungs, whatever this machine would choose.
  ReadyScene scene =
      ready(desc, past ? past->header().choices : choose_rungs(desc, choosing(options)), options);
  describe(*scene.simulation);
  if (past) begin_as_recorded(*past, *scene.simulation);
  if (past) resume_journal(*past, *scene.simulation);
  past.reset();
  if (options.check) return;

  end_session_on_signals();
  // A compiler or a browser must not delay steps, nor the journal's thread, which is as urgent. If raising
  // the priority is not permitted, that is no error.
  setpriority(PRIO_PROCESS, 0, -5);
  const Hosting hosting{options, text, session};
  serve_while_it_changes(hosting, std::move(scene), std::move(watch));
}

}  // namespace
}  // namespace prosector

int main(int argc, char** argv) {
  using namespace prosector;
  retain_freed_memory();
  ServerOptions options;
  if (const auto status = parse_options(argc, argv, options)) return *status;
  try {
    check_process_limits();
    if (!options.export_journal.empty()) return export_journal(options.export_journal), 0;
    if (!options.replay.empty()) return replay_journal(options);
    if (!options.play.empty()) return play_journal(options), 0;
    host(options);
    return 0;
  } catch (const InputError& e) {
    fmt::print(stderr, "prosector-server: {}\n", e.what());
    return 2;
  } catch (const InternalError& e) {
    fmt::print(stderr, "prosector-server: internal error: {}. Please report this.\n", e.what());
    return 1;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "prosector-server: out of memory, so the session ended\n");
    return 1;
  } catch (const std::exception& e) {
    fmt::print(stderr, "prosector-server: {}\n", e.what());
    return 1;
  }
}
