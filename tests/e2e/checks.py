"""What checks of a session's leavings have in common."""

import json
import sqlite3
import sys

failures = []


def check(what, holds):
    print(("ok    " if holds else "FAILED"), what)
    if not holds:
        failures.append(what)


def figures(file):
    return json.loads(file.read_text())


def check_one_topology(clients):
    """`clients`: their figures, by name."""
    hashes = {name: figures["topology_hash"] for name, figures in clients.items()}
    check(f"all end with one topology: {hashes}", len(set(hashes.values())) == 1)
    check("nobody saw a contradiction", all(figures["contradictions"] == 0 for figures in clients.values()))
    return hashes


def topology_revisions(folder):
    """The journal's, in order, each a dictionary."""
    journal = sqlite3.connect(folder / "journal.sqlite")
    journal.row_factory = sqlite3.Row
    return [dict(row) for row in journal.execute("SELECT * FROM topology")]


def finish():
    sys.exit("\n".join(failures) if failures else 0)
