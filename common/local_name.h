#pragma once
// Names in other languages than their author's, and which of them a reader is shown.

#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// A name in one language, which a tag such as "de" or "pt-BR" says (BCP 47).
struct LocalName {
  std::string language;
  std::string name;
  bool operator==(const LocalName&) const = default;
};

/// Tells whether `tag` is a language tag: letters and digits in parts of 1 to 8 that hyphens join, the first
/// of letters, at most max_language_length bytes.
bool is_language_tag(std::string_view tag);

/// Returns the language tag of a locale's name: "de-AT" of "de_AT.UTF-8@euro"; "" of "C", "POSIX" and what
/// names no language.
std::string language_of_locale(std::string_view locale);

/// Picks the name for a language tag: of the tag itself, else of each shorter beginning ("de-AT", "de"), else
/// `name`. Case does not matter, and "_" is as good as "-".
const std::string& name_in(std::string_view tag, const std::string& name,
                           const std::vector<LocalName>& names);

}  // namespace prosector
