#pragma once
// Groups of command-line options that several commands of prosector-client share. Each function adds its
// options to a command; parsing the command line stores their values in `o`, `setup` or `raw`, which must
// live until then.

#include <CLI/CLI.hpp>

#include "client/app/run/options.h"
#include "client/app/run/raw_options.h"

namespace prosector {

/// Adds the options that select the session and the network on which it is searched.
void add_network(CLI::App& app, ClientOptions& o, RawOptions& raw);

/// Adds the options that publish poses and camera images to other software.
void add_offers(CLI::App& app, RawOptions& raw);

/// Adds the options for the display, the rendering quality, and recordings of the display.
void add_pictures(CLI::App& app, ClientOptions& o, RawOptions& raw);

/// Adds the options for the user's name and language, the duration, and measurement files.
void add_run(CLI::App& app, ClientOptions& o, RawOptions& raw);

/// Adds the options that name the user's devices.
void add_devices(CLI::App& app, RawOptions& raw);

/// Adds the options of the command `render`.
void add_render(CLI::App& app, RenderOptions& o, RawOptions& raw);

/// Adds the options of the set-up window.
void add_setup(CLI::App& app, SetupOptions& setup, ClientOptions& o, RawOptions& raw);

}  // namespace prosector
