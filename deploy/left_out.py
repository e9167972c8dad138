#!/usr/bin/env python3
"""left_out.py list|stay|rest BUILD_DIR WHERE... [-- CTEST_FILTER...]: splits a build's tests by deploy/left_out.txt. WHERE: all, asan, package.

list: names what is left out there. stay, rest: prints the numbers of the other tests, and of these, as `ctest -I FILE` wants them
(not a regular expression: ctest silently ignored one of 40 groups, and ran everything). ctest counts what its other filters choose
(-L, -R, -E), so they must be told here, too.
Refuses a row that matches no test of BUILD_DIR, and one whose stand-in does not stay. A row may be about tests that the filters
don't choose.
"""
import json
import pathlib
import re
import subprocess
import sys

table = pathlib.Path(__file__).with_name("left_out.txt")


def rows():
    for number, line in enumerate(table.read_text().splitlines(), 1):
        words = line.split("#")[0].split()
        if not words:
            continue
        if len(words) != 3 or words[0] not in ("all", "asan", "package"):
            sys.exit(f"{table.name}:{number}: expected 'all|asan|package TESTS STAND-IN', got: {line}")
        yield f"{table.name}:{number}", *words


def tests_of(build, filters):
    """Names in ctest's order, which is that of its numbers."""
    told = subprocess.run(["ctest", "--test-dir", build, *filters, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    return [test["name"] for test in json.loads(told.stdout)["tests"]]


def left_out(every, wheres):
    """Names that WHERES leave out of every test of the build."""
    wanted = [row for row in rows() if row[1] in wheres]
    out = {name for name in every if any(re.search(tests, name) for _, _, tests, _ in wanted)}
    for place, _, tests, stand_in in wanted:
        if not any(re.search(tests, name) for name in every):
            sys.exit(f"{place}: no test matches {tests}")
        if not any(re.search(stand_in, name) for name in every if name not in out):
            sys.exit(f"{place}: {stand_in} should stay, but is left out or is no test")
    return out


def main():
    words, filters = sys.argv[1:], []
    if "--" in words:
        at = words.index("--")
        words, filters = words[:at], words[at + 1:]
    if len(words) < 3 or words[0] not in ("list", "stay", "rest"):
        sys.exit(__doc__)
    verb, build, *wheres = words
    names = tests_of(build, filters)
    out = left_out(tests_of(build, []), wheres)
    if verb == "list":
        print("\n".join(name for name in names if name in out))
        return
    numbers = [str(i) for i, name in enumerate(names, 1) if (name in out) == (verb == "rest")]
    if not numbers:
        sys.exit(f"left_out.py: {build}: no tests {verb}")
    print(",0,," + ",".join(numbers))


main()
