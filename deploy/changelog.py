#!/usr/bin/python3
"""changelog.py [--root ROOT] check | show | release VERSION DATE: the changelog's next section, from fragments.

Each change adds a file docs/changes/TOPIC.KIND.md, so that parallel changes do not edit the same lines. KIND is one of
KINDS. A fragment is one entry: sentences for a reader of the changelog. A compatibility fragment is one row of the table of
journals and protocol, without the outer bars: change | sessions that replay otherwise | journal format | protocol.

check reports fragments with another name, without text or with a wrong number of columns, and entries that were written
directly below [Unreleased]. show prints the next section. release writes it into CHANGELOG.md and deletes the fragments.
"""

import argparse
import pathlib
import re
import sys

KINDS = {"compatibility": "Compatibility of journals and protocol", "added": "Added", "changed": "Changed",
         "deprecated": "Deprecated", "removed": "Removed", "fixed": "Fixed"}
TABLE = "| Change | Sessions that replay otherwise | Journal format | Protocol |\n|---|---|---|---|\n"
UNRELEASED = "## [Unreleased]\n"


def fragments(root):
    """(file, kind, text) of each fragment, by name; the kind of a file with another name is empty."""
    for file in sorted((root / "docs/changes").glob("*")):
        if file.name == "README.md":
            continue
        found = re.fullmatch(r"[a-z0-9-]+\.([a-z]+)\.md", file.name)
        yield file, found[1] if found and found[1] in KINDS else "", " ".join(file.read_text().split())


def faults(root):
    for file, kind, text in fragments(root):
        if not kind:
            yield f"{file.name}: name a fragment TOPIC.KIND.md, with small letters, digits and hyphens; KIND is {', '.join(KINDS)}"
        elif not text:
            yield f"{file.name}: is empty"
        elif kind == "compatibility" and text.count("|") != 3:
            yield f"{file.name}: has {text.count('|') + 1} columns; write change | sessions | journal format | protocol"
        elif text.startswith(("-", "#", "*")):
            yield f"{file.name}: begins with {text[0]}; write the entry's text alone"
    log = (root / "CHANGELOG.md").read_text()
    if UNRELEASED not in log:
        yield "CHANGELOG.md: has no section [Unreleased]"
    elif section_after(log).strip():
        yield "CHANGELOG.md: has entries below [Unreleased]; write each into a file of docs/changes"


def section_after(log):
    """The text between [Unreleased] and the next version's heading."""
    return re.split(r"^## ", log.split(UNRELEASED, 1)[1], maxsplit=1, flags=re.M)[0]


def entries(root):
    """The next section's text, without its heading."""
    found, text = list(fragments(root)), ""
    for kind, heading in KINDS.items():
        texts = [entry for _, of, entry in found if of == kind]
        if texts:
            lines = [f"| {entry} |" for entry in texts] if kind == "compatibility" else [f"- {entry}" for entry in texts]
            text += f"\n### {heading}\n\n" + (TABLE if kind == "compatibility" else "") + "\n".join(lines) + "\n"
    return text


def release(root, version, date):
    log = root / "CHANGELOG.md"
    before, after = log.read_text().split(UNRELEASED, 1)
    log.write_text(f"{before}{UNRELEASED}\n## [{version}] - {date}\n{entries(root)}{after}")
    for file, _, _ in list(fragments(root)):
        file.unlink()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("check")
    commands.add_parser("show")
    releasing = commands.add_parser("release")
    releasing.add_argument("version")
    releasing.add_argument("date")
    arguments = parser.parse_args()
    found = list(faults(arguments.root))
    for fault in found:
        print(f"changelog: {fault}", file=sys.stderr)
    if found:
        return 1
    if arguments.command == "check":
        print(f"changelog: {sum(1 for _ in fragments(arguments.root))} fragments good")
    elif arguments.command == "show":
        print(entries(arguments.root).strip())
    else:
        release(arguments.root, arguments.version, arguments.date)
    return 0


if __name__ == "__main__":
    sys.exit(main())
