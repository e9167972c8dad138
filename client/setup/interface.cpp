#include "client/setup/interface.h"

#include <imgui.h>

#include <array>
#include <utility>

#include "client/text/font_catalogue.h"

namespace prosector {
namespace {

constexpr float letter_size = 17;  // pixels at scale 1
const Eigen::Vector3f ground{0.075f, 0.085f, 0.1f};

// Keys with ImGui names; ImGui does not need other keys.
constexpr std::array<std::pair<ImGuiKey_, Key>, 20> keys = {{{ImGuiKey_Tab, Key::tab},
                                                             {ImGuiKey_LeftArrow, Key::left},
                                                             {ImGuiKey_RightArrow, Key::right},
                                                             {ImGuiKey_UpArrow, Key::up},
                                                             {ImGuiKey_DownArrow, Key::down},
                                                             {ImGuiKey_PageUp, Key::page_up},
                                                             {ImGuiKey_PageDown, Key::page_down},
                                                             {ImGuiKey_Home, Key::home},
                                                             {ImGuiKey_End, Key::end},
                                                             {ImGuiKey_Insert, Key::insert},
                                                             {ImGuiKey_Delete, Key::del},
                                                             {ImGuiKey_Backspace, Key::backspace},
                                                             {ImGuiKey_Space, Key::space},
                                                             {ImGuiKey_Enter, Key::enter},
                                                             {ImGuiKey_Escape, Key::escape},
                                                             {ImGuiKey_A, key_of('A')},
                                                             {ImGuiKey_C, key_of('C')},
                                                             {ImGuiKey_V, key_of('V')},
                                                             {ImGuiKey_X, key_of('X')},
                                                             {ImGuiKey_Z, key_of('Z')}}};

void set_style(double scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.ChildRounding = style.FrameRounding = style.GrabRounding = 4;
  style.FramePadding = {10, 6};
  style.ItemSpacing = {10, 9};
  style.WindowPadding = {16, 14};
  style.FrameBorderSize = 1;
  style.Colors[ImGuiCol_WindowBg] = {0, 0, 0, 0};
  style.Colors[ImGuiCol_ChildBg] = {1, 1, 1, 0.03f};
  style.Colors[ImGuiCol_Border] = {1, 1, 1, 0.12f};
  style.Colors[ImGuiCol_Button] = {0.16f, 0.36f, 0.52f, 1};
  style.Colors[ImGuiCol_PlotHistogram] = {0.16f, 0.42f, 0.34f, 1};
  style.Colors[ImGuiCol_NavHighlight] = {1, 0.8f, 0.3f, 1};
  style.ScaleAllSizes(static_cast<float>(scale));
}

Eigen::Vector4f shade_of(ImU32 packed) {
  const ImVec4 v = ImGui::ColorConvertU32ToFloat4(packed);
  return {v.x, v.y, v.z, v.w};
}

void* id_of(std::uint32_t texture) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(texture));
}

std::uint32_t texture_id(void* shown) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(shown));
}

}  // namespace

Interface::Interface(GlContext& context, const std::filesystem::path& shaders, double scale, Catalogue words)
    : context_(context),
      painter_(context, shaders),
      scale_(scale),
      words_(std::move(words)),
      imgui_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(imgui_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // does not save window positions
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  for (const auto& [theirs, ours] : keys) io.KeyMap[theirs] = static_cast<int>(ours);
  set_style(scale);
  make_fonts();
}

Interface::~Interface() {
  ImGui::DestroyContext(imgui_);
}

/// Makes the glyphs of Latin, Greek and Cyrillic; other characters are shown as boxes.
void Interface::make_fonts() {
  static constexpr std::array<ImWchar, 11> ranges = {0x20,   0x24f,  0x370,  0x52f,  0x2010, 0x2026,
                                                     0x2190, 0x2193, 0x2212, 0x2265, 0};
  const FontCatalogue catalogue;
  const FontFile& file = catalogue.file(0);
  ImFontConfig config;
  config.FontNo = file.index;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.AddFontFromFileTTF(file.path.c_str(), letter_size * static_cast<float>(scale_), &config,
                           ranges.data());
  unsigned char* rgba = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&rgba, &width, &height);
  atlas.SetTexID(id_of(painter_.add_texture(width, height, rgba)));
}

void Interface::take(const std::vector<WindowEvent>& events) {
  events_.insert(events_.end(), events.begin(), events.end());
}

/// Processes queued events up to a press or release that must be shown for a frame.
void Interface::take_in() {
  while (!events_.empty()) {
    const WindowEvent event = events_.front();
    events_.pop_front();
    if (take_in(event)) return;
  }
}

/// Processes one event. Returns true if a frame must be drawn before the next event.
bool Interface::take_in(const WindowEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  if (const auto* moved = std::get_if<MouseMoved>(&event)) {
    io.MousePos = {static_cast<float>(moved->x), static_cast<float>(moved->y)};
  } else if (const auto* button = std::get_if<MouseButtonEvent>(&event)) {
    io.MouseDown[static_cast<int>(button->button)] = button->down;
    return true;
  } else if (const auto* wheel = std::get_if<WheelTurned>(&event)) {
    io.MouseWheel += static_cast<float>(wheel->y);
    io.MouseWheelH += static_cast<float>(wheel->x);
  } else if (const auto* typed = std::get_if<CharacterTyped>(&event)) {
    io.AddInputCharacter(typed->character);
  } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
    if (key->repeat) return false;  // ImGui generates repeats
    io.KeysDown[static_cast<int>(key->key)] = key->down;
    if (key->key == Key::shift) io.KeyShift = key->down;
    if (key->key == Key::control) io.KeyCtrl = key->down;
    if (key->key == Key::alt) io.KeyAlt = key->down;
    return true;
  }
  return false;
}

void Interface::draw(double seconds, const std::function<void()>& pages) {
  ImGui::SetCurrentContext(imgui_);
  take_in();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(context_.width()), static_cast<float>(context_.height())};
  io.DeltaTime = static_cast<float>(std::max(1e-4, seconds));
  placed_.clear();
  ImGui::NewFrame();
  pages();
  ImGui::Render();
  painter_.draw(ground, triangles());
}

void Interface::note(const std::string& name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  placed_.push_back({name, static_cast<double>(low.x), static_cast<double>(low.y),
                     static_cast<double>(high.x), static_cast<double>(high.y)});
}

void* Interface::texture_of(const Image& image, void* instead) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(image.rgb.size() / 3 * 4);
  for (std::size_t k = 0; k + 2 < image.rgb.size(); k += 3)
    rgba.insert(rgba.end(), {image.rgb[k], image.rgb[k + 1], image.rgb[k + 2], 255});
  if (instead == nullptr) return id_of(painter_.add_texture(image.width, image.height, rgba.data()));
  painter_.change_texture(texture_id(instead), image.width, image.height, rgba.data());
  return instead;
}

/// Returns ImGui's triangles of this frame.
std::vector<InterfaceDraw> Interface::triangles() const {
  std::vector<InterfaceDraw> out;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int k = 0; k < data.CmdListsCount; ++k) {
    const ImDrawList& list = *data.CmdLists[k];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      InterfaceDraw& draw = out.emplace_back();
      draw.texture = texture_id(command.GetTexID());
      draw.left = static_cast<int>(command.ClipRect.x);
      draw.top = static_cast<int>(command.ClipRect.y);
      draw.right = static_cast<int>(command.ClipRect.z);
      draw.bottom = static_cast<int>(command.ClipRect.w);
      for (unsigned i = 0; i < command.ElemCount; ++i) {
        const auto index =
            static_cast<int>(command.VtxOffset) + list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
        const ImDrawVert& v = list.VtxBuffer[index];
        draw.vertices.push_back({{v.pos.x, v.pos.y}, {v.uv.x, v.uv.y}, shade_of(v.col)});
      }
    }
  }
  return out;
}

}  // namespace prosector
