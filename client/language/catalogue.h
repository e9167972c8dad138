#pragma once
// The words of a program in its user's language. A text is looked up by its English form, which stands in the
// source and is shown where no translation of it is known.

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace prosector {

/// Marks an English text that is looked up elsewhere, for instance one of a table.
constexpr const char* msg(const char* english) {
  return english;
}

/// Translations by their English text.
using Translations = std::map<std::string, std::string, std::less<>>;

/// Reads what msgfmt wrote: the bytes of a .mo file of either byte order. Throws InputError where they are
/// none.
Translations read_mo(std::string_view bytes);

/// A language's translations; copies share them. It never changes, so threads may share it, too.
class Catalogue {
 public:
  /// Makes it English: every text stays as it is.
  Catalogue() = default;
  explicit Catalogue(Translations translations)
      : translations_(std::make_shared<const Translations>(std::move(translations))) {}

  /// Returns the text in the language; what isn't known stays as it is. The result lives as long as the text
  /// and a catalogue with these translations.
  const char* tr(const char* english) const;
  std::string tr(const std::string& english) const { return tr(english.c_str()); }

  /// Fills a text's placeholders, those of fmt. A translation that the values do not fit is left for English.
  template <class First, class... More>
  std::string tr(fmt::format_string<First, More...> english, First&& first, More&&... more) const {
    return fill(english, fmt::make_format_args(first, more...));
  }

 private:
  std::shared_ptr<const Translations> translations_;  // null: none

  std::string fill(fmt::string_view english, fmt::format_args values) const;
};

/// Returns the catalogue for a language tag, for instance that of "de" for "de-AT"; English where there is
/// none.
Catalogue catalogue_for(std::string_view tag);

}  // namespace prosector
