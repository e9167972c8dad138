#!/usr/bin/python3
"""check_assertions.py [ROOT]: the product states its preconditions and invariants by PROSECTOR_ASSERT (common/assert.h).

Counts the assertions below the product's folders and fails below LEAST, so that rewritten code keeps stating what it relies
on. Where assertions go with the code that they were in, lower LEAST in the same commit.
"""

import pathlib
import re
import sys

LEAST = 300
FOLDERS = "client", "common", "drivers", "idl", "server"
ASSERTION = re.compile(r"^(?!\s*(?://|#)).*\bPROSECTOR_ASSERT\(", re.M)


def count(root):
    """The number of assertions below each folder."""
    return {folder: sum(len(ASSERTION.findall(path.read_text(encoding="utf-8")))
                        for path in (root / folder).rglob("*") if path.suffix in (".h", ".cpp")) for folder in FOLDERS}


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent
    by_folder = count(root)
    total = sum(by_folder.values())
    words = f"{total} of at least {LEAST} ({', '.join(f'{folder} {n}' for folder, n in by_folder.items())})"
    if total < LEAST:
        sys.exit(f"assertions: {words}: state preconditions and invariants by PROSECTOR_ASSERT")
    print(f"assertions: good, {words}")


if __name__ == "__main__":
    main()
