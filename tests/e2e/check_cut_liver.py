#!/usr/bin/python3
"""Checks what demo_cut.sh left in DIR: everyone's summary, the observer's log and the server's journal."""

import json
import pathlib
import sys

from checks import check, check_one_topology, figures, finish, participants, topology_revisions

folder = pathlib.Path(sys.argv[1])
clients = {file.stem: figures(file) for file in folder.glob("*.json")}
clients = {name: known for name, known in clients.items() if "topology_hash" in known}
expected = {"observer", "close", "latecomer", "first", "second"}
check(f"all of them say what they saw: {sorted(clients)}", expected <= set(clients))
if "unplugged" not in clients:
    print("      nobody was cut off the network: demo_cut.sh says why")
hashes = check_one_topology(clients)

lines = [json.loads(line) for line in (folder / "log.jsonl").read_text().splitlines()]
check("that topology isn't the scene's", lines[0]["topology"] not in hashes.values())
check("the observer watched it change", len({line["topology"] for line in lines}) > 10)

cuts = [row for row in topology_revisions(folder) if row["cause"] == 1]
check("two people cut", len({cut["author"] for cut in cuts}) == 2)
check(f"they cut often: {len(cuts)} revisions", len(cuts) > 30)
pieces = [row for row in cuts if row["piece_of"] >= 0]
names = participants(folder)
parts = lines[-1]["parts"]
for lobe, is_on_its_side in (("left", lambda x: x > 0), ("right", lambda x: x < 0)):
    fallen = [name for name, part in parts.items() if name.startswith("liver piece") and max(part["size"]) > 0.02
              and is_on_its_side(part["at"][0] - part["shift"][0]) and part["shift"][1] < -0.05]
    # The n-th piece of the organ is the n-th that the journal knows of.
    authors = {names[pieces[int(name.split()[-1]) - 1]["author"]] for name in fallen}
    check(f"a piece of the {lobe} lobe came free and fell: {fallen}, cut by {authors}", authors == {"second user"})
check("there are pictures of before, during and after",
      all((folder / f"{view}{moment}.png").stat().st_size > 0
          for view in ("", "close-") for moment in ("before", "opened", "during", "through", "after", "face")))

finish()
