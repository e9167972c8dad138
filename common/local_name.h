#pragma once
// Names of bodies in several languages, and the choice of one for a reader.

#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// A body's name in one language; `language` is a tag such as "de" or "pt-BR" (BCP 47).
struct LocalName {
  std::string language;
  std::string name;
  bool operator==(const LocalName&) const = default;
};

/// Returns whether `tag` has the form of a language tag: parts of 1 to 8 letters and digits joined by
/// hyphens, of which the first has letters only. It has at most max_language_length bytes.
bool is_language_tag(std::string_view tag);

/// Returns the language tag of a locale name, such as "de-AT" for "de_AT.UTF-8@euro". Returns "" for "C",
/// "POSIX" and names without a language.
std::string language_of_locale(std::string_view locale);

/// Returns the entry of `names` for a language tag: that of the tag itself, or else of its longest prefix
/// that has one ("de-AT", then "de"). Returns `name` if there is none. Ignores case and treats "_" as "-".
const std::string& name_in(std::string_view tag, const std::string& name,
                           const std::vector<LocalName>& names);

}  // namespace prosector
