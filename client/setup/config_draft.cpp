#include "client/setup/config_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "common/error.h"

namespace prosector {
namespace {

/// Returns the file's text; empty if the file is missing.
std::string text_of(const std::filesystem::path& file) {
  return std::filesystem::exists(file) ? read_config_text(file) : "";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

}  // namespace

ConfigDraft::ConfigDraft(std::filesystem::path file) : file_(std::move(file)) {
  read();
}

void ConfigDraft::read() {
  saved_ = draft_ = problem_ = "";
  beside_.clear();
  config_ = {};
  try {
    saved_ = draft_ = text_of(file_);
    config_ = parse_client_config(draft_, file_.string());
  } catch (const InputError& error) {
    problem_ = error.what();
  }
}

std::string ConfigDraft::change(const std::vector<ConfigChange>& changes) {
  if (!problem_.empty()) return problem_;
  try {
    std::string text = write_client_config(draft_, changes, file_.string());
    config_ = parse_client_config(text, file_.string());
    draft_ = std::move(text);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string ConfigDraft::named(const std::string& file) const {
  const std::filesystem::path folder = file_.parent_path(), path = file;
  const auto below = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return file.empty() || below.first != folder.end() ? file : path.lexically_relative(folder).string();
}

void ConfigDraft::add_companion_file(const std::string& name, std::string text) {
  beside_[name] = std::move(text);
}

void ConfigDraft::save() {
  if (text_of(file_) != saved_)
    throw InputError(
        fmt::format("{} was changed by another program: discard your changes to reload it", file_.string()));
  std::error_code error;
  std::filesystem::create_directories(file_.parent_path(), error);
  for (const auto& [name, text] : beside_) save_config_text(file_.parent_path() / name, text);
  beside_.clear();
  if (draft_ != saved_) save_config_text(file_, draft_);
  saved_ = draft_;
}

void ConfigDraft::revert() {
  read();
}

/// Returns the changed lines. Lines keep their order, so equal lines are skipped.
std::vector<ChangedLine> ConfigDraft::changes() const {
  const std::vector<std::string> before = lines_of(saved_), after = lines_of(draft_);
  std::vector<ChangedLine> out;
  for (const auto& [name, text] : beside_) out.push_back({"", "the file " + name + " beside it"});
  std::size_t b = 0, a = 0;
  while (b < before.size() || a < after.size()) {
    if (b < before.size() && a < after.size() && before[b] == after[a]) {
      ++b, ++a;
      continue;
    }
    const auto later = [&](const std::vector<std::string>& lines, std::size_t from, const std::string& line) {
      return std::find(lines.begin() + static_cast<std::ptrdiff_t>(from), lines.end(), line) != lines.end();
    };
    if (a < after.size() && (b >= before.size() || later(after, a, before[b]))) {
      out.push_back({"", after[a++]});
    } else if (a >= after.size() || later(before, b, after[a])) {
      out.push_back({before[b++], ""});
    } else {
      out.push_back({before[b++], after[a++]});
    }
  }
  return out;
}

}  // namespace prosector
