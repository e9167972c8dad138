#!/usr/bin/python3
"""changelog_test.py CHANGELOG_PY FOLDER: changelog.py on made-up fragments."""

import pathlib
import shutil
import subprocess
import sys

PROGRAM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
LOG = "# Changelog\n\n## [Unreleased]\n\n## [1.0.0] - 2020-01-01\n\n### Added\n\n- All.\n"


def run(files, *arguments, log=LOG):
    shutil.rmtree(FOLDER, ignore_errors=True)
    (FOLDER / "docs/changes").mkdir(parents=True)
    (FOLDER / "CHANGELOG.md").write_text(log)
    for name, text in files.items():
        (FOLDER / "docs/changes" / name).write_text(text)
    return subprocess.run([PROGRAM, "--root", FOLDER, *arguments], capture_output=True, text=True)


def expect(result, status, *texts):
    assert result.returncode == status, result
    for text in texts:
        assert text in result.stdout + result.stderr, (text, result)


GOOD = {"README.md": "# Not a fragment\n", "b.fixed.md": "A fault\nis gone.\n", "a.added.md": "A feature.\n",
        "wire.compatibility.md": "a message | none | 15 | 11\n"}
expect(run(GOOD, "check"), 0, "3 fragments good")
expect(run(GOOD, "show"), 0, "- A fault is gone.", "| a message | none | 15 | 11 |")
expect(run({"a.news.md": "x\n"}, "check"), 1, "a.news.md", "compatibility, added")
expect(run({"a.added.md": "\n"}, "check"), 1, "a.added.md: is empty")
expect(run({"a.added.md": "- x\n"}, "check"), 1, "begins with -")
expect(run({"a.compatibility.md": "x | y\n"}, "check"), 1, "2 columns")
expect(run({}, "check", log=LOG.replace("## [1", "- An entry.\n\n## [1")), 1, "entries below [Unreleased]")

expect(run(GOOD, "release", "1.1.0", "2020-02-02"), 0)
written = (FOLDER / "CHANGELOG.md").read_text()
order = ["## [Unreleased]\n\n## [1.1.0] - 2020-02-02\n", "### Compatibility", "### Added\n\n- A feature.\n", "### Fixed\n\n- A fault is gone.\n",
         "\n## [1.0.0]"]
places = [written.index(text) for text in order]
assert places == sorted(places), written
assert [file.name for file in (FOLDER / "docs/changes").iterdir()] == ["README.md"]
