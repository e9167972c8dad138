#include "client/render/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>

#include "common/embedded_file.h"
#include "common/error.h"

namespace prosector {

extern const std::span<const EmbeddedFile> shipped_shaders;

namespace {

/// Returns the text of a shader in the folder, or of the embedded shader if the folder is empty; nullopt: it
/// can't be read.
std::optional<std::string> text_of(const std::filesystem::path& folder, const std::string& file) {
  if (folder.empty()) {
    const auto text = find_embedded(shipped_shaders, file);
    return text ? std::optional<std::string>(*text) : std::nullopt;
  }
  std::ifstream in(folder / file);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) return std::nullopt;
  return text.str();
}

/// Returns the FILE of a line `#include "FILE"`; nullopt for any other line.
std::optional<std::string> included_file(const std::string& line) {
  constexpr std::string_view directive = "#include \"";
  if (!line.starts_with(directive)) return std::nullopt;
  const std::size_t end = line.find('"', directive.size());
  return line.substr(directive.size(), end - directive.size());
}

/// A compiler message with its file index and line.
struct LogLine {
  std::size_t file;
  int line;
  std::string message;
};

std::optional<LogLine> parse_log_line(const std::string& text) {
  unsigned file = 0;
  int line = 0, message = 0;
  // First Mesa's "2:14(3): error: …", then NVIDIA's "2(14) : error …".
  for (const char* form : {"%u:%d(%*d): %n", "%u(%d) : %n"})
    if (std::sscanf(text.c_str(), form, &file, &line, &message) == 2 && message > 0)
      return LogLine{file, line, text.substr(static_cast<std::size_t>(message))};
  return std::nullopt;
}

void append_file(const std::filesystem::path& folder, const std::string& file, ShaderSource& source,
                 const std::string& included_from) {
  const std::filesystem::path path = folder / file;
  if (std::find(source.files.begin(), source.files.end(), path) != source.files.end())
    throw InputError(fmt::format("{}: shader {} is included twice", included_from, path.string()));
  const auto text = text_of(folder, file);
  if (!text) throw InputError(fmt::format("{}: cannot read shader {}", included_from, path.string()));
  const std::size_t number = source.files.size();
  source.files.push_back(path);
  source.text += fmt::format("#line 1 {}\n", number);

  std::istringstream in(*text);
  std::string line;
  for (int line_number = 1; std::getline(in, line); ++line_number) {
    if (const auto included = included_file(line)) {
      append_file(folder, *included, source, fmt::format("{}:{}", path.string(), line_number));
      source.text += fmt::format("#line {} {}\n", line_number + 1, number);
    } else {
      source.text += line + '\n';
    }
  }
}

}  // namespace

ShaderSource load_shader_source(const std::filesystem::path& folder, const std::string& file,
                                const std::vector<std::string>& defines) {
  ShaderSource source;
  source.text = "#version 330 core\n";
  for (const std::string& name : defines) source.text += fmt::format("#define {}\n", name);
  append_file(folder, file, source, "renderer");
  return source;
}

std::string readable_log(const std::string& log, const ShaderSource& source) {
  std::istringstream in(log);
  std::string out, line;
  while (std::getline(in, line)) {
    const auto parsed = parse_log_line(line);
    if (parsed && parsed->file < source.files.size())
      line = fmt::format("{}:{}: {}", source.files[parsed->file].string(), parsed->line, parsed->message);
    out += line + '\n';
  }
  return out;
}

}  // namespace prosector
