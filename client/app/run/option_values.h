#pragma once
// Interpretation of single command-line values. Each function throws InputError for an invalid text; its
// message names the option and the allowed values.

#include <string>
#include <string_view>

#include "client/app/run/options.h"
#include "client/app/run/raw_options.h"

namespace prosector {

/// Returns the names of all rendering effects, separated by `between`.
std::string effect_names(std::string_view between);

/// Parses the value of --size, WIDTHxHEIGHT in pixels, into `width` and `height`.
void parse_size(const std::string& text, int& width, int& height);

/// Parses the value of --display into `o`: the kind of display and, for stereo, the profile and its frame
/// size. Returns whether the display shows the scene over a camera's images.
bool parse_display(const std::string& text, DisplayOptions& o);

/// Returns the quality level chosen by --quality, --effect and --detail.
QualityLevel parse_quality(const RawOptions& raw);

/// Parses the value of --color-by: the quantity that colours soft bodies.
Shown parse_shown(const std::string& text);

/// Parses the value of --screenshot: FILE or FILE@SECONDS.
Screenshot parse_screenshot(const std::string& text);

/// Returns the language tag of --language, or that of the locale if `text` is empty.
std::string parse_language(const std::string& text);

/// Returns the login name of the program's user; "guest" if it is not known.
std::string login_name();

}  // namespace prosector
