#include "client/setup/setup_session.h"

#include <utility>

#include "common/error.h"

namespace prosector {

SetupSession::SetupSession(SetupPaths places)
    : memory(recall(places.memory)),
      places_(std::move(places)),
      scenes_(places_.scenes, places_.cache),
      search_(where()) {}

/// Returns the network that is searched now.
BusConfig SetupSession::where() const {
  BusConfig out = places_.bus;
  if (memory.lan && out.profile.empty()) out.profile = "lan";
  return out;
}

void SetupSession::poll() {
  scenes_.poll();
  found_ = search_.result();
  if (!hosting_) return;
  hosting_->poll();
  if (hosting_->over()) {
    say(places_.words.tr("The session \"{}\" has ended: {}", hosting_->session(), hosting_->words()),
        enters_when_open_);
    hosting_.reset();
    enters_when_open_ = false;
  } else if (hosting_->open() && std::exchange(enters_when_open_, false)) {
    enter(hosting_->session());
  }
}

void SetupSession::search_lan(bool lan) {
  memory.lan = lan;
  search_.search(where());
}

void SetupSession::host(const std::filesystem::path& scene, const std::string& session) {
  BusConfig at = where();
  at.session = session;
  try {
    hosting_.reset();
    hosting_ = std::make_unique<Hosting>(scene, at);
    enters_when_open_ = true;
    memory.scene = scene;
    say(places_.words.tr("Opening \"{}\" …", session), false);
  } catch (const InputError& error) {
    say(error.what(), true);
  }
}

void SetupSession::close_hosted() {
  if (!hosting_) return;
  say(places_.words.tr("The session \"{}\" is closed.", hosting_->session()), false);
  hosting_.reset();
}

std::optional<std::size_t> SetupSession::offer(const std::filesystem::path& scene) {
  try {
    return scenes_.add(scene);
  } catch (const InputError& error) {
    say(error.what(), true);
    return std::nullopt;
  }
}

void SetupSession::enter(const std::string& session) {
  add_recent_session(memory, session);
  keep();
  entry_ = entering(session);
}

std::vector<std::string> SetupSession::entering(const std::string& session) const {
  const bool own = hosting_ && hosting_->session() == session;
  std::vector<std::string> out = {program_folder() / "prosector-client", memory.watches ? "observe" : "join",
                                  "--session", session};
  if (!memory.name.empty()) out.insert(out.end(), {"--name", memory.name});
  if (own && !memory.watches) out.push_back("--host");
  if (!places_.language.empty()) out.insert(out.end(), {"--language", places_.language});
  for (std::string& word : memory.seen.words()) out.push_back(std::move(word));
  for (std::string& word : network_words(where())) out.push_back(std::move(word));
  if (!memory.watches && std::filesystem::exists(places_.config))
    out.insert(out.end(), {"--config", places_.config});
  return out;
}

std::optional<std::vector<std::string>> SetupSession::take_entry_command() {
  return std::exchange(entry_, std::nullopt);
}

void SetupSession::report_exit(int status, const std::string& words) {
  if (status == 0)
    say(msg("You left the session."), false);
  else
    say(words.empty() ? places_.words.tr("The client exited with code {}.", status) : words, true);
  search_.search(where());
}

void SetupSession::say(std::string words, bool wrong) {
  said_ = {std::move(words), wrong};
}

/// Saves the choices for the next start.
void SetupSession::keep() {
  try {
    remember(memory, places_.memory);
  } catch (const InputError& error) {
    say(error.what(), true);
  }
}

}  // namespace prosector
