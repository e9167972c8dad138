#pragma once
// The state shared by the set-up window's pages. Pages do not depend on each other.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/setup/hosted_server.h"
#include "client/setup/scene_list.h"
#include "client/setup/session_search.h"
#include "client/setup/setup_choices.h"
#include "client/setup/text_styles.h"

namespace prosector {

/// Files, folders, network and language with which the set-up window starts.
struct SetupPaths {
  BusConfig bus;                        // of participants; its profile applies while "lan" is not selected
  std::filesystem::path scenes, cache;  // folders
  std::filesystem::path memory;         // file of the last choices
  std::filesystem::path config;         // the client's configuration; may be missing
  std::string language = {};            // language tag for entered sessions; empty: that of the locale
  Catalogue words = {};                 // of the displayed messages
};

class SetupSession {
 public:
  explicit SetupSession(SetupPaths places);

  /// Advances the scene previews, the session search and the hosted server, without waiting. When a hosted
  /// server is ready, requests to enter its session if that was pending.
  void poll();
  /// Sets whether sessions are searched on the local network, too, not only on this machine.
  void search_lan(bool lan);
  /// Starts a server that hosts the scene under the name `session`, and enters the session once the server is
  /// ready. Shows a message on failure.
  void host(const std::filesystem::path& scene, const std::string& session);
  void close_hosted();
  /// Adds a user's scene file to the list of scenes, and returns its index there. If the file is not a scene,
  /// shows a message with the reason and returns nullopt.
  std::optional<std::size_t> offer(const std::filesystem::path& scene);
  /// Requests to enter a session, and saves it among the recently entered ones. take_entry_command() then
  /// returns the command to run.
  void enter(const std::string& session);
  /// Returns the command line that starts a client in the session, as a participant or observer, with the
  /// user's settings.
  std::vector<std::string> entering(const std::string& session) const;
  /// Returns the command line of the client to start, if entering a session was requested since the last
  /// call; otherwise nullopt.
  std::optional<std::vector<std::string>> take_entry_command();
  /// Shows a message on the end of an entered session. `status`: the client's exit code; `words`: its last
  /// output, which is shown as the reason of an error.
  void report_exit(int status, const std::string& words);
  /// Shows a message below the pages until another one replaces it. `wrong`: it is an error message.
  void say(std::string words, bool wrong);

  SetupChoices memory;
  const SearchResult& found() const { return found_; }
  const SceneList& scenes() const { return scenes_; }
  const Hosting* hosting() const { return hosting_.get(); }
  const Said& said() const { return said_; }

 private:
  SetupPaths places_;
  SceneList scenes_;
  SessionSearch search_;
  SearchResult found_;
  std::unique_ptr<Hosting> hosting_;
  bool enters_when_open_ = false;
  std::optional<std::vector<std::string>> entry_;
  Said said_;

  BusConfig where() const;
  void keep();
};

}  // namespace prosector
