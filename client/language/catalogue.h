#pragma once
// Translations of a program's texts. A text is looked up by its English form, which is in the source code and
// is used if there is no translation.

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace prosector {

/// Marks an English text that is translated elsewhere, for instance one of a table.
constexpr const char* msg(const char* english) {
  return english;
}

/// Translations by their English text.
using Translations = std::map<std::string, std::string, std::less<>>;

/// Parses the bytes of a .mo file, written by msgfmt, of either byte order. Throws InputError if they are
/// invalid.
Translations read_mo(std::string_view bytes);

/// Translations of one language. Copies share them. It is immutable, so threads may share it, too.
class Catalogue {
 public:
  /// Creates an English catalogue: texts stay unchanged.
  Catalogue() = default;
  explicit Catalogue(Translations translations)
      : translations_(std::make_shared<const Translations>(std::move(translations))) {}

  /// Returns the translation, or the text itself if there is none. The result is valid as long as the text
  /// and a catalogue with these translations.
  const char* tr(const char* english) const;
  std::string tr(const std::string& english) const { return tr(english.c_str()); }

  /// Translates a text and fills its fmt placeholders. If a translation's placeholders do not fit the values,
  /// the English text is used.
  template <class First, class... More>
  std::string tr(fmt::format_string<First, More...> english, First&& first, More&&... more) const {
    return fill(english, fmt::make_format_args(first, more...));
  }

 private:
  std::shared_ptr<const Translations> translations_;  // null: none

  std::string fill(fmt::string_view english, fmt::format_args values) const;
};

/// Returns the catalogue for a language tag, for instance that of "de" for "de-AT"; an English one if there
/// is none.
Catalogue catalogue_for(std::string_view tag);

}  // namespace prosector
