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

/// Paths and settings of the set-up window.
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

  /// Advances the running operations without waiting. May start an entry that waits for the hosted server.
  void poll();
  /// Sets whether the local network is searched for sessions, too.
  void search_lan(bool lan);
  /// Starts hosting a scene, and enters the session once it is open. Shows a message on failure.
  void host(const std::filesystem::path& scene, const std::string& session);
  void close_hosted();
  /// Adds a user's scene file. Returns its index among the scenes; nullopt: shows a message with the reason.
  std::optional<std::size_t> offer(const std::filesystem::path& scene);
  /// Requests entering a session.
  void enter(const std::string& session);
  /// Returns the command that enters a session.
  std::vector<std::string> entering(const std::string& session) const;
  /// Returns the command requested since the last call.
  std::optional<std::vector<std::string>> take_entry_command();
  /// Reports the end of an entered session: the client's exit code and last output.
  void report_exit(int status, const std::string& words);
  /// Shows a message until it is replaced.
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
