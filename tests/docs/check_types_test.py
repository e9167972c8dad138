#!/usr/bin/python3
"""check_types_test.py CHECKER WORK: what deploy/check_types.py says of types, functions and files at its limits and above them."""

import pathlib
import shutil
import subprocess
import sys

checker, work = sys.argv[1], pathlib.Path(sys.argv[2])
# Ten member functions and six data members, each written in another way.
MEMBERS = """
 public:
  explicit Wide(const int* at) : at_(*at), wide_{*at}, tall_(*at == 0) { run(); }
  ~Wide();
  Wide& operator=(const Wide&) = delete;
  bool operator<(const Wide& other) const { return at_ < other.at_; }
  template <class F = void (*)(int)>
  void each(const F& f) const { if (at_ > 0) { f("}{"); } }
  virtual int size() const = 0;  // not a brace: {
  static std::map<int, std::vector<int>> table(int a, int b = {});
  void operator()(int) const;
  [[nodiscard]] auto find() -> int;
  friend void swap(Wide&, Wide&) {}
  using Row = std::array<int, 3>;
  enum class Kind { one, two };
  struct Inner { int a, b, c; void f(); };
  static constexpr int most = 3;
 private:
  void run() {}
  int at_, wide_ = sum(1, 2);
  bool tall_ = false;
  std::function<void(int, int)> done_{nothing()};
  void (*call_)(int, int);
  char word_[3] = {'{', 'a', '"'};
"""


def tree(functions=0, fields=0, lines=1):
    more = "".join(f"  void f{i}(int a, int b);\n" for i in range(functions))
    more += "".join(f"  std::array<int, 2> d{i}_;\n" for i in range(fields))
    body = "".join(f"  a += {i};\n" for i in range(lines - 2))
    return f"namespace x {{\nclass Wide : public Base {{{MEMBERS}{more}}};\nint Wide::long_one(int a) {{\n{body}}}\n}}\n"


def of_lines(count):
    """A file with so many lines."""
    return tree() + "\n" * (count - tree().count("\n"))


def check(text):
    shutil.rmtree(work, ignore_errors=True)
    (work / "server/physics").mkdir(parents=True)
    (work / "server/physics/wide.h").write_text(text)
    told = subprocess.run([checker, str(work)], capture_output=True, text=True)
    return told.returncode, told.stdout + told.stderr


CASES = [
    (tree(20, 14, 60), 0, "good, 2 types"),
    (tree(21, 0), 1, "Wide has 31 member functions and 6 data members"),
    (tree(0, 15), 1, "Wide has 10 member functions and 21 data members"),
    (tree(0, 0, 61), 1, "Wide::long_one has 61 lines"),
    (of_lines(500), 0, "longest file but tables: 500 lines"),
    (of_lines(501), 1, "wide.h: the file has 501 lines"),
    ("", 1, "nothing found"),
]
for text, status, words in CASES:
    got, told = check(text)
    if got != status or words not in told:
        sys.exit(f"expected status {status} and \"{words}\"; status {got}:\n{told}")
print("ok: what is at the limits passes, what is above does not")
