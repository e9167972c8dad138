#pragma once
// Dimensions of the list of parts, points. Private to parts_list*.cpp.

namespace prosector::parts_list_measures {

inline constexpr double pad = 8, search_height = 24, reset_width = 56, hint_height = 24;
inline constexpr double line_height = 20, text_height = 11.5, least_text_height = 9.5;
inline constexpr double name_left = 26;                     // from the board's left
inline constexpr double swatch_left = 8, swatch_size = 12;  // of a row's colour swatch
inline constexpr double eye_from_right = 102, isolate_from_right = 80, slider_from_right = 58;
inline constexpr double slider_inset = 4, slider_length = 44;  // of the slider's track
inline constexpr double palette_left = 26, palette_step = 26;  // of the colour palette
inline constexpr double holder_width = 80;  // of the holders' names, next to the part's name

}  // namespace prosector::parts_list_measures
