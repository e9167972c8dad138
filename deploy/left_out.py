#!/usr/bin/env python3
"""left_out.py BUILD_DIR WHERE...: prints the regular expression of the tests that deploy/left_out.txt leaves out there.

WHERE: all, asan. Refuses rows that match no test of BUILD_DIR, and rows whose representative is left out too.
With --list it prints the tests' names instead.
"""
import json
import pathlib
import re
import subprocess
import sys


def rows(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        words = line.split("#")[0].split()
        if not words:
            continue
        if len(words) != 3 or words[0] not in ("all", "asan"):
            sys.exit(f"{path.name}:{number}: expected 'all|asan TESTS REPRESENTATIVE', got: {line}")
        yield number, *words


def tests_of(build):
    told = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    return [test["name"] for test in json.loads(told.stdout)["tests"]]


def main():
    options = [word for word in sys.argv[1:] if word.startswith("--")]
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    if len(words) < 2 or options not in ([], ["--list"]):
        sys.exit(__doc__)
    path = pathlib.Path(__file__).with_name("left_out.txt")
    names = tests_of(words[0])
    wanted = [row for row in rows(path) if row[1] in words[1:]]
    out = "|".join(row[2] for row in wanted) or "^$"
    stays = [name for name in names if not re.search(out, name)]
    for number, _, tests, representative in wanted:
        if not any(re.search(tests, name) for name in names):
            sys.exit(f"{path.name}:{number}: no test matches {tests}")
        if not any(re.search(representative, name) for name in stays):
            sys.exit(f"{path.name}:{number}: {representative}, which should stay, is left out or is no test")
    if options:
        print("\n".join(name for name in names if re.search(out, name)))
    else:
        print(out)


main()
