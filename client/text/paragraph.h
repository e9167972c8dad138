#pragma once
// One paragraph: its text directions (Unicode Bidirectional Algorithm, FriBidi), and the glyphs of any of its
// lines (HarfBuzz). Private to client/text.

#include <string>
#include <vector>

#include "client/text/fonts.h"
#include "client/text/text_block.h"

namespace prosector {

enum class Direction : std::uint8_t { as_written, left_to_right, right_to_left };

class Paragraph {
 public:
  /// Analyses the characters of one paragraph, without '\n': their writing directions, scripts and fonts.
  /// `direction` is the base direction; as_written takes it from the first letter's script. The fonts must
  /// outlive the paragraph.
  Paragraph(Fonts& fonts, std::u32string characters, Direction direction = Direction::as_written);

  const std::u32string& characters() const { return characters_; }
  Direction direction() const;
  /// Returns a line with the glyphs of the paragraph's characters with indices from `first` to before `end`,
  /// in visual order.
  TextLine line(std::size_t first, std::size_t end) const;
  /// Returns the advance of each character if the paragraph is one unbroken line, em. The first character of
  /// a cluster (group of characters that is drawn as a unit) has the cluster's advance. The others have −1,
  /// since lines can't be broken before them.
  std::vector<double> advances() const;

 private:
  struct Run {
    std::size_t first, end;
  };
  std::vector<Run> runs_from_left(std::size_t first, std::size_t end) const;
  void shape(const Run& run, TextLine& line) const;
  void choose_fonts();
  void choose_scripts();

  Fonts* fonts_;
  std::u32string characters_;
  std::vector<std::uint32_t> types_;  // FriBidi character types
  std::vector<std::int8_t> levels_;   // embedding levels; odd: right to left
  std::vector<std::uint32_t> scripts_;
  std::vector<FontId> used_fonts_;
  std::uint32_t base_ = 0;  // FriBidi type of the paragraph
};

}  // namespace prosector
