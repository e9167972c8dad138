#!/usr/bin/python3
"""Joins what the processes of the demo measured into DIR/summary.json and prints it.

Latency from device to observer: the simulated tracker logs when it sent the first byte of each record and the values in it;
the headset user logs which values went into which input; the observer logs when the first snapshot that had consumed that
input arrived. The records are matched by their exact float32 values, all times are CLOCK_MONOTONIC of one machine.

Latency from camera to observer, where there is a camera user: from the middle of a picture's exposure, as the camera user
logs it of each input, until the same moment.
"""

import csv
import json
import pathlib
import sqlite3
import struct
import sys


def rows(path):
    with open(path, newline="") as stream:
        return list(csv.DictReader(stream))


def float32(text):
    return struct.pack("<f", float(text))


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else None


def arrivals(folder, name):
    """When the observer first saw each input of the participant of that name, ns."""
    with sqlite3.connect(folder / "journal.sqlite") as journal:
        # SQLite's integers have signs, ids have none.
        ids = {str(row[0] % (1 << 64)) for row in journal.execute("SELECT participant FROM event WHERE name = ?", (name,))}
    return {int(row["sequence"]): int(row["arrived_ns"]) for row in rows(folder / "observer.csv") if row["participant"] in ids}


def device_to_observer_ms(folder):
    sent = {}
    with open(folder / "tracker.csv", newline="") as stream:
        for time_ns, _station, _record, *values in list(csv.reader(stream))[1:]:
            sent.setdefault(tuple(float32(v) for v in values), int(time_ns))
    consumed = {}
    for row in rows(folder / "headset.csv"):
        consumed[int(row["sequence"])] = tuple(float32(row[f"r{k}"]) for k in range(7))
    latencies = []
    for sequence, arrived_ns in arrivals(folder, "headset user").items():
        values = consumed.get(sequence)
        if values in sent:
            latencies.append(1e-6 * (arrived_ns - sent[values]))
    return latencies


def camera_to_observer_ms(folder):
    """Of each picture that showed a hand: by the first input with it that the observer saw."""
    arrived = arrivals(folder, "camera user")
    first = {}
    for row in rows(folder / "camera.csv"):
        sequence = int(row["sequence"])
        if sequence in arrived:
            first.setdefault(int(row["seen_ns"]), arrived[sequence])
    return [1e-6 * (arrived_ns - seen_ns) for seen_ns, arrived_ns in first.items()]


def add_reference(server):
    """Puts the force of a finer model, found once, beside that of the press, where this is the press that it was found of."""
    reference = json.loads(pathlib.Path(__file__).with_name("demo").joinpath("reference.json").read_text())
    press = server.get("pressed", {}).get(reference["body"])
    if press is None or any(server[key] != reference[key] for key in ("scene", "tets")):
        return
    press["reference"] = {key: reference[key] for key in ("force_n", "unsettled", "model", "command")}
    press["off_reference"] = press["force_n"] / reference["force_n"] - 1


def main():
    folder = pathlib.Path(sys.argv[1])
    server = json.loads((folder / "server.json").read_text())
    observer = json.loads((folder / "observer.json").read_text())
    add_reference(server)
    latencies = device_to_observer_ms(folder)
    summary = {
        **server,
        "device_to_observer_ms_p50": percentile(latencies, 0.50),
        "device_to_observer_ms_p99": percentile(latencies, 0.99),
        "device_to_observer_samples": len(latencies),
        "late_join_ms": observer["late_join_ms"],
        "first_picture_ms": observer["first_picture_ms"],
        "observer_ms_per_picture": observer["ms_per_picture"],
        "observer_playout_delay_ms": observer["playout_delay_ms"],
        "observer_kbit_s": observer.get("stream_kbit_s"),
        "topology_hash": observer["topology_hash"],
    }
    if (folder / "camera.csv").exists():
        hands = camera_to_observer_ms(folder)
        summary |= {"camera_to_observer_ms_p50": percentile(hands, 0.50), "camera_to_observer_ms_p99": percentile(hands, 0.99),
                    "camera_to_observer_samples": len(hands)}
    (folder / "summary.json").write_text(json.dumps(summary, indent=2) + "\n")
    print(json.dumps(summary, indent=2))
    missing = [k for k, v in summary.items() if v is None]
    if missing:
        sys.exit(f"demo: no figure for {', '.join(missing)}")


if __name__ == "__main__":
    main()
