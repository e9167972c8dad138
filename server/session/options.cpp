#include "server/session/options.h"

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

std::optional<int> parse_options(int argc, char** argv, ServerOptions& o) {
  CLI::App app{
      "prosector-server: hosts a session on a scene. People join it with prosector-client.\n\n"
      "  prosector-server deploy/scenes/abdomen.toml               this machine only\n"
      "  prosector-server deploy/scenes/abdomen.toml --lan         the local network too\n"};
  app.set_version_flag("--version",
                       version_line("prosector-server") + ", protocol " + std::to_string(protocol_version));
  auto* scene = app.add_option("SCENE", o.scene, "Scene file (TOML; docs/look-up/scene.md)")->type_name("");

  const char* run = "Session";
  app.add_option("--session", o.session, "Name that clients join by; default: the scene's")
      ->type_name("NAME")
      ->group(run);
  app.add_option("--seconds", o.seconds, "End after this long; default: Ctrl-C ends the session")
      ->check(CLI::PositiveNumber)
      ->type_name("S")
      ->group(run);
  app.add_option("--threads", o.threads, "Threads of the physics; 0: one a core. Results don't depend on it")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str()
      ->type_name("N")
      ->group(run);
  auto* summary =
      app.add_option("--summary", o.summary, "Write the run's figures to this file (JSON) at the end");
  summary->type_name("FILE")->group(run);
  auto* check =
      app.add_flag("--check", o.check, "Compile the scene, say what it models and at what cost, and end");
  check->group(run);

  auto* watch =
      app.add_flag("--watch", o.watch,
                   "Load the scene anew when it or a file that it names changes; people stay. What doesn't "
                   "load is told of, and the old scene goes on");
  watch->group(run);

  const char* record = "Journal";
  auto* journal =
      app.add_option("--journal", o.journal, "Record inputs, state hashes and checkpoints to this new file");
  journal->type_name("FILE")->group(record);
  app.add_option("--journal-mb", o.journal_mb, "Stop journalling at this size; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->type_name("MB")
      ->group(record);
  auto* replay = app.add_option("--replay", o.replay, "Run a journal again and compare every state hash");
  auto* resume = app.add_option("--resume", o.resume, "Go on where a journal ends, in the same file");
  auto* play =
      app.add_option("--play", o.play, "Show a journal's session to whoever joins: they seek, stop, step");
  watch->excludes(journal)->excludes(replay)->excludes(resume)->excludes(play);  // one scene per journal
  play->type_name("FILE")->group(record)->excludes(journal)->excludes(replay)->excludes(resume)->excludes(
      scene);
  play->excludes(summary)->excludes(check);  // only for live sessions
  replay->type_name("FILE")->group(record)->excludes(journal)->excludes(resume)->excludes(scene);
  resume->type_name("FILE")->group(record)->excludes(journal)->excludes(scene);

  app.add_option(
         "--export-journal", o.export_journal,
         "Write a journal, also one that a server is writing or that a crash left, whole to one new file")
      ->expected(2)
      ->type_name("FROM TO")
      ->group(record)
      ->excludes(journal)
      ->excludes(play)
      ->excludes(replay)
      ->excludes(resume)
      ->excludes(scene);

  const char* network = "Network (default: this machine only)";
  std::string lan;
  auto* reach =
      app.add_option("--lan", lan,
                     "Reach the local network too; by this interface or address, for instance eth0, "
                     "where there are several");
  reach->expected(0, 1)->type_name("[IFACE]")->group(network);
  app.add_option(
         "--profile", o.profile,
         "Network profile: loopback, lan, wan, or a file; lan and wan go with --lan (docs/do/network.md)")
      ->type_name("PROFILE")
      ->group(network);
  app.add_option("--domain", o.domain, "DDS domain")
      ->check(CLI::Range(0, 230))
      ->capture_default_str()
      ->type_name("N")
      ->group(network);
  app.add_option("--index", o.index,
                 "Server index on this host, which fixes the port; default: the first free")
      ->check(CLI::Range(0, 9))
      ->type_name("0..9")
      ->group(network);

  const char* files = "Files";
  app.add_option("--data", o.data,
                 "Where files that the scene names are looked up, after its own folder; default: " +
                     default_data_dir().string())
      ->type_name("DIR")
      ->group(files);
  o.cache = default_cache_dir();
  app.add_option("--cache", o.cache, "Compiled meshes, by content; may be deleted at any time")
      ->capture_default_str()
      ->type_name("DIR")
      ->group(files);

  try {
    app.parse(argc, argv);
    if (o.scene.empty() && o.play.empty() && o.replay.empty() && o.resume.empty() && o.export_journal.empty())
      throw CLI::RequiredError("SCENE (or --play, --replay, --resume or --export-journal)");
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  if (reach->count() > 0) o.interface = lan;
  if (o.data.empty()) o.data.push_back(default_data_dir());
  return std::nullopt;
}

}  // namespace prosector
