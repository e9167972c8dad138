#include "client/setup/enter_page.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "client/setup/side_by_side.h"
#include "client/setup/text_styles.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr float picture_aspect = 16.f / 9;
constexpr int scenes_across = 3;

/// Returns why a session cannot be entered; empty: it can.
std::string refusal(const Interface& ui, const FoundSession& session) {
  if (!session.speaks_our_version())
    return ui.tr("The session uses protocol version {}, this program version {}. Install the same release.",
                 session.info.version, protocol_version);
  if (session.full())
    return ui.tr("Session full: {} participants, observers included.", session.info.capacity);
  return {};
}

/// Places the next control on the same line if its width fits, else on a new line.
void continue_line(float width) {
  const float gap = 2 * ImGui::GetStyle().ItemSpacing.x;
  const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + gap + width <= end) ImGui::SameLine(0, gap);
}

}  // namespace

void EnterPage::draw(Interface& ui, SetupSession& room) {
  draw_person(ui, room);
  draw_side_by_side(
      ui, 0.36, [&] { draw_sessions(ui, room); }, [&] { draw_scenes(ui, room); });
}

void EnterPage::draw_person(Interface& ui, SetupSession& room) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(ui.tr("Your name"));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(220 * static_cast<float>(ui.scale()));
  ImGui::InputText("##name", &room.memory.name);
  ui.note("name");
  ImGui::SameLine(0, 2 * ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::RadioButton(ui.tr("Participate"), !room.memory.watches)) room.memory.watches = false;
  ui.note("take part");
  ImGui::SameLine();
  if (ImGui::RadioButton(ui.tr("Observe"), room.memory.watches)) room.memory.watches = true;
  ui.note("watch");
  continue_line(14 * ImGui::GetFontSize());
  bool lan = room.memory.lan;
  if (ImGui::Checkbox(ui.tr("Search the local network"), &lan)) room.search_lan(lan);
  ui.note("lan");
}

void EnterPage::draw_sessions(Interface& ui, SetupSession& room) {
  const SearchResult& found = room.found();
  title(room.memory.lan ? ui.tr("Sessions on the local network") : ui.tr("Sessions on this machine"));
  if (!found.problem.empty())
    warning(found.problem);
  else if (found.rounds == 0)
    quiet(ui.tr("Searching …"));
  else if (found.sessions.empty())
    quiet(ui.tr("No sessions found. Choose a scene to host one."));
  const FoundSession* chosen = nullptr;
  for (const FoundSession& session : found.sessions) {
    const std::string& name = session.info.session;
    const std::string label = fmt::format(
        "{}  ·  {}  ·  {}###{}", name, session.info.scene,
        session.people.size() == 1 ? ui.tr("1 participant") : ui.tr("{} participants", session.people.size()),
        name);
    if (ImGui::Selectable(label.c_str(), name == session_)) session_ = name;
    ui.note("session " + name);
    if (name == session_) chosen = &session;
  }
  if (chosen == nullptr && !found.sessions.empty()) session_ = found.sessions.front().info.session;
  if (chosen != nullptr) draw_session(ui, room, *chosen);
  std::string before;
  for (const std::string& name : room.memory.entered)
    if (std::none_of(found.sessions.begin(), found.sessions.end(),
                     [&](const FoundSession& s) { return s.info.session == name; }))
      before += (before.empty() ? "" : ", ") + name;
  if (found.rounds > 0 && !before.empty()) quiet(ui.tr("Sessions joined before, not open now: {}", before));
}

void EnterPage::draw_session(Interface& ui, SetupSession& room, const FoundSession& session) {
  ImGui::Separator();
  const auto scene = std::find_if(room.scenes().scenes().begin(), room.scenes().scenes().end(),
                                  [&](const ListedScene& s) { return s.name == session.info.scene; });
  if (scene != room.scenes().scenes().end()) {
    const float width = ImGui::GetContentRegionAvail().x;
    if (void* texture = picture(ui, *scene)) ImGui::Image(texture, {width, width / picture_aspect});
    wrapped(scene->description);
  }
  std::string people;
  for (const std::string& person : session.people) people += (people.empty() ? "" : ", ") + person;
  wrapped(people.empty() ? ui.tr("No participants.") : ui.tr("Participants: {}.", people));
  if (const std::string why = refusal(ui, session); !why.empty()) {
    warning(why);
    return;
  }
  if (ImGui::Button(room.memory.watches ? ui.tr("Observe session") : ui.tr("Join"),
                    {ImGui::GetContentRegionAvail().x, 0}))
    room.enter(session.info.session);
  ui.note("enter");
  std::vector<std::string> command = room.entering(session.info.session);
  command.front() = std::filesystem::path(command.front()).filename();
  quiet(shell_line(command));
}

void EnterPage::draw_scenes(Interface& ui, SetupSession& room) {
  title(ui.tr("Host a session"));
  if (room.scenes().scenes().empty())
    quiet(
        ui.tr("No scenes found: they are installed with the server (prosector-server). Enter a file below, "
              "or choose a folder with --scenes."));
  const std::vector<ListedScene>& scenes = room.scenes().scenes();
  if (!scene_chosen_) {
    scene_chosen_ = true;
    const auto last = std::find_if(scenes.begin(), scenes.end(),
                                   [&](const ListedScene& s) { return s.file == room.memory.scene; });
    if (last != scenes.end()) scene_ = static_cast<std::size_t>(last - scenes.begin());
  }
  const float below = 2 * ImGui::GetFrameHeightWithSpacing() + 3 * ImGui::GetTextLineHeightWithSpacing();
  const float least = 10 * ImGui::GetTextLineHeightWithSpacing();  // for a page that scrolls
  ImGui::BeginChild("grid", {0, std::max(ImGui::GetContentRegionAvail().y - below, least)});
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width =
      std::floor((ImGui::GetContentRegionAvail().x - (scenes_across - 1) * gap) / scenes_across);
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    if (k % scenes_across != 0) ImGui::SameLine(0, gap);
    ImGui::BeginGroup();
    ImGui::PushID(static_cast<int>(k));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = std::floor(width / picture_aspect);
    if (ImGui::Selectable("##scene", k == scene_, ImGuiSelectableFlags_None,
                          {width, height + ImGui::GetTextLineHeightWithSpacing() + 4}))
      scene_ = k;
    ui.note("scene " + scenes[k].name);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low{at.x + 4, at.y + 4}, high{at.x + width - 4, at.y + height - 2};
    if (void* texture = picture(ui, scenes[k]))
      list.AddImage(texture, low, high);
    else
      list.AddRectFilled(low, high, IM_COL32(255, 255, 255, 16));
    list.AddText({at.x + 6, at.y + height + 2}, ImGui::GetColorU32(ImGuiCol_Text), scenes[k].name.c_str());
    ImGui::PopID();
    ImGui::EndGroup();
  }
  ImGui::EndChild();
  if (scene_ < scenes.size()) {
    wrapped(scenes[scene_].description);
    if (!scenes[scene_].problem.empty()) warning(scenes[scene_].problem);
  }
  draw_hosting(ui, room);
}

void EnterPage::draw_hosting(Interface& ui, SetupSession& room) {
  const std::vector<ListedScene>& scenes = room.scenes().scenes();
  if (const Hosting* hosting = room.hosting()) {
    wrapped(hosting->open() ? ui.tr("You are hosting \"{}\".", hosting->session())
                            : ui.tr("Opening \"{}\": {}", hosting->session(), hosting->words()));
    if (hosting->open()) {
      if (ImGui::Button(ui.tr("Join your session"))) room.enter(hosting->session());
      ui.note("enter own");
      ImGui::SameLine();
    }
    if (ImGui::Button(ui.tr("Close the session for everyone"))) room.close_hosted();
    ui.note("close");
    return;
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(ui.tr("Session name"));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(200 * static_cast<float>(ui.scale()));
  ImGui::InputText("##hosted", &hosted_name_);
  ui.note("hosted name");
  ImGui::SameLine();
  if (ImGui::Button(ui.tr("Host and join")) && scene_ < scenes.size())
    room.host(scenes[scene_].file, hosted_name_);
  ui.note("host");
  continue_line(14 * ImGui::GetFontSize());
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##own", ui.tr("another scene file to host; confirm with Enter"), &own_scene_,
                               ImGuiInputTextFlags_EnterReturnsTrue))
    if (const auto place = room.offer(own_scene_)) scene_ = *place;
  ui.note("own scene");
}

void* EnterPage::picture(Interface& ui, const ListedScene& scene) {
  if (!scene.picture) return nullptr;
  void*& texture = textures_[scene.file.string()];
  if (texture == nullptr) texture = ui.texture_of(*scene.picture);
  return texture;
}

}  // namespace prosector
