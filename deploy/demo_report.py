#!/usr/bin/python3
"""Joins what the processes of the demo measured into DIR/summary.json and prints it.

Latency from device to observer: the simulated tracker logs when it sent the first byte of each record and the values in it;
the headset user logs which values went into which input; the observer logs when the first snapshot that had consumed that
input arrived. The records are matched by their exact float32 values, all times are CLOCK_MONOTONIC of one machine.
"""

import csv
import json
import pathlib
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


def device_to_observer_ms(folder):
    sent = {}
    with open(folder / "tracker.csv", newline="") as stream:
        for time_ns, _station, _record, *values in list(csv.reader(stream))[1:]:
            sent.setdefault(tuple(float32(v) for v in values), int(time_ns))
    consumed = {}
    for row in rows(folder / "headset.csv"):
        consumed[int(row["sequence"])] = tuple(float32(row[f"r{k}"]) for k in range(7))
    latencies = []
    for row in rows(folder / "observer.csv"):
        values = consumed.get(int(row["sequence"]))
        if values in sent:
            latencies.append(1e-6 * (int(row["arrived_ns"]) - sent[values]))
    return latencies


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
    (folder / "summary.json").write_text(json.dumps(summary, indent=2) + "\n")
    print(json.dumps(summary, indent=2))
    missing = [k for k, v in summary.items() if v is None]
    if missing:
        sys.exit(f"demo: no figure for {', '.join(missing)}")


if __name__ == "__main__":
    main()
