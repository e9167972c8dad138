#pragma once
// Reader for the tables of a FlatBuffers file; checks each position against the file's end. Offsets are
// unsigned 32-bit numbers, except the signed offset from a table to its field list. All values are
// little-endian.

#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace prosector {

class FlatTable {
 public:
  using Bytes = std::span<const std::uint8_t>;

  /// Returns the root table of a FlatBuffers file. This and all other functions of the class throw InputError
  /// if an offset leaves the file. The bytes must outlive the table.
  static FlatTable root(Bytes file);

  /// Returns the number in a field, given by its index in the table's schema. Returns `otherwise` if the
  /// field is absent.
  template <typename Number>
  Number number(std::size_t field, Number otherwise) const {
    const std::size_t at = place(field, sizeof(Number));
    return at == 0 ? otherwise : read<Number>(at);
  }
  /// Returns the list of numbers in a field, given by its index in the table's schema. Returns an empty list
  /// if the field is absent. Throws InputError if the list has more than `most` entries.
  std::vector<std::int32_t> integers(std::size_t field, std::size_t most) const;
  Bytes bytes(std::size_t field) const;
  std::string text(std::size_t field, std::size_t most) const;
  std::optional<FlatTable> table(std::size_t field) const;
  std::vector<FlatTable> tables(std::size_t field, std::size_t most) const;

 private:
  struct List {
    std::size_t first = 0, count = 0;
  };
  FlatTable(Bytes file, std::size_t at);
  template <typename Number>
  Number read(std::size_t at) const {
    need(at, sizeof(Number));
    Number out;
    std::memcpy(&out, file_.data() + at, sizeof(Number));
    return out;
  }
  void need(std::size_t at, std::size_t bytes) const;
  std::size_t place(std::size_t field, std::size_t bytes) const;
  std::size_t follow(std::size_t at) const;
  List list(std::size_t field, std::size_t bytes_each, std::size_t most) const;

  Bytes file_;
  std::size_t at_ = 0, fields_ = 0, fields_bytes_ = 0;
};

}  // namespace prosector
