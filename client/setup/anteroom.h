#pragma once
// What the pages of the set-up window show and change. No page knows another one.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/setup/anteroom_memory.h"
#include "client/setup/hosting.h"
#include "client/setup/scene_list.h"
#include "client/setup/session_search.h"
#include "client/setup/words.h"

namespace prosector {

/// Where the set-up window looks and keeps things.
struct AnteroomPlaces {
  BusConfig bus;                        // of who takes part; its profile is the one before "lan" is asked for
  std::filesystem::path scenes, cache;  // folders
  std::filesystem::path memory;         // file of what was chosen last
  std::filesystem::path config;         // the client's configuration; need not be there
  std::string language = {};            // tag for sessions that are entered; empty: the locale's
  Catalogue words = {};                 // of what is said
};

class Anteroom {
 public:
  explicit Anteroom(AnteroomPlaces places);

  /// Goes on with what is under way, without waiting. An entry that waits for one's own server may be due.
  void poll();
  /// Sets whether sessions on the local network are looked for, too.
  void look_on_lan(bool lan);
  /// Begins to host a scene, and to enter once it is open. Says so where it can't.
  void host(const std::filesystem::path& scene, const std::string& session);
  void close_hosted();
  /// Offers a scene file of somebody's own. Returns its place among the scenes; none: it says why not.
  std::optional<std::size_t> offer(const std::filesystem::path& scene);
  /// Asks to go into a session.
  void enter(const std::string& session);
  /// Returns the command that leads into a session.
  std::vector<std::string> entering(const std::string& session) const;
  /// Returns the command that was asked for since the last call.
  std::optional<std::vector<std::string>> take_entry();
  /// Says how an entry ended: its exit code and its last words.
  void came_back(int status, const std::string& words);
  /// Says something until something else is to be said.
  void say(std::string words, bool wrong);

  AnteroomMemory memory;
  const SearchResult& found() const { return found_; }
  const SceneList& scenes() const { return scenes_; }
  const Hosting* hosting() const { return hosting_.get(); }
  const Said& said() const { return said_; }

 private:
  AnteroomPlaces places_;
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
