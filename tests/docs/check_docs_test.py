#!/usr/bin/python3
"""check_docs_test.py CHECKER WORK: what deploy/check_docs.py says of a small tree with one fault of each kind."""

import pathlib
import shutil
import subprocess
import sys

checker, work = sys.argv[1], pathlib.Path(sys.argv[2])
LONG = " ".join(["word"] * 31) + "."
GOOD = {
    "README.md": "# One\n\nSee [the map](docs/README.md).\n",
    "CHANGELOG.md": "# Changes\n",
    "docs/README.md": "# Map\n\n[Page](do/page.md#some-steps-of-x), [decisions](decisions/0001.md).\n",
    "docs/do/page.md": f"# Page\n\n## Some `steps` of X\n\n| {LONG} |\n|---|\n| {LONG} |\n\n```sh\n{LONG} [x](nowhere.md)\n```\n\n"
                       f"{' '.join(['word'] * 30)}. Another. `Code` here: (see above.) Then more.\n",
    "server/b.h": "// See docs/do/page.md.\n",
    "docs/decisions/0001.md": f"# One\n\n{LONG}\n",
}
FAULTS = [
    ("docs/do/page.md", f"\n{LONG}\n", "31 words"),
    ("docs/do/page.md", f"\n- item\n  {' '.join(['word'] * 30)}.\n", "31 words"),
    ("docs/do/page.md", "\n[gone](gone.md)\n", "is not there"),
    ("docs/README.md", "\n[gone](do/page.md#gone)\n", "no heading for #gone"),
    ("docs/do/page.md", "\nIn `server/b.h` and `server/NAME.h`, not in `server/c.h`.\n", "names server/c.h"),
    ("docs/look-up/lost.md", "# Lost\n", "no index lists"),
    ("docs/do/page.md", "\n| a | b |\n|---|---|\n| 1 | 2 |\n\n| 3 | 4 |\n", "a table without a heading"),
    ("server/a.h", "// See docs/lost.md.\n", "names docs/lost.md"),
]


def check(page=None, text="", beside=None):
    shutil.rmtree(work, ignore_errors=True)
    for name, content in {**GOOD, **(beside or {})}.items():
        (work / name).parent.mkdir(parents=True, exist_ok=True)
        (work / name).write_text(content)
    if page:
        (work / page).parent.mkdir(parents=True, exist_ok=True)
        with (work / page).open("a") as out:
            out.write(text)
    told = subprocess.run([checker, str(work)], capture_output=True, text=True)
    return told.returncode, told.stdout + told.stderr


status, text = check()
if status or "3 pages good" not in text:
    sys.exit(f"a good tree gave status {status}:\n{text}")
for page, fault, words in FAULTS:
    status, text = check(page, fault)
    if status != 1 or words not in text or "docs: 1 faults" not in text:
        sys.exit(f"expected one fault, \"{words}\", in {page}; status {status}:\n{text}")
status, text = check("docs/do/page.md", "\n[Linked](linked.md)\n", {"docs/do/linked.md": "# Linked\n"})
if status != 1 or "docs/do/linked.md:1: no index lists" not in text:
    sys.exit(f"a page that only another page links to passed:\n{text}")
print("ok: each fault is found, and none where there is none")
