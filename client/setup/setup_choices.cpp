#include "client/setup/setup_choices.h"

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "common/error.h"
#include "common/regular_file.h"
#include "common/toml_nesting.h"

namespace prosector {
namespace {

constexpr std::size_t most_bytes = 65536;
constexpr const char* in_headset = "openxr";  // needs no monitor

}  // namespace

std::vector<std::string> DisplaySettings::words() const {
  const DisplaySettings usual;
  std::vector<std::string> out;
  if (display != usual.display) out.insert(out.end(), {"--display", display});
  if (monitor >= 0 && display != in_headset) out.insert(out.end(), {"--monitor", std::to_string(monitor)});
  if (quality.empty())
    out.insert(out.end(), {"--frame-time", "33"});
  else if (quality != usual.quality)
    out.insert(out.end(), {"--quality", quality});
  return out;
}

SetupChoices recall(const std::filesystem::path& file) {
  SetupChoices out;
  try {
    const std::string text = read_regular_file(file, most_bytes);
    check_nesting(text, file.string());
    const toml::table table = toml::parse(text, file.string());
    out.name = table["name"].value_or(std::string());
    out.watches = table["watches"].value_or(false);
    out.lan = table["lan"].value_or(false);
    out.scene = table["scene"].value_or(std::string());
    out.seen.display = table["display"].value_or(out.seen.display);
    out.seen.quality = table["quality"].value_or(out.seen.quality);
    out.seen.monitor = table["monitor"].value_or(out.seen.monitor);
    if (const toml::array* entered = table["entered"].as_array())
      for (const toml::node& node : *entered)
        if (const auto session = node.value<std::string>();
            session && out.entered.size() < max_recent_sessions)
          out.entered.push_back(*session);
  } catch (const InputError&) {
  } catch (const toml::parse_error&) {
  }
  return out;
}

void remember(const SetupChoices& memory, const std::filesystem::path& file) {
  toml::array entered;
  for (const std::string& session : memory.entered) entered.push_back(session);
  const toml::table table{{"name", memory.name},
                          {"watches", memory.watches},
                          {"lan", memory.lan},
                          {"scene", memory.scene.string()},
                          {"display", memory.seen.display},
                          {"quality", memory.seen.quality},
                          {"monitor", memory.seen.monitor},
                          {"entered", entered}};
  std::ostringstream text;
  text << "# The choices last made in Prosector's set-up window.\n" << table << "\n";
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  std::filesystem::path fresh = file;
  fresh += ".new";
  std::ofstream out(fresh);
  out << text.str();
  out.close();
  if (out) std::filesystem::rename(fresh, file, error);
  if (!out || error) throw InputError(file.string() + ": cannot be written");
}

void add_recent_session(SetupChoices& memory, const std::string& session) {
  std::erase(memory.entered, session);
  memory.entered.insert(memory.entered.begin(), session);
  if (memory.entered.size() > max_recent_sessions) memory.entered.resize(max_recent_sessions);
}

}  // namespace prosector
