#!/usr/bin/python3
"""test_report.py [--slowest N] NAME=JUNIT...: counts, skipped tests with reasons and the slowest of ctest's JUnit files."""
import pathlib
import sys

import junit


def tell(name, path, slowest):
    if not pathlib.Path(path).exists():
        print(f"{name}: no {path}: run ctest first")
        return
    cases = junit.cases_of(path)
    failed = [junit.name(case) for case in cases if junit.failed(case)]
    skipped = [skip for case in cases for skip in junit.skipped(case)]
    minutes = sum(map(junit.seconds, cases)) / 60
    print(f"{name}: {len(cases)} entries, {len(failed)} failed, {len(skipped)} skipped; {minutes:.1f} min, one after another")
    for test in failed:
        print(f"  failed   {test}")
    for test, reason in skipped:
        print(f"  skipped  {test}: {reason or 'no reason given'}")
    for case in sorted(cases, key=junit.seconds, reverse=True)[:slowest]:
        print(f"  {junit.seconds(case):6.1f} s {junit.name(case)}")


def main():
    words, slowest = sys.argv[1:], 0
    if words[:1] == ["--slowest"] and len(words) > 1:
        slowest, words = int(words[1]), words[2:]
    if not words or not all("=" in word for word in words):
        sys.exit(__doc__)
    for word in words:
        tell(*word.split("=", 1), slowest)


main()
