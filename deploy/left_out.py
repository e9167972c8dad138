#!/usr/bin/python3
"""left_out.py list|stay|rest BUILD_DIR WHERE... [-- CTEST_FILTER...]: splits a build's tests by deploy/left_out.txt. WHERE: all, asan, package.
left_out.py slow JUNIT SECONDS: prints what deploy/slow_sanitized.txt is to hold.

list: names what is left out there. stay, rest: prints the numbers of the other tests, and of these, as `ctest -I FILE` wants them
(not a regular expression: ctest silently ignored one of 40 groups, and ran everything). ctest counts what its other filters choose
(-L, -R, -E), so they must be told here, too.
Refuses a row that matches no test of BUILD_DIR, and one whose stand-in does not stay. Rows about programs that are not built there are
passed over, and stand-ins of such programs are not looked for. A row may be about tests that the filters don't choose. `asan` leaves out what deploy/slow_sanitized.txt names, too: each of them must be a test of BUILD_DIR, and of each
executable some must stay.
"""
import json
import pathlib
import re
import subprocess
import sys

import junit

table = pathlib.Path(__file__).with_name("left_out.txt")
slow_ones = pathlib.Path(__file__).with_name("slow_sanitized.txt")


def rows():
    for number, line in enumerate(table.read_text().splitlines(), 1):
        words = line.split("#")[0].split()
        if not words:
            continue
        if len(words) != 3 or words[0] not in ("all", "package"):
            sys.exit(f"{table.name}:{number}: expected 'all|package TESTS STAND-IN', got: {line}")
        yield f"{table.name}:{number}", *words


def tests_of(build, filters):
    """Names in ctest's order, which is that of its numbers."""
    told = subprocess.run(["ctest", "--test-dir", build, *filters, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    return [test["name"] for test in json.loads(told.stdout)["tests"]]


def left_out(every, wheres):
    """Names that WHERES leave out of every test of the build."""
    unbuilt = {match[1] for name in every if (match := re.fullmatch(r"test_(\w+)_NOT_BUILT", name))}
    wanted = [row for row in rows() if row[1] in wheres and not is_of(unbuilt, row[2])]
    out = {name for name in every if any(re.search(tests, name) for _, _, tests, _ in wanted)}
    for place, _, tests, stand_in in wanted:
        if not any(re.search(tests, name) for name in every):
            sys.exit(f"{place}: no test matches {tests}")
        if not is_of(unbuilt, stand_in) and not any(re.search(stand_in, name) for name in every if name not in out):
            sys.exit(f"{place}: {stand_in} should remain, but is omitted or is not a test")
    return out | slow(every, out) if "asan" in wheres else out


def is_of(programs, tests):
    """Whether a row's expression names tests of one of these programs."""
    match = re.match(r"\^(\w+)\\\.", tests)
    return match is not None and match[1] in programs


def slow(every, out):
    """Names that deploy/slow_sanitized.txt leaves out, beside OUT."""
    named = {line for line in slow_ones.read_text().splitlines() if line and not line.startswith("#")}
    if strange := named - set(every):
        sys.exit(f"{slow_ones.name}: no test is named {min(strange)}")
    stay = {program_of(name) for name in every if name not in out | named}
    if gone := {program_of(name) for name in named} - stay:
        sys.exit(f"{slow_ones.name}: nothing remains of {min(gone)}")
    return named


def program_of(name):
    return name.split(".")[0]


def tell_slow(report, seconds):
    """Prints the tests of a report that took longer."""
    print(f"# Tests that took more than {seconds:g} s each under the preset asan, two at a time on two cores.\n"
          "# The gate runs them optimised, the nightly run under sanitizers. deploy/left_out.py slow makes this list.")
    cases = sorted(junit.cases_of(report), key=junit.seconds)
    fastest = {program_of(junit.name(case)): junit.name(case) for case in reversed(cases)}.values()  # stay in any case
    print("\n".join(sorted(name for case in cases if junit.seconds(case) > seconds and (name := junit.name(case)) not in fastest)))


def main():
    words, filters = sys.argv[1:], []
    if "--" in words:
        at = words.index("--")
        words, filters = words[:at], words[at + 1:]
    if words[:1] == ["slow"] and len(words) == 3:
        tell_slow(words[1], float(words[2]))
        return
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
