#!/usr/bin/python3
"""check_comments_test.py CHECKER WORK: what deploy/check_comments.py says of a small tree with one fault of each kind."""

import pathlib
import shutil
import subprocess
import sys

checker, work = sys.argv[1], pathlib.Path(sys.argv[2])
LONG = " ".join(["word"] * 31)
GOOD = {
    "common/good.h": f"""#pragma once
// A file's head. Its sentences end: so they are short.

/// Units of lengths, for one; data begin with the thing itself.
struct Unit {{
  double metres = 1;           // of the unit
  const char* url = "a//Of b"; // a comment after a string
  /// Returns how many there are: {" ".join(["word"] * 25)}. Throws
  /// nothing, ever.
  int count() const;
  /// Makes one.
  explicit Unit(int n);
  /// Calls f(x) for each, in order:
  ///   - first the large ones: {" ".join(["word"] * 20)}
  ///   - then the small ones: {" ".join(["word"] * 20)}
  template <class F, class... Rest>
  requires std::is_arithmetic_v<F>
  void each(const F& f) const;
}};
/// The most there are.
inline constexpr std::size_t most = std::size_t{{1}} << 3;
/// A table.
using Table = std::function<void(int)>;
""",
    "common/good.cpp": "/// Finds it.\nint f() { return 0; }  // a place\n",
    "tests/any.h": f"/// Of {LONG}.\nint likewise();\n",
}
VERB = "begins with a verb"
FAULTS = [
    ("common/a.h", "/// The number.\nint f();\n", VERB),
    ("common/a.h", "/// Whether it is.\ntemplate <class T>\nbool f(const T& t);\n", VERB),
    ("common/a.h", "struct A {\n  /// `x` is it.\n  explicit A(int x);\n};\n", VERB),
    ("common/a.h", "struct A {\n  /// Null while there is none.\n  virtual std::optional<int> f(int x = 1) const = 0;\n};\n", VERB),
    ("common/a.h", "/// Points of it.\ninline bool operator<(const A& a,\n                      const A& b) {\n", VERB),
    ("common/a.h", f"/// Returns {LONG}.\nint f();\n", "32 words"),
    ("common/a.h", f"// {LONG}.\n\nint x;\n", "31 words"),
    ("common/a.h", f"int x;  // {LONG}\n", "31 words"),
    ("common/a.h", "int x;  // likewise\n", "says likewise"),
    ("common/a.h", "/// Returns one. Likewise.\nint f();\n", "says likewise"),
    ("common/a.cpp", "/// The number.\nint f() { return 0; }\n", VERB),
    ("common/a.cpp", f"int f() {{\n  // {LONG}.\n}}\n", "31 words"),
    ("common/a.cpp", "int x;  // the same\n", "is the same alone"),
    ("common/a.cpp", "// Of these the last.\nint x;\n", "begins with Of, From or To"),
    ("common/a.cpp", "/// From here to there.\nint x;\n", "begins with Of, From or To"),
    ("common/a.cpp", "/// To its end.\nint x;\n", "begins with Of, From or To"),
    ("common/a.cpp", "int f();  // that is part of it\n", "says part of it"),
    ("elsewhere/a.h", "int x;\n", "is neither held nor waiting"),
]


def check(file=None, text=""):
    shutil.rmtree(work, ignore_errors=True)
    for name, content in {**GOOD, **({file: text} if file else {})}.items():
        (work / name).parent.mkdir(parents=True, exist_ok=True)
        (work / name).write_text(content)
    told = subprocess.run([checker, "--root", str(work)], capture_output=True, text=True)
    return told.returncode, told.stdout + told.stderr


status, text = check()
if status or "2 files good" not in text:
    sys.exit(f"a good tree gave status {status}:\n{text}")
for file, fault, words in FAULTS:
    status, text = check(file, fault)
    if status != 1 or words not in text or "comments: 1 faults" not in text:
        sys.exit(f"expected one fault, \"{words}\", of:\n{fault}\nstatus {status}:\n{text}")
print("ok: each fault is found, and none where there is none")
