#pragma once
// How the set-up window's pages write: headings, what is beside the point, what is wrong.

#include <string>

namespace prosector {

/// What a page says below, until it says something else.
struct Said {
  std::string words;
  bool wrong = false;  // of something that went wrong
};

void title(const std::string& words);
void wrapped(const std::string& words);
void quiet(const std::string& words);
void warning(const std::string& words);

}  // namespace prosector
