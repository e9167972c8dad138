#include "server/session/run/options.h"

#include <CLI/CLI.hpp>

#include "common/paths.h"
#include "common/version.h"

namespace prosector {

BusConfig ServerOptions::bus() const {
  BusConfig config;
  config.end = BusEnd::server;
  config.session = session;
  config.domain = domain;
  config.profile = !profile.empty() ? profile : interface ? "lan" : "";
  config.interface = interface.value_or("");
  return config;
}

namespace {

/// Options of the session that some options of journals exclude.
struct RunOptions {
  CLI::Option *summary, *check, *watch;
};

/// Adds the options of the session: its name, duration, threads and summary, and whether the scene is only
/// checked, or reloaded when it changes.
RunOptions add_run_options(CLI::App& app, ServerOptions& o) {
  const char* run = "Session";
  app.add_option("--session", o.session, "Name by which clients find the session; default: the scene's name")
      ->type_name("NAME")
      ->group(run);
  app.add_option("--seconds", o.seconds, "End the session after this many seconds; default: run until Ctrl-C")
      ->check(CLI::PositiveNumber)
      ->type_name("S")
      ->group(run);
  app.add_option("--threads", o.threads, "Physics threads (0 = one per core). Does not affect results.")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str()
      ->type_name("N")
      ->group(run);
  auto* summary =
      app.add_option("--summary", o.summary, "Write a summary of the run to this file (JSON) at the end");
  summary->type_name("FILE")->group(run);
  auto* check =
      app.add_flag("--check", o.check, "Compile the scene, print its models and their cost, and exit");
  check->group(run);

  auto* watch =
      app.add_flag("--watch", o.watch,
                   "Reload the scene when it or a referenced file changes. Participants stay connected. If "
                   "loading fails, the error is printed and the old scene continues.");
  watch->group(run);
  return {summary, check, watch};
}

/// Adds the options that record, replay, continue, play back and copy journals, and declares which options
/// exclude each other. A journal contains its scene, so `scene` can't be given with one that is read.
void add_journal_options(CLI::App& app, ServerOptions& o, CLI::Option* scene, const RunOptions& run) {
  const char* record = "Journal";
  auto* journal =
      app.add_option("--journal", o.journal, "Record inputs, state hashes and checkpoints to this new file");
  journal->type_name("FILE")->group(record);
  app.add_option("--journal-mb", o.journal_mb, "Stop recording at this file size, MB (0 = no limit)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->type_name("MB")
      ->group(record);
  auto* replay = app.add_option("--replay", o.replay, "Replay a journal and check every recorded state hash");
  auto* resume =
      app.add_option("--resume", o.resume, "Continue a session from the end of a journal, in the same file");
  auto* play =
      app.add_option("--play", o.play, "Play back a journal for clients, who can seek, pause and step");
  run.watch->excludes(journal)->excludes(replay)->excludes(resume)->excludes(play);  // one scene per journal
  play->type_name("FILE")->group(record)->excludes(journal)->excludes(replay)->excludes(resume)->excludes(
      scene);
  play->excludes(run.summary)->excludes(run.check);  // only for live sessions
  replay->type_name("FILE")->group(record)->excludes(journal)->excludes(resume)->excludes(scene);
  resume->type_name("FILE")->group(record)->excludes(journal)->excludes(scene);

  app.add_option("--export-journal", o.export_journal,
                 "Copy the journal FROM to one new file TO; works for a journal in use or left by a crash")
      ->expected(2)
      ->type_name("FROM TO")
      ->group(record)
      ->excludes(journal)
      ->excludes(play)
      ->excludes(replay)
      ->excludes(resume)
      ->excludes(scene);
}

/// Adds the options of the network. Returns the option --lan, whose value is written to `lan`: the name of a
/// network interface, empty for the only one.
CLI::Option* add_network_options(CLI::App& app, ServerOptions& o, std::string& lan) {
  const char* network = "Network (default: this machine only)";
  auto* reach = app.add_option("--lan", lan,
                               "Also serve the local network; if there are several network interfaces, name "
                               "one or its address, e.g. eth0");
  reach->expected(0, 1)->type_name("[IFACE]")->group(network);
  app.add_option(
         "--profile", o.profile,
         "Network profile: loopback, lan, wan, or a file; use lan and wan with --lan (docs/do/network.md)")
      ->type_name("PROFILE")
      ->group(network);
  app.add_option("--domain", o.domain, "DDS domain")
      ->check(CLI::Range(0, 230))
      ->capture_default_str()
      ->type_name("N")
      ->group(network);
  app.add_option("--index", o.index,
                 "Server index on this host, which determines the port; default: the first free one")
      ->check(CLI::Range(0, 9))
      ->type_name("0..9")
      ->group(network);
  return reach;
}

/// Adds the options for the folders of data and of the cache, and sets the cache folder to its default.
void add_folder_options(CLI::App& app, ServerOptions& o) {
  const char* files = "Files";
  app.add_option(
         "--data", o.data,
         "Folder to search for files referenced by the scene, after the scene's own folder; default: " +
             default_data_dir().string())
      ->type_name("DIR")
      ->group(files);
  o.cache = default_cache_dir();
  app.add_option("--cache", o.cache, "Folder of the cache of compiled meshes; may be deleted at any time")
      ->capture_default_str()
      ->type_name("DIR")
      ->group(files);
}

}  // namespace

std::optional<int> parse_options(int argc, char** argv, ServerOptions& o) {
  CLI::App app{
      "prosector-server: hosts a session on a scene. Participants join it with prosector-client.\n\n  "
      "prosector-server deploy/scenes/abdomen.toml               this machine only\n  prosector-server "
      "deploy/scenes/abdomen.toml --lan         also the local network\n"};
  app.set_version_flag("--version",
                       version_line("prosector-server") + ", protocol " + std::to_string(protocol_version));
  auto* scene = app.add_option("SCENE", o.scene, "Scene file (TOML; docs/look-up/scene.md)")->type_name("");
  const RunOptions run = add_run_options(app, o);
  add_journal_options(app, o, scene, run);
  std::string lan;
  const CLI::Option* reach = add_network_options(app, o, lan);
  add_folder_options(app, o);
  try {
    app.parse(argc, argv);
    if (o.scene.empty() && o.play.empty() && o.replay.empty() && o.resume.empty() && o.export_journal.empty())
      throw CLI::RequiredError("SCENE (a scene file), or --play, --replay, --resume or --export-journal,");
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  if (reach->count() > 0) o.interface = lan;
  if (o.data.empty()) o.data.push_back(default_data_dir());
  return std::nullopt;
}

}  // namespace prosector
