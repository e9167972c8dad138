#pragma once
// Scene texts for the tests of the loader.

#include <string>

#include "common/error.h"
#include "common/scene/load_scene.h"

namespace prosector {

/// A scene with every table in it, where `line` stands as one more line of `table` ("" is the top level).
inline std::string scene_with(const std::string& table, const std::string& line) {
  struct Block {
    const char* table;  // null: no line goes here
    const char* text;
  };
  static constexpr Block blocks[] = {
      {"", "name = \"s\"\n"},
      {"[session]", "[session]\n"},
      {"[hand]", "[hand]\n"},
      {"[room]", "[room]\n"},
      {"[camera]", "[camera]\n"},
      {"[patient]", "[patient]\n"},
      {"[[rigid]]", "[[rigid]]\nname = \"r\"\nvolume = \"v.inr\"\n"},
      {"[[rigid.fracture]]", "[[rigid.fracture]]\n"},
      {"[[rigid.edge]]", "[[rigid.edge]]\n"},
      {"[[rigid.part]]", "[[rigid]]\nname = \"p\"\n[[rigid.part]]\n"},
      {"[[rigid.curve]]",
       "[[rigid]]\nname = \"c\"\n[[rigid.curve]]\npoints = [[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 0, 0], "
       "[4, 0, 0], [5, 2, 0], [6, 0, 0], [7, 0, 1], [8, 0, 0], [9, 0, 0]]\n"},
      {"[[rigid.patch]]", "[[rigid]]\nname = \"d\"\n[[rigid.patch]]\nkind = \"coons\"\n"},
      {"[[rigid.patch.side]]", "[[rigid.patch.side]]\nkind = \"bezier\"\npoints = [[0, 0, 0], [1, 0, 0]]\n"},
      {nullptr,
       "[[rigid.patch.side]]\nkind = \"bezier\"\npoints = [[0, 1, 0], [1, 1, 0]]\n"
       "[[rigid.patch.side]]\nkind = \"bezier\"\npoints = [[0, 0, 0], [0, 1, 0]]\n"
       "[[rigid.patch.side]]\nkind = \"bezier\"\npoints = [[1, 0, 0], [1, 1, 0]]\n"},
      {"[[soft]]", "[[soft]]\nname = \"t\"\nvolume = \"v.inr\"\n"},
      {"[[soft.curve]]",
       "[[soft]]\nname = \"u\"\nshape = \"rope\"\n[[soft.curve]]\npoints = [[0, 0, 0], [1, 0, 0], [2, 1, 0], "
       "[3, 0, 0], [4, 0, 0], [5, 2, 0], [6, 0, 0], [7, 0, 1], [8, 0, 0], [9, 0, 0]]\n"},
      {"[[soft.patch]]", "[[soft]]\nname = \"w\"\nshape = \"sheet\"\n[[soft.patch]]\nkind = \"coons\"\n"},
      {"[[soft.patch.side]]", "[[soft.patch.side]]\nkind = \"bezier\"\npoints = [[0, 0, 0], [1, 0, 0]]\n"},
      {nullptr,
       "[[soft.patch.side]]\nkind = \"bezier\"\npoints = [[0, 1, 0], [1, 1, 0]]\n"
       "[[soft.patch.side]]\nkind = \"bezier\"\npoints = [[0, 0, 0], [0, 1, 0]]\n"
       "[[soft.patch.side]]\nkind = \"bezier\"\npoints = [[1, 0, 0], [1, 1, 0]]\n"
       "[[soft]]\nname = \"x\"\nvolume = \"v.inr\"\n"},
      {"[[soft.attach]]", "[[soft.attach]]\n"},
      {"[[soft.region]]", "[[soft.region]]\n"},
      {"[[soft.relaxation]]", "[[soft.relaxation]]\n"},
      {"[[atlas]]", "[[atlas]]\nvolume = \"a.nii\"\n"},
      {"[[light]]", "[[light]]\n"},
  };
  std::string text;
  for (const Block& block : blocks) {
    text += block.text;
    if (block.table != nullptr && table == block.table) text += line + "\n";
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
