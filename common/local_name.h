#pragma once
// Names of bodies in several languages, and the choice of one for a reader.

#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// A name in one language; `language` is a tag such as "de" or "pt-BR" (BCP 47).
struct LocalName {
  std::string language;
  std::string name;
  bool operator==(const LocalName&) const = default;
};

/// Returns whether `tag` is a language tag: parts of 1 to 8 letters and digits joined by hyphens. The first
/// part has letters only. At most max_language_length bytes.
bool is_language_tag(std::string_view tag);

/// Returns the language tag of a locale name: "de-AT" for "de_AT.UTF-8@euro". Returns "" for "C", "POSIX" and
/// names without a language.
std::string language_of_locale(std::string_view locale);

/// Returns the name for a language tag: that of the tag itself, else of the longest matching prefix ("de-AT",
/// then "de"), else `name`. Ignores case and treats "_" as "-".
const std::string& name_in(std::string_view tag, const std::string& name,
                           const std::vector<LocalName>& names);

}  // namespace prosector
