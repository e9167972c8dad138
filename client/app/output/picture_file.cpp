#include "client/app/output/picture_file.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <fstream>
#include <optional>

namespace prosector {
namespace {

/// Reads the folder from the desktop's configuration with lines like XDG_PICTURES_DIR="$HOME/Pictures".
std::optional<std::filesystem::path> listed_folder(const std::filesystem::path& list,
                                                   const std::string& home) {
  constexpr std::string_view begin = "XDG_PICTURES_DIR=\"", own = "$HOME";
  std::ifstream file(list);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(begin) || !line.ends_with('"')) continue;
    std::string folder = line.substr(begin.size(), line.size() - begin.size() - 1);
    if (folder.starts_with(own)) folder = home + folder.substr(own.size());
    return folder;
  }
  return std::nullopt;
}

}  // namespace

std::filesystem::path pictures_folder(const std::function<std::string(const char*)>& variable) {
  const std::filesystem::path home = variable("HOME");
  std::filesystem::path settings = variable("XDG_CONFIG_HOME");
  if (settings.empty()) settings = home / ".config";
  const auto is_folder = [](const std::filesystem::path& path) {
    std::error_code ignored;
    return !path.empty() && std::filesystem::is_directory(path, ignored);
  };
  if (const std::filesystem::path own = variable("XDG_PICTURES_DIR"); is_folder(own)) return own;
  if (const auto listed = listed_folder(settings / "user-dirs.dirs", home.string());
      listed && is_folder(*listed))
    return *listed;
  if (!home.empty() && is_folder(home / "Pictures")) return home / "Pictures";
  return std::filesystem::current_path();
}

std::filesystem::path free_picture_file(const std::filesystem::path& folder,
                                        std::chrono::system_clock::time_point now, std::uint64_t tick) {
  const std::string name = fmt::format("prosector-{:%Y-%m-%d-%H%M%S}-tick-{}",
                                       fmt::localtime(std::chrono::system_clock::to_time_t(now)), tick);
  std::filesystem::path file = folder / (name + ".png");
  for (int n = 2; std::filesystem::exists(file); ++n) file = folder / fmt::format("{}-{}.png", name, n);
  return file;
}

}  // namespace prosector
