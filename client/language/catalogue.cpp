#include "client/language/catalogue.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "common/embedded_file.h"
#include "common/error.h"

namespace prosector {

extern const std::span<const EmbeddedFile> shipped_catalogues;

namespace {

constexpr std::uint32_t magic = 0x950412de;

/// Reads 32-bit numbers and texts of a .mo file with bounds checks.
class MoBytes {
 public:
  explicit MoBytes(std::string_view bytes) : bytes_(bytes) {
    if (number(0) == magic) return;
    is_swapped_ = true;
    if (number(0) != magic)
      throw InputError("the file is not a catalogue of translations (.mo): its first bytes are wrong");
  }

  std::uint32_t number(std::uint64_t at) const {
    const std::string_view four = part(at, 4);
    std::uint32_t out = 0;
    for (std::size_t k = 0; k < 4; ++k)
      out |= std::uint32_t{static_cast<unsigned char>(four[k])} << 8 * (is_swapped_ ? 3 - k : k);
    return out;
  }

  /// Returns the text whose length and offset are stored at `at`; the first one if it has several plural
  /// forms.
  std::string text(std::uint64_t at) const {
    const std::string_view all = part(number(at + 4), number(at));
    return std::string(all.substr(0, all.find('\0')));
  }

 private:
  std::string_view bytes_;
  bool is_swapped_ = false;

  std::string_view part(std::uint64_t at, std::uint64_t length) const {
    if (at > bytes_.size() || length > bytes_.size() - at)
      throw InputError("the catalogue of translations (.mo) is truncated: build it again");
    return bytes_.substr(at, length);
  }
};

}  // namespace

Translations read_mo(std::string_view bytes) {
  const MoBytes mo(bytes);
  const std::uint64_t count = mo.number(8), originals = mo.number(12), translations = mo.number(16);
  Translations out;
  for (std::uint64_t k = 0; k < count; ++k) {
    std::string english = mo.text(originals + 8 * k), translated = mo.text(translations + 8 * k);
    if (!english.empty() && !translated.empty()) out[std::move(english)] = std::move(translated);
  }
  return out;
}

const char* Catalogue::tr(const char* english) const {
  if (!translations_) return english;
  const auto found = translations_->find(std::string_view(english));
  return found == translations_->end() ? english : found->second.c_str();
}

std::string Catalogue::fill(fmt::string_view english, fmt::format_args values) const {
  if (translations_)
    if (const auto found = translations_->find(std::string_view(english.data(), english.size()));
        found != translations_->end())
      try {
        return fmt::vformat(found->second, values);
      } catch (const fmt::format_error&) {
        // Use the English text.
      }
  return fmt::vformat(english, values);
}

Catalogue catalogue_for(std::string_view tag) {
  std::string file(tag.substr(0, tag.find('-')));
  std::ranges::transform(file, file.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c; });
  const auto bytes = find_embedded(shipped_catalogues, file + ".mo");
  return bytes ? Catalogue(read_mo(*bytes)) : Catalogue();
}

}  // namespace prosector
