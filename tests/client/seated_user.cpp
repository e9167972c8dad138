#include "tests/client/seated_user.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace prosector::test {
namespace {

constexpr std::chrono::milliseconds step_time(17);  // a tick, and a picture

BusConfig config(BusEnd end) {
  BusConfig out;
  out.end = end;
  return out;
}

/// Returns the bodies that a user came to see: tissue and parts of the anatomy; where there are none, what
/// moves; where nothing does, all.
std::vector<BodyId> bodies_to_see(const SceneInfo& scene) {
  std::vector<BodyId> anatomy, moving, all;
  for (BodyId id = 0; id < scene.bodies.size(); ++id) {
    const SceneBody& body = scene.bodies[id];
    if (body.part || body.kind == BodyKind::soft) anatomy.push_back(id);
    if (body.moves) moving.push_back(id);
    all.push_back(id);
  }
  return !anatomy.empty() ? anatomy : !moving.empty() ? moving : all;
}

}  // namespace

SeatedUser::SeatedUser(Simulation& simulation)
    : network_(LocalNetworkConfig{}),
      server_bus_(network_.join(config(BusEnd::server))),
      simulation_(simulation),
      loop_(simulation, *server_bus_, "prosector", nullptr, [](const std::string&) {},
            {{}, [this] { return network_.now_ns(); }}) {
  loop_.publisher().flush();
}

void SeatedUser::join(int width, int height) {
  desk_.reset();
  if (bus_) command(Leave{});
  if (bus_) step();
  bus_ = network_.join(config(BusEnd::dissector));
  ++self_;
  replica_ = Replica();
  window_ = std::make_unique<ActedWindow>(width, height);
  desk_ = std::make_unique<Desk>(*window_, DeskChoices{});
  Presence presence;
  presence.participant = self_;
  presence.name = "user";
  presence.role = Role::dissector;
  bus_->publish(presence);
  command(Join{});
  for (int k = 0; k < 600 && !desk_->has_begun(); ++k) step();
  // The skin of hands is made on another thread: a picture without hands shows nothing.
  for (int k = 0; k < 1000 && subject().bodies.size() >= picture_.items.size(); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    draw();
  }
}

void SeatedUser::wait(double seconds) {
  const double steps = seconds / std::chrono::duration<double>(step_time).count();
  for (int k = 0; k < steps; ++k) step();
}

/// Runs a tick, takes what was sent, and draws a picture.
void SeatedUser::step() {
  loop_.tick();
  loop_.publisher().flush();
  network_.advance(step_time);
  std::vector<Received> received;
  bus_->take(received);
  for (const Received& r : received) replica_.apply(r);
  if (!desk_ || !replica_.complete()) return;
  draw();
  send();
}

/// As Viewer::draw() does for a desk.
void SeatedUser::draw() {
  const double tick = replica_.time().advance(network_.now_ns());
  const std::chrono::steady_clock::time_point now{std::chrono::nanoseconds(network_.now_ns())};
  const double aspect = static_cast<double>(window_->width()) / window_->height();
  if (!desk_->has_begun()) desk_->begin(start_view_of(replica_, tick, self_, aspect), now);
  desk_->update(desk_session(replica_, view_, tick, self_), now);
  user_ = {.participant = self_, .input = desk_->input(), .present = true, .at_desk = true};
  settings_ = {};
  settings_.width = window_->width();
  settings_.height = window_->height();
  settings_.eye = desk_->view().eye();
  settings_.pointed = desk_->pointed();
  show_choices(*desk_, settings_);
  picture_ = view_.build(replica_, tick, user_, settings_);
}

void SeatedUser::send() {
  HandInput input = user_.input;
  input.participant = self_;
  input.sequence = ++sequence_;
  input.time_ns = network_.now_ns();
  bus_->publish(input);
  for (const CommandBody& body : desk_->take_commands()) command(body);
}

void SeatedUser::command(const CommandBody& body) {
  bus_->publish(Command{self_, ++sequence_, body});
}

/// Tells the items of the picture apart by building it once more without the user's hand, with the bodies to
/// see made bright.
CoverSubject SeatedUser::subject() {
  ViewSettings bare = settings_;
  bare.overlay = false;
  bare.cut_guide.clear();
  bare.highlighted = bodies_to_see(*replica_.scene());
  const LocalUser handless{.participant = self_, .input = {}, .present = true};
  CoverSubject out;
  const double tick = replica_.time().advance(network_.now_ns());
  const DrawList& list = view_.build(replica_, tick, handless, bare);
  for (const DrawItem& item : list.items) {
    if (item.appearance.surface == Surface::emissive) continue;
    out.bodies.insert(item.mesh->id);
    if (item.brightness > 1.5) out.anatomy.insert(item.mesh->id);
  }
  return out;
}

Cover SeatedUser::cover(int longest, AnatomyPixels* seen) {
  return cover_of(picture_, subject(), longest, seen);
}

bool SeatedUser::holds() const {
  return std::ranges::any_of(simulation_.hands(),
                             [&](const HandState& hand) { return hand.holding.has_value(); });
}

}  // namespace prosector::test
