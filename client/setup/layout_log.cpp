#include "client/setup/layout_log.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

namespace prosector {

void LayoutLog::write(const Interface& ui, const std::string& words) {
  if (file_.empty()) return;
  nlohmann::json controls = nlohmann::json::object();
  for (const PlacedControl& c : ui.placed()) controls[c.name] = {c.left, c.top, c.right, c.bottom};
  std::string text = nlohmann::json{{"controls", controls}, {"words", words}}.dump();
  if (text == written_ || std::exchange(last_, text) != text) return;
  written_ = std::move(text);
  std::filesystem::path fresh = file_;
  fresh += ".new";
  std::ofstream(fresh) << written_ << "\n";
  std::error_code error;
  std::filesystem::rename(fresh, file_, error);
}

}  // namespace prosector
