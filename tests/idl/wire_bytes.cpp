#include "tests/idl/wire_bytes.h"

#include <type_traits>
#include <variant>

namespace prosector::test {

std::string as_wire_bytes(const Message& message) {
  return std::visit(
      [](const auto& m) -> std::string {
        using M = std::decay_t<decltype(m)>;
        std::string text;
        const auto add = [&text](const auto& value) {
          using Value = std::decay_t<decltype(value)>;
          static_assert(!std::is_same_v<Value, SimTime>, "has padding, whose bytes are anything");
          text.append(reinterpret_cast<const char*>(&value), sizeof value);
        };
        if constexpr (std::is_same_v<M, SceneInfo>) {
          for (const SceneBody& b : m.bodies) {
            text += b.name + b.description + b.method + to_hex(b.mesh) + to_hex(b.map);
            add(b.show_figures);
            add(b.part);
            add(b.fidelity);
            text += to_hex(b.outline) + b.term;
            for (const LocalName& local : b.names) text += local.language + local.name;
            add(b.appearance.color), add(b.appearance.roughness), add(b.appearance.wetness);
            add(b.appearance.surface), add(b.appearance.refractive_index), add(b.appearance.abbe_number);
            add(b.appearance.transmittance);
          }
          for (const LightInfo& l : m.lights) add(l.intensity), add(l.body), text += l.name;
          add(m.camera.fov), add(m.patient->right), add(m.patient->head);
        } else if constexpr (std::is_same_v<M, AssetChunk>) {
          text.assign(m.bytes.begin(), m.bytes.end());
          text += to_hex(m.hash);
          add(m.total_bytes);
        } else if constexpr (std::is_same_v<M, Settled>) {
          for (const auto& x : m.positions) add(x);
          add(m.hash);
        } else if constexpr (std::is_same_v<M, ServerStatus>) {
          add(m.phase_ms);
          add(m.real_time_factor);
          add(m.energy);
          add(m.error);
          text += m.degraded;
        } else if constexpr (std::is_same_v<M, SessionInfo>) {
          text = m.session + m.scene + to_hex(m.scene_hash);
          add(m.server_run);
          add(m.tick_rate);
          add(m.capacity);
        } else if constexpr (std::is_same_v<M, Presence> || std::is_same_v<M, RosterEntry>) {
          text = m.name + m.devices;
          add(m.role);
          if constexpr (std::is_same_v<M, RosterEntry>) add(m.color);
        } else if constexpr (std::is_same_v<M, CommandResult>) {
          text = m.reason;
          add(m.accepted);
        } else if constexpr (std::is_same_v<M, HandInput> || std::is_same_v<M, UserState>) {
          for (const HandPose& hand : m.hands) {
            add(hand.pose.p);
            add(hand.pose.q.coeffs());
            add(hand.flexion);
            add(hand.buttons);
          }
          add(m.head.p);
          add(m.head_tracked);
          if constexpr (std::is_same_v<M, HandInput>)
            for (const HeldPose& held : m.held) {
              add(held.tracked);
              add(held.pose.p);
              add(held.pose.q.coeffs());
            }
        } else if constexpr (std::is_same_v<M, RigidState>) {
          add(m.pose.p);
          add(m.pose.q.coeffs());
          add(m.linear_velocity);
          add(m.angular_velocity);
          add(m.settled);
        } else if constexpr (std::is_same_v<M, ContactSample>) {
          add(m.point);
          add(m.normal);
          add(m.depth);
          add(m.impulse);
          add(m.local_point);
          add(m.force);
          add(m.impact);
          add(m.touching);
        } else if constexpr (std::is_same_v<M, Command>) {
          WireArena arena;
          prosector_Command w;
          to_wire(m, w, arena);
          add(w.number);
          add(w.kind);
          add(w.hand);
          add(w.body);
          add(w.subject);
          add(w.role);
          add(w.shape.a);
          add(w.shape.p);
          add(w.control_id);
          add(w.value);
          add(w.revision);
        } else if constexpr (std::is_same_v<M, TopologyRevision>) {
          add(m.previous_hash);
          add(m.chain_hash);
          add(m.content_hash);
          add(m.time.epoch);
          add(m.time.tick);
          add(m.cause);
          add(m.author);
          add(m.piece_of);
          add(m.surface_hash);
          text += to_hex(m.mesh) + to_hex(m.map);
          for (const auto& point : m.patch.points) add(point.rest), add(point.now);
          for (const auto& v : m.patch.vertices) add(v.slot), add(v.rest), add(v.point), add(v.weight);
          for (const auto& t : m.patch.triangles) add(t.slot), add(t.corners), add(t.inner);
        } else if constexpr (std::is_same_v<M, BodyStatus>) {
          for (const double x : {m.step, m.newton_iterations, m.solver_iterations, m.residual, m.correction,
                                 m.error, m.expected_ms, m.parts.discretisation, m.parts.model,
                                 m.parts.solver, m.parts.time, m.press_error, m.error_map.cell})
            add(x);
          add(m.error_map.corner);
          add(m.error_map.size);
          for (const std::uint8_t level : m.error_map.levels) add(level);
          add(m.substeps);
          add(m.stepped_down);
          for (const Price& price : m.prices) add(price.error), add(price.ms);
          add(m.asleep);
          add(m.converged);
        } else if constexpr (std::is_same_v<M, PartState>) {
          for (const bool flag : {m.attached, m.hidden, m.lit, m.inspected}) add(flag);
          add(m.opacity);
          add(m.stiffness);
          add(m.shape.A);
          add(m.shape.p);
          for (const HandRef& holder : m.holders) add(holder.participant), add(holder.hand);
        } else if constexpr (std::is_same_v<M, Panel>) {
          add(m.open);
          add(m.body);
          add(m.pose.p);
          add(m.pose.q.coeffs());
          for (const ControlState& control : m.controls)
            add(control.position), add(control.on), add(control.touched);
        } else if constexpr (std::is_same_v<M, RoomState>) {
          add(m.lights);
          add(m.pace);
        } else if constexpr (std::is_same_v<M, Recording>) {
          add(m.last_tick);
          for (const RecordingMark& mark : m.marks) add(mark.tick), add(mark.kind), text += mark.who;
        } else if constexpr (std::is_same_v<M, FeltPlanes>) {
          add(m.hand);
          add(m.input_sequence);
          add(m.taken);
          add(m.given);
          for (const ContactPlane& plane : m.planes) {
            add(plane.id);
            add(plane.body);
            for (const Vec3& v : {plane.arm, plane.point, plane.normal, plane.force, plane.velocity}) add(v);
            for (const double x :
                 {plane.stiffness, plane.tangential, plane.damping, plane.friction, plane.radius})
              add(x);
            add(plane.holds);
          }
        } else if constexpr (std::is_same_v<M, ArmForce>) {
          add(m.hand);
          add(m.sequence);
          add(m.force);
          add(m.taken);
          add(m.given);
        }
        return text;
      },
      message);
}

}  // namespace prosector::test
