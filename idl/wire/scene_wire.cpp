// Wire conversion of the scene graph and its meshes: SceneInfo, AssetChunk.

#include <algorithm>

#include "idl/wire/fields.h"

namespace prosector {
namespace {

Refusal check_names(const SceneBody& m) {
  if (m.names.size() > max_local_names) return "a body of the scene has too many names in other languages";
  for (std::size_t i = 0; i < m.names.size(); ++i) {
    const std::string& language = m.names[i].language;
    const auto same = [&](const LocalName& other) { return other.language == language; };
    if (!is_language_tag(language)) return "language tag not valid";
    if (std::any_of(m.names.begin(), m.names.begin() + static_cast<std::ptrdiff_t>(i), same))
      return "a body of the scene has two names in the same language";
    if (!valid_name(m.names[i].name)) return "a body's name in another language is not valid text";
  }
  const bool term = m.term.empty() || (m.term.size() <= max_term_length && valid_name(m.term));
  return term ? Refusal() : "term not valid";
}

Refusal check_body(SceneBody& m) {
  if (const Refusal pose = check_pose(m.pose)) return pose;
  if (const Refusal color = check_color(m.appearance.color)) return color;
  if (const Refusal tint = check_color(m.appearance.transmittance)) return tint;
  if (const Refusal names = check_names(m)) return names;
  const bool soft = m.kind == BodyKind::soft;
  return Checks()
      .that(valid_name(m.name), "body name not valid")
      .that(valid_text(m.description), "description not valid text")
      .that(enum_within(m.kind, BodyKind::soft), "unknown body kind")
      .that(m.points <= max_streamed_points, "too many points")
      .that(!soft || (m.points > 0 && m.chunk_points > 0), "soft body without points")
      .that(m.chunk_points <= max_chunk_points, "chunks too large")
      .that(within(m.tube_diameter, 0, max_tube_diameter), "the diameter of a body's tube is out of range")
      .that(within(m.appearance.roughness, 0, 1), "roughness outside [0, 1]")
      .that(within(m.appearance.wetness, 0, 1), "wetness outside [0, 1]")
      .that(enum_within(m.appearance.surface, last_body_surface), "unknown surface")
      .that(within(m.appearance.refractive_index, min_refractive_index, max_refractive_index),
            "the refractive index of a body's surface is out of range")
      .that(within(m.appearance.abbe_number, min_abbe_number, max_abbe_number),
            "the Abbe number of a body's surface is out of range")
      .that(valid_text(m.method), "method not valid text")
      .that(enum_within(m.fidelity, Fidelity::mesh), "unknown fidelity")
      .refusal();
}

/// Returns whether every parent is a body of the scene and the parents form no cycle.
bool parents_form_a_forest(const std::vector<SceneBody>& bodies) {
  const auto count = static_cast<std::int32_t>(bodies.size());
  std::vector<std::int32_t> walked_from(bodies.size(), -1);  // first body whose path to the root passed here
  for (std::int32_t start = 0; start < count; ++start) {
    for (std::int32_t at = start; at != -1; at = bodies[static_cast<std::size_t>(at)].parent) {
      if (at < 0 || at >= count) return false;
      std::int32_t& mark = walked_from[static_cast<std::size_t>(at)];
      if (mark == start) return false;
      if (mark != -1) break;
      mark = start;
    }
  }
  return true;
}

Refusal check_light(const LightInfo& m) {
  if (const Refusal color = check_color(m.color)) return color;
  return Checks()
      .that(m.name.empty() || valid_name(m.name), "light name not valid")
      .that(enum_within(m.kind, LightKind::spot), "unknown light kind")
      .that(within(m.position, max_coordinate), "the position of a light is out of range")
      .that(within(m.direction, max_coordinate) && m.direction.norm() > 0,
            "the direction of a light is zero or out of range")
      .that(within(m.intensity, 0, 1e9), "intensity out of range")
      .that(within(m.cone, 0, 3.2), "cone out of range")
      .that(within(m.softness, 0, 1), "softness outside [0, 1]")
      .refusal();
}

template <class Io>
void fields(Io& io, MessageOf<Io, LocalName>& m, WireOf<Io, prosector_LocalName>& w) {
  io(m.language, w.language);
  io(m.name, w.name);
}

template <class Io>
void fields(Io& io, MessageOf<Io, SceneBody>& m, WireOf<Io, prosector_SceneBody>& w) {
  io(m.name, w.name);
  io(m.description, w.description);
  io(m.kind, w.kind);
  io(m.parent, w.parent);
  io(m.moves, w.moves);
  io(m.pose, w.pose);
  io(m.mesh, w.mesh);
  io(m.map, w.embedding);
  io(m.points, w.points);
  io(m.chunk_points, w.chunk_points);
  io(m.tube_diameter, w.tube_diameter);
  io(m.appearance.color, w.color);
  io(m.appearance.roughness, w.roughness);
  io(m.appearance.wetness, w.wetness);
  io(m.appearance.surface, w.surface);
  io(m.appearance.refractive_index, w.refractive_index);
  io(m.appearance.abbe_number, w.abbe_number);
  io(m.appearance.transmittance, w.transmittance);
  io(m.method, w.method);
  io(m.show_figures, w.show_figures);
  io(m.part, w.part);
  io(m.fidelity, w.fidelity);
  io(m.outline, w.outline);
  io.list(m.names, w.names, max_local_names, "a body of the scene has too many names in other languages",
          [](auto& items, auto& name, auto& field) { fields(items, name, field); });
  io(m.term, w.term);
}

template <class Io>
void fields(Io& io, MessageOf<Io, LightInfo>& m, WireOf<Io, prosector_LightInfo>& w) {
  io(m.name, w.name);
  io(m.kind, w.kind);
  io(m.position, w.position);
  io(m.direction, w.direction);
  io(m.color, w.color);
  io(m.intensity, w.intensity);
  io(m.cone, w.cone);
  io(m.softness, w.softness);
  io(m.body, w.body);
}

template <class Io>
void fields(Io& io, MessageOf<Io, SceneInfo>& m, WireOf<Io, prosector_SceneInfo>& w) {
  io(m.name, w.name);
  io(m.description, w.description);
  io.list(m.bodies, w.bodies, max_bodies, "too many bodies",
          [](auto& items, auto& body, auto& field) { fields(items, body, field); });
  io.list(m.lights, w.lights, max_lights, "too many lights",
          [](auto& items, auto& light, auto& field) { fields(items, light, field); });
  io(m.camera.eye, w.camera_eye);
  io(m.camera.target, w.camera_target);
  io(m.camera.fov, w.camera_fov);
}

}  // namespace

void to_wire(const SceneInfo& m, prosector_SceneInfo& w, WireArena& arena) {
  FieldWriter io(arena);
  fields(io, m, w);
  to_wire(m.patient ? m.patient->right : Vec3::Zero(), w.patient_right);
  to_wire(m.patient ? m.patient->head : Vec3::Zero(), w.patient_head);
}

Refusal from_wire(const prosector_SceneInfo& w, SceneInfo& m) {
  FieldReader io;
  fields(io, m, w);
  const PatientFrame patient{from_wire(w.patient_right), from_wire(w.patient_head)};
  m.patient.reset();
  if (!patient.right.isZero(0) || !patient.head.isZero(0)) m.patient = patient;
  return io.refusal();
}

Refusal check(SceneInfo& m) {
  if (m.bodies.size() > max_bodies) return "too many bodies";
  if (m.lights.size() > max_lights) return "too many lights";
  for (SceneBody& body : m.bodies)
    if (const Refusal refusal = check_body(body)) return refusal;
  for (const LightInfo& light : m.lights) {
    if (const Refusal refusal = check_light(light)) return refusal;
    if (light.body < -1 || light.body >= static_cast<std::int32_t>(m.bodies.size()))
      return "a light is fixed to a body that is not in the scene";
  }
  return Checks()
      .that(valid_name(m.name), "scene name not valid")
      .that(valid_text(m.description), "description not valid text")
      .that(parents_form_a_forest(m.bodies), "the parents of bodies do not form a forest")
      .that(within(m.camera.eye, max_coordinate) && within(m.camera.target, max_coordinate),
            "camera out of range")
      .that(within(m.camera.fov, 0.01, 3.1), "the field of view of the scene's camera is out of range")
      .that(!m.patient || is_valid_patient_frame(*m.patient),
            "the patient's directions (right and head) are zero or not perpendicular")
      .refusal();
}

void to_wire(const AssetChunk& m, prosector_AssetChunk& w, WireArena& arena) {
  const prosector_Digest hash = to_wire(m.hash);
  w.hash_high = hash.high;
  w.hash_low = hash.low;
  w.chunk = m.chunk;
  w.chunks = m.chunks;
  w.total_bytes = m.total_bytes;
  make_sequence<std::uint8_t>(w.bytes, m.bytes.size(), arena);
  if (!m.bytes.empty()) std::memcpy(w.bytes._buffer, m.bytes.data(), m.bytes.size());
}

Refusal from_wire(const prosector_AssetChunk& w, AssetChunk& m) {
  if (!sequence_within(w.bytes, asset_chunk_bytes)) return "chunk too large";
  m.hash = from_wire(prosector_Digest{w.hash_high, w.hash_low});
  m.chunk = w.chunk;
  m.chunks = w.chunks;
  m.total_bytes = w.total_bytes;
  m.bytes.assign(w.bytes._buffer, w.bytes._buffer + w.bytes._length);
  return {};
}

Refusal check(AssetChunk& m) {
  if (m.total_bytes == 0 || m.total_bytes > max_asset_bytes)
    return "the size of an asset is zero or too large";
  if (m.chunks != (m.total_bytes + asset_chunk_bytes - 1) / asset_chunk_bytes)
    return "wrong number of chunks";
  if (m.chunk >= m.chunks) return "no such chunk";
  const std::size_t before = m.chunk * asset_chunk_bytes;
  if (m.bytes.size() != std::min(asset_chunk_bytes, m.total_bytes - before)) return "wrong chunk size";
  return {};
}

}  // namespace prosector
