#include "idl/wire/serialised_bytes.h"

#include <dds/dds.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "common/error.h"

namespace prosector {
namespace {

/// Computes a sample's size by interpreting a type's instructions (dds/ddsc/dds_opcodes.h). An instruction
/// has an opcode with the field's type, the field's offset in the struct, and arguments of the type.
/// Appendable types are serialised as XCDR2 (OMG DDS-XTYPES 1.3, 7.4.3), which adds the size of structures
/// without a fixed layout and aligns numbers to at most 4 bytes. All other types are serialised as XCDR1.
class ByteCount {
 public:
  explicit ByteCount(bool xcdr2) : xcdr2_(xcdr2) {}

  void add_struct(const std::uint32_t* op, const char* at) {
    if (DDS_OP(*op) == DDS_OP_DLC) {
      add_numbers(size_bytes, 1);
      ++op;
    }
    while (DDS_OP(*op) == DDS_OP_ADR) op = add_field(op, at + op[1]);
    if (DDS_OP(*op) != DDS_OP_RTS)
      throw InternalError(
          "wire: a message type's description has an instruction that does not describe a field");
  }
  std::size_t bytes() const { return bytes_; }

 private:
  /// Adds a field. Returns the next field's instruction.
  const std::uint32_t* add_field(const std::uint32_t* op, const char* field) {
    switch (DDS_OP_TYPE(*op)) {
      case DDS_OP_VAL_BST:
        add_text(field, op[2]);
        return op + 3;
      case DDS_OP_VAL_EXT:
        add_struct(elements(op, op[2]), field);
        return next(op, op[2]);
      case DDS_OP_VAL_ARR:
        return add_array(op, field);
      case DDS_OP_VAL_BSQ:
        return add_sequence(op, field);
      default:
        add_numbers(number_bytes(DDS_OP_TYPE(*op)), 1);
        return op + 2;
    }
  }

  const std::uint32_t* add_array(const std::uint32_t* op, const char* field) {
    if (DDS_OP_SUBTYPE(*op) != DDS_OP_VAL_STU) {
      add_numbers(number_bytes(DDS_OP_SUBTYPE(*op)), op[2]);
      return op + 3;
    }
    add_structs(elements(op, op[3]), field, op[2], op[4]);
    return next(op, op[3]);
  }

  const std::uint32_t* add_sequence(const std::uint32_t* op, const char* field) {
    dds_sequence_t sequence;
    std::memcpy(&sequence, field, sizeof sequence);
    add_numbers(size_bytes, 1);
    const auto* first = reinterpret_cast<const char*>(sequence._buffer);
    if (DDS_OP_SUBTYPE(*op) != DDS_OP_VAL_STU) {
      add_numbers(number_bytes(DDS_OP_SUBTYPE(*op)), sequence._length);
      return op + 3;
    }
    add_structs(elements(op, op[4]), first, sequence._length, op[3]);
    return next(op, op[4]);
  }

  void add_structs(const std::uint32_t* op, const char* first, std::size_t count, std::size_t size) {
    if (xcdr2_) add_numbers(size_bytes, 1);
    for (std::size_t i = 0; i < count; ++i) add_struct(op, first + i * size);
  }

  /// Adds a string: its length, its characters and a terminating zero.
  void add_text(const char* text, std::size_t capacity) {
    add_numbers(size_bytes, 1);
    bytes_ += strnlen(text, capacity) + 1;
  }

  void add_numbers(std::size_t size, std::size_t count) {
    if (count == 0) return;
    const std::size_t alignment = xcdr2_ ? std::min<std::size_t>(size, 4) : size;
    bytes_ = (bytes_ + alignment - 1) / alignment * alignment + count * size;
  }

  static std::size_t number_bytes(dds_stream_typecode kind) {
    switch (kind) {
      case DDS_OP_VAL_BLN:
      case DDS_OP_VAL_1BY:
        return 1;
      case DDS_OP_VAL_2BY:
        return 2;
      case DDS_OP_VAL_4BY:
        return 4;
      case DDS_OP_VAL_8BY:
        return 8;
      default:
        throw InternalError("wire: a message type has a kind of field whose size is not known");
    }
  }

  // One word contains the offsets of the next instruction and of the elements' instructions.
  static const std::uint32_t* next(const std::uint32_t* op, std::uint32_t jumps) {
    return op + DDS_OP_ADR_JMP(jumps);
  }
  static const std::uint32_t* elements(const std::uint32_t* op, std::uint32_t jumps) {
    return op + DDS_OP_ADR_JSR(jumps);
  }

  static constexpr std::size_t size_bytes = 4;  // of a length field
  bool xcdr2_;
  std::size_t bytes_ = 0;
};

}  // namespace

std::size_t serialised_bytes(const dds_topic_descriptor& type, const void* sample) {
  ByteCount count(DDS_OP(type.m_ops[0]) == DDS_OP_DLC);
  count.add_struct(type.m_ops, static_cast<const char*>(sample));
  return count.bytes();
}

}  // namespace prosector
