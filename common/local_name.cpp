#include "common/local_name.h"

#include <algorithm>

#include "common/session_messages.h"

namespace prosector {
namespace {

constexpr std::size_t max_subtag_length = 8;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Returns the tag in normalised form: lower case, with hyphens.
std::string normalised_tag(std::string_view tag) {
  std::string out(tag);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '_') c = '-';
  }
  return out;
}

}  // namespace

bool is_language_tag(std::string_view tag) {
  if (tag.empty() || tag.size() > max_language_length) return false;
  bool first = true;
  while (true) {
    const std::string_view part = tag.substr(0, tag.find('-'));
    const bool fits =
        !part.empty() && part.size() <= max_subtag_length &&
        std::ranges::all_of(part, [&](char c) { return is_letter(c) || (!first && c >= '0' && c <= '9'); });
    if (!fits) return false;
    if (part.size() == tag.size()) return true;
    tag.remove_prefix(part.size() + 1);
    first = false;
  }
}

std::string language_of_locale(std::string_view locale) {
  std::string tag(locale.substr(0, locale.find_first_of(".@")));
  std::ranges::replace(tag, '_', '-');
  return tag == "C" || tag == "POSIX" || !is_language_tag(tag) ? "" : tag;
}

const std::string& name_in(std::string_view tag, const std::string& name,
                           const std::vector<LocalName>& names) {
  for (std::string wanted = normalised_tag(tag); !wanted.empty();) {
    const auto found = std::ranges::find_if(
        names, [&](const LocalName& local) { return normalised_tag(local.language) == wanted; });
    if (found != names.end()) return found->name;
    const std::size_t last = wanted.rfind('-');
    wanted.resize(last == std::string::npos ? 0 : last);
  }
  return name;
}

}  // namespace prosector
