#include "twins/arms/inverse3_twin.h"

namespace prosector {
namespace {

constexpr const char* inverse3_id = "049D";

/// Returns the parameters of an Inverse3. All are assumed; the peak force is that of its driver.
ArmMechanics inverse3_mechanics() {
  ArmMechanics out;
  out.mass = 0.15;
  out.damping = 0.2;
  out.quantum = 2e-5;
  out.peak_force = 8;
  return out;
}

}  // namespace

Inverse3Twin::Inverse3Twin(Inverse3TwinOptions options, std::int64_t now_ns)
    : garbage(options.garbage),
      arm_(std::move(static_cast<HeldArmOptions&>(options)), inverse3_mechanics(), now_ns),
      random_(options.seed),
      now_ns_(now_ns) {}

std::string Inverse3Twin::begin() {
  arm_.take(now_ns_);
  return text(true);
}

void Inverse3Twin::take(std::string_view text) {
  const auto force = inverse3::force_of(text);
  if (!force) ++bad_texts_;
  const bool acts = force && force->device == inverse3_id && !unplugged;
  arm_.set_force(acts ? Vec3(inverse3::axes() * force->force) : Vec3(Vec3::Zero()));
}

void Inverse3Twin::advance(std::int64_t now_ns) {
  now_ns_ = now_ns;
  arm_.advance(now_ns);
}

std::string Inverse3Twin::text(bool first) {
  inverse3::State state;
  if (!unplugged) {
    const Mat3 from_arm = inverse3::axes().transpose();
    state.device = inverse3_id;
    state.place = from_arm * arm_.model().measured();
    state.turn = Quat(from_arm * arm_.orientation().toRotationMatrix() * from_arm.transpose());
    state.buttons = buttons;
  }
  std::string out = inverse3::text_of(state, first);
  if (garbage <= 0 || std::uniform_real_distribution<double>(0, 1)(random_) >= garbage) return out;
  if (random_() % 2 == 0) {
    out.resize(random_() % out.size());
  } else {
    for (char& c : out)
      if (random_() % 8 == 0) c = static_cast<char>(random_() % 127 + 1);
  }
  return out;
}

}  // namespace prosector
