#!/usr/bin/env python3
"""Checks what demo_cut.sh left in DIR: everyone's summary, the observer's log and the server's journal."""

import json
import pathlib
import sqlite3
import sys

folder = pathlib.Path(sys.argv[1])
failures = []


def check(what, holds):
    print(("ok    " if holds else "FAILED"), what)
    if not holds:
        failures.append(what)


clients = {file.stem: json.loads(file.read_text()) for file in folder.glob("*.json")}
clients = {name: figures for name, figures in clients.items() if "topology_hash" in figures}
expected = {"observer", "close", "latecomer", "first", "second"}
check(f"all of them say what they saw: {sorted(clients)}", expected <= set(clients))
if "unplugged" not in clients:
    print("      nobody was cut off the network: demo_cut.sh says why")
hashes = {name: figures["topology_hash"] for name, figures in clients.items()}
check(f"all end with one topology: {hashes}", len(set(hashes.values())) == 1)
check("nobody saw a contradiction", all(figures["contradictions"] == 0 for figures in clients.values()))

lines = [json.loads(line) for line in (folder / "log.jsonl").read_text().splitlines()]
check("that topology isn't the scene's", lines[0]["topology"] not in hashes.values())
check("the observer watched it change", len({line["topology"] for line in lines}) > 10)

journal = sqlite3.connect(folder / "journal.sqlite")
cuts = journal.execute("SELECT author, piece_of FROM topology WHERE cause = 1").fetchall()
check("two people cut", len({author for author, _ in cuts}) == 2)
check(f"they cut often: {len(cuts)} revisions", len(cuts) > 30)
# Whether the last face parts depends on how the hand came to hold the knife, which no two sessions on a clock share.
print("      pieces that came free:", sum(piece_of >= 0 for _, piece_of in cuts))
check("there are pictures of before, during and after",
      all((folder / f"{view}{moment}.png").stat().st_size > 0
          for view in ("", "close-") for moment in ("before", "opened", "during", "through", "after", "face")))

sys.exit("\n".join(failures) if failures else 0)
