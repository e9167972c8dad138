#include "client/render/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "common/error.h"

namespace prosector {
namespace {

void append_file(const std::filesystem::path& folder, const std::string& file, ShaderSource& source,
                 const std::string& included_from) {
  const std::filesystem::path path = folder / file;
  if (std::find(source.files.begin(), source.files.end(), path) != source.files.end())
    throw InputError(fmt::format("{}: shader {} is included twice", included_from, path.string()));
  std::ifstream in(path);
  if (!in) throw InputError(fmt::format("{}: cannot read shader {}", included_from, path.string()));
  const std::size_t number = source.files.size();
  source.files.push_back(path);
  source.text += fmt::format("#line 1 {}\n", number);

  static const std::regex include(R"re(^\s*#include\s+"([^"]+)"\s*$)re");
  std::string line;
  for (int line_number = 1; std::getline(in, line); ++line_number) {
    std::smatch match;
    if (std::regex_match(line, match, include)) {
      append_file(folder, match[1], source, fmt::format("{}:{}", path.string(), line_number));
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
  static const std::regex mesa(R"(^(\d+):(\d+)\(\d+\): (.*)$)");
  static const std::regex nvidia(R"(^(\d+)\((\d+)\) : (.*)$)");
  std::istringstream in(log);
  std::string out, line;
  while (std::getline(in, line)) {
    std::smatch match;
    if (std::regex_match(line, match, mesa) || std::regex_match(line, match, nvidia)) {
      const std::size_t file = std::stoul(match[1]);
      if (file < source.files.size())
        line = fmt::format("{}:{}: {}", source.files[file].string(), match[2].str(), match[3].str());
    }
    out += line + '\n';
  }
  return out;
}

}  // namespace prosector
