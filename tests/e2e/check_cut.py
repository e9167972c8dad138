#!/usr/bin/python3
"""Checks what cut_test.sh left in DIR: summaries of all clients, the server's summary and its journal."""

import pathlib
import re
import sys

from checks import check, check_one_topology, figures, finish, topology_revisions

folder = pathlib.Path(sys.argv[1])
check_one_topology({name: figures(folder / f"{name}.json") for name in ("observer", "latecomer", "first", "second")})

rows = topology_revisions(folder)
print(f"      {len(rows)} revisions in the journal")
check("the block was cut often", sum(r["cause"] == 1 for r in rows) > 10)
if not rows:
    finish()
check("two people cut", len({r["author"] for r in rows if r["cause"] == 1}) == 2)
check("a cut was taken back", any(r["cause"] == 2 for r in rows))
rewound = [r for r in rows if r["cause"] == 3 and r["body"] == rows[0]["body"]]
then = next(r for r in rows if r["body"] == rows[0]["body"] and r["revision"] == 4)
check("the host rewound, once", len(rewound) == 1)
check("to the mesh of then", rewound[0]["content_hash"] == then["content_hash"] and rewound[0]["revision"] > 4)
check("the other was refused", "only the host can rewind" in (folder / "second.log").read_text())
told = re.search(r"^block: revision (\d+), rewound by first", (folder / "first.log").read_text(), re.M)
check("the host is told so", told is not None and int(told[1]) == rewound[0]["revision"])

finish()
