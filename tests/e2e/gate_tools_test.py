#!/usr/bin/python3
"""gate_tools_test.py DEPLOY WORK: what deploy/test_report.py and deploy/nightly_figures.py say of reports that stand here."""
import json
import pathlib
import shutil
import subprocess
import sys

deploy, work = map(pathlib.Path, sys.argv[1:])
work.mkdir(parents=True, exist_ok=True)
report = """<testsuite name="x" tests="4">
 <testcase name="soft.Beam.Bends" time="2.5" status="run"><system-out>[       OK ] Beam.Bends (3 ms)</system-out></testcase>
 <testcase name="soft.Beam.Swings" time="0.1" status="fail"><failure message=""/><system-out>no\x1b[0m &#x1b; \x02</system-out></testcase>
 <testcase name="soft.Beam.Whole" time="0.1" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
  <system-out>liver_test.cpp:22: Skipped
liver.inr.gz is not below /data

[  SKIPPED ] Beam.Whole (0 ms)
[  SKIPPED ] 1 test, listed below:
[  SKIPPED ] Beam.Whole
</system-out></testcase>
 <testcase name="view.all" time="1" status="run"><system-out>view_test.cpp:9: Skipped
no display

[  SKIPPED ] View.OnAScreen (0 ms)
</system-out></testcase>
</testsuite>
"""
(work / "tests.xml").write_text(report)


def run(*words):
    told = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    return told.returncode, told.stdout + told.stderr


def expect(what, text):
    if what not in text:
        sys.exit(f"expected: {what}\nin:\n{text}")


_, text = run(deploy / "test_report.py", "--slowest", "1", f"release={work / 'tests.xml'}")
for line in ("release: 4 entries, 1 failed, 2 skipped", "failed   soft.Beam.Swings",
             "skipped  soft.Beam.Whole: liver.inr.gz is not below /data", "skipped  view.View.OnAScreen: no display",
             "2.5 s soft.Beam.Bends"):
    expect(line, text)
expect("no " + str(work / "none.xml"), run(deploy / "test_report.py", f"asan={work / 'none.xml'}")[1])

(work / "runs.tsv").write_text("seeds\t7\t8\t90\ttests.xml\nasan\t-\t0\t30\ttests.xml\n")
status, text = run(deploy / "nightly_figures.py", work, "seeds", "play")
expect("| seeds | 1 | 4 | 2 | seed 7: soft.Beam.Swings | 1.5 |", text)
expect("| play | 0 | 0 | 0 | did not run | 0.0 |", text)
if status != 1:
    sys.exit(f"a failed run and a part that did not run gave status {status}")
if json.loads((work / "figures.json").read_text())["parts"][0]["failed"][0]["seed"] != "7":
    sys.exit("figures.json does not tell the seed that failed")
status, text = run(deploy / "nightly_figures.py", work, "asan")
if status != 0:
    sys.exit(f"runs that all passed gave status {status}: {text}")
for words in (["--hours", "x"], ["--hours", "0"], ["--only", "nothing"], ["--wrong"]):
    status, text = run(deploy / "nightly.sh", *words)
    if status != 2:
        sys.exit(f"nightly.sh {' '.join(words)} gave status {status}: {text}")
    expect("nightly: " + ("--hours" if words[0] == "--hours" else words[0]), text)

# What stays is what ctest runs, also where other filters choose among the tests: it counts what those leave.
tree = work / "tree"
tree.mkdir(exist_ok=True)
for name in ("left_out.py", "junit.py"):
    shutil.copy(deploy / name, work)
(work / "left_out.txt").write_text(r"all ^soft\.Long$ ^soft\.Short$" + "\n")
labelled = {"whole.Program": "slow", "soft.Short": "unit", "soft.Long": "unit", "soft.Other": "unit"}
(tree / "CTestTestfile.cmake").write_text("".join(
    f'add_test([=[{name}]=] "true")\nset_tests_properties([=[{name}]=] PROPERTIES LABELS {label})\n'
    for name, label in labelled.items()))
for filters, wanted in (([], ["whole.Program", "soft.Short", "soft.Other"]), (["-L", "^unit$"], ["soft.Short", "soft.Other"])):
    _, numbers = run(work / "left_out.py", "stay", tree, "all", "--", *filters)
    (work / "numbers").write_text(numbers)
    _, text = run("ctest", "--test-dir", tree, "-N", "-I", work / "numbers", *filters)
    chosen = [line.split(": ")[1] for line in text.splitlines() if "  Test " in line and "#" in line]
    if chosen != wanted:
        sys.exit(f"{filters}: chosen {chosen}, wanted {wanted}")

# Under sanitizers what took longest is left out by name, as a report told; never all of an executable.
_, slow = run(work / "left_out.py", "slow", work / "tests.xml", "1.5")
expect("\nsoft.Beam.Bends\n", slow)
for names, status, words in (("soft.Other\n", 0, "soft.Long\nsoft.Other\n"), (slow, 1, "no test is named soft.Beam.Bends"),
                             ("soft.Other\nsoft.Short\n", 1, "nothing remains of soft")):
    (work / "slow_sanitized.txt").write_text(names)
    found, text = run(work / "left_out.py", "list", tree, "all", "asan")
    expect(words, text)
    if found != status:
        sys.exit(f"{names!r} gave status {found}")
