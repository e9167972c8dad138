#pragma once
// Saved records. A function entry(io, record) describes each kind of record once: it hands the members to an
// Io in the order of their bytes. The Io writes them, reads and checks them, or names them. Entries take the
// members by structured bindings, which name all of them, so a new member doesn't compile before the entry
// says what becomes of it.

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/byte_stream.h"

namespace prosector {

/// Names of the values in a saved state, by the offset of their first byte. They are used to report which
/// value differs between two states.
class RecordLabels {
 public:
  void open(const std::string& scope) { scopes_.push_back(scope); }
  void close() { scopes_.pop_back(); }
  void note(std::size_t offset, const char* name) {
    std::vector<std::string> path = scopes_;
    path.emplace_back(name);
    labels_.emplace(offset, fmt::format("{}", fmt::join(path, ", ")));
  }
  /// Returns the name of the value in the saved state to which the byte at `offset` belongs. Empty if no
  /// value begins at or before that byte.
  std::string at(std::size_t offset) const {
    const auto after = labels_.upper_bound(offset);
    return after == labels_.begin() ? std::string() : std::prev(after)->second;
  }

 private:
  std::vector<std::string> scopes_;
  std::map<std::size_t, std::string> labels_;
};

/// An Io (the interface that record descriptions write to or read from) that appends records to bytes. If
/// given `labels`, it also notes the name of each value and where it begins.
class RecordWriter {
 public:
  static constexpr bool reads = false;
  template <class T>
  using Entry = const T;

  explicit RecordWriter(ByteWriter& out, RecordLabels* labels = nullptr) : out_(out), labels_(labels) {}

  template <class T>
  void number(const T& value, const char* name) {
    note(name);
    out_.add(value);
  }
  /// Appends an index or count to the record as 64 bits. The unnamed argument, an upper bound, is only used
  /// for reading.
  void index(std::size_t value, std::size_t, const char* name) {
    note(name);
    out_.add(static_cast<std::uint64_t>(value));
  }
  void flag(bool value, const char* name) {
    note(name);
    out_.add(static_cast<std::uint8_t>(value));
  }
  void vector(const Vec3& value, const char* name) {
    note(name);
    out_.add(value);
  }
  void pose(const Pose& value, const char* name) {
    note(name);
    out_.add(value);
  }
  /// Appends the numbers of a vector to the record, without their count, which the reader knows.
  void vector(const VecX& value, Eigen::Index, const char* name) {
    note(name);
    out_.add(value);
  }
  /// Appends the number of a list's values to the record, and then each value by `each(value)`. The unnamed
  /// argument, a limit of the number, is only used for reading.
  template <class T, class Each>
  void list(const std::vector<T>& list, std::size_t, const char* name, const Each& each) {
    index(list.size(), 0, name);
    for (std::size_t k = 0; k < list.size(); ++k) {
      const auto in = scope(name, k);
      each(list[k]);
    }
  }
  template <class T>
  void optional(const std::optional<T>& value, const char* name) {
    flag(value.has_value(), name);
  }
  /// Appends the number of a map's entries to the record, and then each entry by `each(key, value)`. The
  /// unnamed argument, a limit of the number, is only used for reading.
  template <class Map, class Each>
  void map(const Map& map, std::size_t, const char* name, const Each& each) {
    index(map.size(), 0, name);
    std::size_t k = 0;
    for (const auto& [key, value] : map) {
      const auto in = scope(name, k++);
      each(key, value);
    }
  }
  void require(bool, const char*) {}

  class Scope {
   public:
    explicit Scope(RecordLabels* labels) : labels_(labels) {}
    Scope(const Scope&) = delete;
    ~Scope() {
      if (labels_ != nullptr) labels_->close();
    }

   private:
    RecordLabels* labels_;
  };
  /// Prefixes the labels of all values that are added to the record during the lifetime of the result with
  /// `name`.
  [[nodiscard]] Scope scope(const std::string& name) {
    if (labels_ != nullptr) labels_->open(name);
    return Scope(labels_);
  }
  [[nodiscard]] Scope scope(const char* name, std::size_t index) {
    if (labels_ != nullptr) labels_->open(fmt::format("{} {}", name, index));
    return Scope(labels_);
  }

 private:
  void note(const char* name) {
    if (labels_ != nullptr) labels_->note(out_.bytes().size(), name);
  }

  ByteWriter& out_;
  RecordLabels* labels_;
};

/// An Io (the interface that record descriptions write to or read from) that reads records from bytes and
/// checks them. Throws InputError for values that are not valid.
class RecordReader {
 public:
  static constexpr bool reads = true;
  template <class T>
  using Entry = T;

  explicit RecordReader(ByteReader& in) : in_(in) {}

  template <class T>
  void number(T& value, const char*) {
    value = in_.number<T>();
  }
  /// Reads an index of 64 bits from the record. Throws InputError unless it is below `end`.
  template <class T>
  void index(T& value, std::size_t end, const char* name) {
    const auto read = in_.number<std::uint64_t>();
    if (read >= end) in_.require(false, fmt::format("{}: beyond its range", name).c_str());
    value = static_cast<T>(read);
  }
  void flag(bool& value, const char*) { value = in_.flag(); }
  void vector(Vec3& value, const char*) { value = in_.vector(); }
  void pose(Pose& value, const char*) { value = in_.pose(); }
  void vector(VecX& value, Eigen::Index size, const char*) { value = in_.vector(size); }
  /// Reads a list from the record, each value by `each(value)`. Throws InputError if it has more than `most`
  /// values.
  template <class T, class Each>
  void list(std::vector<T>& list, std::size_t most, const char*, const Each& each) {
    list.clear();
    for (std::size_t left = in_.count(most); left > 0; --left) each(list.emplace_back());
  }
  /// Reads whether an optional value is present: then creates it with default contents, which the caller
  /// reads next; otherwise resets it.
  template <class T>
  void optional(std::optional<T>& value, const char*) {
    value.reset();
    if (in_.flag()) value.emplace();
  }
  /// Reads a map from the record, each entry by `each(key, value)`. Throws InputError if the keys are not in
  /// ascending order or there are more than `most` entries.
  template <class Map, class Each>
  void map(Map& map, std::size_t most, const char* name, const Each& each) {
    map.clear();
    for (std::size_t left = in_.count(most); left > 0; --left) {
      typename Map::key_type key{};
      typename Map::mapped_type value{};
      each(key, value);
      if (!map.empty() && !(map.rbegin()->first < key))
        in_.require(false, fmt::format("{}: out of order", name).c_str());
      map.emplace_hint(map.end(), std::move(key), std::move(value));
    }
  }
  void require(bool good, const char* problem) { in_.require(good, problem); }

  struct Scope {
    ~Scope() {}
  };
  [[nodiscard]] Scope scope(const std::string&) { return {}; }
  [[nodiscard]] Scope scope(const char*, std::size_t) { return {}; }

 private:
  ByteReader& in_;
};

}  // namespace prosector
