#pragma once
// Scene texts for the tests of the loader.

#include <string>

#include "common/error.h"
#include "common/scene/load_scene.h"

namespace prosector {

/// A scene with every table in it, where `line` stands as one more line of `table` ("" is the top level).
inline std::string scene_with(const std::string& table, const std::string& line) {
  struct Block {
    const char* table;
    const char* text;
  };
  static constexpr Block blocks[] = {
      {"", "name = \"s\"\n"},
      {"[session]", "[session]\n"},
      {"[hand]", "[hand]\n"},
      {"[camera]", "[camera]\n"},
      {"[[rigid]]", "[[rigid]]\nname = \"r\"\nvolume = \"v.inr\"\n"},
      {"[[rigid.fracture]]", "[[rigid.fracture]]\n"},
      {"[[rigid.edge]]", "[[rigid.edge]]\n"},
      {"[[rigid.part]]", "[[rigid]]\nname = \"p\"\n[[rigid.part]]\n"},
      {"[[soft]]", "[[soft]]\nname = \"t\"\nvolume = \"v.inr\"\n"},
      {"[[soft.attach]]", "[[soft.attach]]\n"},
      {"[[soft.region]]", "[[soft.region]]\n"},
      {"[[soft.relaxation]]", "[[soft.relaxation]]\n"},
      {"[[light]]", "[[light]]\n"},
  };
  std::string text;
  for (const Block& block : blocks) {
    text += block.text;
    if (table == block.table) text += line + "\n";
  }
  return text;
}

/// The loader's complaint; empty: it had none.
inline std::string complaint(const std::string& text) {
  try {
    parse_scene(text, "test.toml");
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

}  // namespace prosector
