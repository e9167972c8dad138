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


def journal_rows(folder, table):
    """In order, each a dictionary."""
    journal = sqlite3.connect(folder / "journal.sqlite")
    journal.row_factory = sqlite3.Row
    return [dict(row) for row in journal.execute(f"SELECT * FROM {table}")]


def topology_revisions(folder):
    return journal_rows(folder, "topology")


def participants(folder):
    """Their names, by the journal's ids."""
    return {row["participant"]: row["name"] for row in journal_rows(folder, "event")}


def finish():
    sys.exit("\n".join(failures) if failures else 0)
