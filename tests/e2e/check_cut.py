#!/usr/bin/env python3
"""Checks what cut_test.sh left in DIR: summaries of all clients, the server's summary and its journal."""

import json
import pathlib
import re
import sqlite3
import sys

folder = pathlib.Path(sys.argv[1])
failures = []


def check(what, holds):
    print(("ok    " if holds else "FAILED"), what)
    if not holds:
        failures.append(what)


clients = {name: json.loads((folder / f"{name}.json").read_text())
           for name in ("observer", "latecomer", "first", "second")}
hashes = {name: c["topology_hash"] for name, c in clients.items()}
check(f"all clients end with one topology: {hashes}", len(set(hashes.values())) == 1)
check("nobody saw a contradiction", all(c["contradictions"] == 0 for c in clients.values()))

journal = sqlite3.connect(folder / "journal.sqlite")
revisions = journal.execute("SELECT * FROM topology").fetchall()
columns = [c[1] for c in journal.execute("PRAGMA table_info(topology)")]
rows = [dict(zip(columns, r)) for r in revisions]
print(f"      {len(rows)} revisions in the journal; columns: {', '.join(columns)}")
check("the block was cut often", sum(r["cause"] == 1 for r in rows) > 10)
check("two people cut", len({r["author"] for r in rows if r["cause"] == 1}) == 2)
check("a cut was taken back", any(r["cause"] == 2 for r in rows))
rewound = [r for r in rows if r["cause"] == 3 and r["body"] == rows[0]["body"]]
then = next(r for r in rows if r["body"] == rows[0]["body"] and r["revision"] == 4)
check("the host rewound, once", len(rewound) == 1)
check("to the mesh of then", rewound[0]["content_hash"] == then["content_hash"] and rewound[0]["revision"] > 4)
check("the other was refused", "only the host rewinds" in (folder / "second.log").read_text())
told = re.search(r"^block: revision (\d+), rewound by first", (folder / "first.log").read_text(), re.M)
check("the host is told so", told is not None and int(told[1]) == rewound[0]["revision"])

sys.exit("\n".join(failures) if failures else 0)
