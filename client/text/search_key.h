#pragma once
// Text as it is compared in a search: without case and without marks above and below letters.

#include <string>
#include <string_view>

namespace prosector {

/// Returns the characters of UTF-8 by which it is found: "Große Drüse" and "GROSSE DRUSE" have the same, so
/// have "sağ" and "sag". Letters are decomposed (Unicode, canonically), their marks left out, and upper and
/// lower case made one. Blanks at the ends are left out, several between words are one.
std::u32string search_key(std::string_view utf8);

/// Tells whether `key` has each word of `searched` somewhere; both are search keys. An empty search
/// finds all.
bool is_found(std::u32string_view key, std::u32string_view searched);

}  // namespace prosector
