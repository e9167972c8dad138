#include "client/setup/pages.h"

#include <fmt/format.h>
#include <imgui.h>

#include "client/setup/text_styles.h"
#include "common/clock.h"

namespace prosector {
namespace {

/// Draws the tab of a page, and calls `draw` for the page itself if it is open. Returns whether it is open.
template <class Draw>
bool page_tab(Interface& ui, const ImVec2& padding, const char* name, const Draw& draw) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  const bool open = ImGui::BeginTabItem(fmt::format("{}###{}", ui.tr(name), name).c_str());
  ImGui::PopStyleVar();
  ui.note(name);
  if (open) {
    draw();
    ImGui::EndTabItem();
  }
  return open;
}

}  // namespace

void Pages::draw(Interface& ui) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::Begin("anteroom", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  const float line = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("page", {0, -line});
  draw_tabs(ui);
  ImGui::EndChild();
  if (said().wrong)
    warning(ui.tr(said().words));
  else
    quiet(ui.tr(said().words));
  ImGui::End();
}

/// Draws the tabs and the open page, and closes all other pages, so that they release their devices.
void Pages::draw_tabs(Interface& ui) {
  // Tabs have narrow padding, so that all labels fit at a large scale.
  const ImVec2 usual = ImGui::GetStyle().FramePadding, narrow = {0.6f * usual.x, usual.y};
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, narrow);
  const bool has_tabs = ImGui::BeginTabBar("pages");
  ImGui::PopStyleVar();
  if (!has_tabs) return;
  const auto page = [&](const char* name, const auto& draw) { return page_tab(ui, narrow, name, draw); };
  page(msg("Join"), [&] {
    enter_.draw(ui, room_);
    said_ = &room_.said();
  });
  const bool devices = page(msg("Devices"), [&] {
    devices_.draw(ui, draft_, monotonic_ns());
    said_ = &devices_.said();
  });
  if (!devices) devices_.close();
  for (const auto& [name, calibrate] :
       {std::pair{msg("Tracker"), &tracker_}, std::pair{msg("Glove"), &glove_}}) {
    const bool open = page(name, [&] {
      calibrate->draw(ui, draft_, monotonic_ns());
      said_ = &calibrate->said();
    });
    if (!open) calibrate->close();
  }
  const bool camera = page(msg("Camera"), [&] {
    camera_.draw(ui, draft_, monotonic_ns());
    said_ = &camera_.said();
  });
  if (!camera) camera_.close();
  const bool window = page(msg("Window"), [&] {
    window_.draw(ui, room_, draft_, monotonic_ns());
    said_ = &window_.said();
  });
  if (!window) window_.close();
  const bool pictures = page(msg("Pictures"), [&] {
    pictures_.draw(ui, room_, draft_);
    said_ = &pictures_.said();
  });
  if (!pictures) pictures_.close();
  page(msg("Checks"), [&] {
    checks_.draw(ui);
    said_ = &room_.said();
  });
  ImGui::EndTabBar();
}

std::optional<int> Pages::full_screen() const {
  const int monitor = room_.memory.seen.monitor;
  return pictures_.running() && monitor >= 0 ? std::optional(monitor) : std::nullopt;
}

}  // namespace prosector
