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

/// Returns the English text unchanged, and marks it for xgettext, which extracts the texts to translate. For
/// texts that another place of the program translates with tr(), for instance those of a table.
constexpr const char* msg(const char* english) {
  return english;
}

/// Translations of one language: maps each English text to its translation.
using Translations = std::map<std::string, std::string, std::less<>>;

/// Parses the bytes of a .mo file (gettext's binary catalogue, written by msgfmt) of either byte order.
/// Throws InputError if they are invalid.
Translations read_mo(std::string_view bytes);

/// Translations of the program's texts into one language. Copies share their translations, which never
/// change, so threads may also share a catalogue.
class Catalogue {
 public:
  /// Creates an English catalogue, which returns each text unchanged.
  Catalogue() = default;
  explicit Catalogue(Translations translations)
      : translations_(std::make_shared<const Translations>(std::move(translations))) {}

  /// Returns the translation of the English text, or `english` itself if there is none. The result is valid
  /// as long as both `english` and this catalogue or a copy of it exist.
  const char* tr(const char* english) const;
  std::string tr(const std::string& english) const { return tr(english.c_str()); }

  /// Translates an English format string and fills its fmt placeholders with the values. If the placeholders
  /// of the translation do not fit the values, the English text is used.
  template <class First, class... More>
  std::string tr(fmt::format_string<First, More...> english, First&& first, More&&... more) const {
    return fill(english, fmt::make_format_args(first, more...));
  }

 private:
  std::shared_ptr<const Translations> translations_;  // null: none

  std::string fill(fmt::string_view english, fmt::format_args values) const;
};

/// Returns the program's catalogue for a language tag, chosen by the tag before its first '-': that of "de"
/// for "de-AT". If there is none, returns an English one.
Catalogue catalogue_for(std::string_view tag);

}  // namespace prosector
