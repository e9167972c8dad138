#include "client/app/commands/config_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "common/error.h"
#include "drivers/config/client_config_write.h"

namespace prosector {

void add_config(CLI::App& app, ConfigOptions& o) {
  app.add_option("FILE", o.file, "Client configuration; checked if no other option is given")
      ->check(CLI::ExistingFile);
  app.add_option("--set", o.changes, "KEY=VALUE to change or add, e.g. eyes.distance=0.062 (repeatable)");
  app.add_flag("--write", o.write, "Write the file (default: print the result)");
  app.add_flag("--manual", o.manual,
               "Print the reference of all keys (docs/look-up/client-configuration.md)");
}

int run_config(const ConfigOptions& o) {
  if (o.manual) {
    fmt::print("{}", client_config_page());
    return 0;
  }
  if (o.file.empty()) throw InputError("config: give a file, or --manual");
  const std::string before = read_config_text(o.file);
  (void)parse_client_config(before, o.file.string());
  const std::vector<std::string> notes = migrate_client_config(before).notes;
  for (const std::string& note : notes)
    fmt::print(stderr, "{}: written by an older version: {}\n", o.file.string(), note);
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
