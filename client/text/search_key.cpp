#include "client/text/search_key.h"

#include <hb.h>

#include <algorithm>
#include <clocale>
#include <cwctype>
#include <map>
#include <memory>
#include <type_traits>

#include "client/text/utf8.h"

namespace prosector {
namespace {

/// Returns the lower-case letter by the rules of all scripts, independent of the user's locale.
std::wint_t lower(std::wint_t character) {
  static const std::unique_ptr<std::remove_pointer_t<locale_t>, void (*)(locale_t)> rules(
      newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr), [](locale_t l) {
        if (l != nullptr) freelocale(l);
      });
  return rules ? towlower_l(character, rules.get()) : std::towlower(character);
}

/// Returns the search form of letters without a decomposition; empty: the letter itself.
std::u32string_view plain(char32_t letter) {
  static const std::map<char32_t, std::u32string_view> letters = {
      {U'ß', U"ss"}, {U'æ', U"ae"}, {U'œ', U"oe"}, {U'ø', U"o"}, {U'đ', U"d"},
      {U'ð', U"d"},  {U'þ', U"th"}, {U'ł', U"l"},  {U'ı', U"i"}, {U'ς', U"σ"}};
  const auto found = letters.find(letter);
  return found == letters.end() ? std::u32string_view() : found->second;
}

void add_folded(std::u32string& out, char32_t character) {
  hb_unicode_funcs_t* const unicode = hb_unicode_funcs_get_default();
  hb_codepoint_t first = 0, second = 0;
  if (hb_unicode_decompose(unicode, character, &first, &second) != 0) {
    add_folded(out, first);
    if (second != 0) add_folded(out, second);
    return;
  }
  if (hb_unicode_combining_class(unicode, character) != HB_UNICODE_COMBINING_CLASS_NOT_REORDERED) return;
  const auto small = static_cast<char32_t>(lower(static_cast<std::wint_t>(character)));
  const std::u32string_view letters = plain(small);
  if (letters.empty()) out.push_back(small);
  out.append(letters);
}

}  // namespace

std::u32string search_key(std::string_view utf8) {
  std::u32string out;
  for (const char32_t character : characters_of(utf8)) {
    const bool blank = character == U' ' || character == U'\t' || character == U'\n' || character == 0xA0;
    if (!blank)
      add_folded(out, character);
    else if (!out.empty() && out.back() != U' ')
      out.push_back(U' ');
  }
  if (!out.empty() && out.back() == U' ') out.pop_back();
  return out;
}

bool is_found(std::u32string_view key, std::u32string_view searched) {
  while (!searched.empty()) {
    const std::size_t end = std::min(searched.find(U' '), searched.size());
    if (key.find(searched.substr(0, end)) == std::u32string_view::npos) return false;
    searched.remove_prefix(std::min(end + 1, searched.size()));
  }
  return true;
}

}  // namespace prosector
