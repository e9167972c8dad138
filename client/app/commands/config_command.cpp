#include "client/app/commands/config_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "common/error.h"
#include "drivers/config/client_config_write.h"

namespace prosector {

void add_config(CLI::App& app, ConfigOptions& o) {
  app.add_option("FILE", o.file, "Client configuration file; without other options it is only checked")
      ->check(CLI::ExistingFile);
  app.add_option("--set", o.changes, "Change or add a key, KEY=VALUE, e.g. eyes.distance=0.062 (repeatable)");
  app.add_flag("--write", o.write, "Write the changes to the file (default: only print the changed file)");
  app.add_flag("--manual", o.manual,
               "Print the reference of all configuration keys, as in docs/look-up/client-configuration.md");
}

int run_config(const ConfigOptions& o) {
  if (o.manual) {
    fmt::print("{}", client_config_page());
    return 0;
  }
  if (o.file.empty())
    throw InputError("config: give a file to check or change, or --manual for the reference of all keys");
  const std::string before = read_config_text(o.file);
  (void)parse_client_config(before, o.file.string());
  const std::vector<std::string> notes = migrate_client_config(before).notes;
  for (const std::string& note : notes)
    fmt::print(stderr, "{}: written by an older version of Prosector; converted: {}\n", o.file.string(),
               note);
  std::vector<ConfigChange> changes;
  for (const std::string& text : o.changes) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw InputError(fmt::format("--set {}: must be KEY=VALUE", text));
    changes.push_back(parse_config_change(text.substr(0, equals), text.substr(equals + 1)));
  }
  const std::string after = write_client_config(before, changes, o.file.string());
  if (o.write) {
    if (after != before) save_config_text(o.file, after);
    fmt::print("{} {}\n", after == before ? "nothing to change in" : "wrote", o.file.string());
  } else if (changes.empty() && notes.empty()) {
    fmt::print("{}: good\n", o.file.string());
  } else {
    fmt::print("{}", after);
  }
  return 0;
}

}  // namespace prosector
