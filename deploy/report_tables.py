"""Reports of prosector-bench, and how their figures are written into tables."""

import json
import math

DASH = "–"

class Missing(Exception):
    """A table's report was not given."""

class Reports:
    def __init__(self, folder):
        self.all = {}
        for file in sorted(folder.glob("*.json")):
            report = json.loads(file.read_text())
            self.all.setdefault(report["bench"], []).append(report)

    def of(self, bench):
        if bench not in self.all:
            raise Missing(bench)
        return self.all[bench]

    def rows(self, bench, **settings):
        found = [row for report in self.of(bench) for row in report["rows"]]
        return [row for row in found if all(row.get(key) == value for key, value in settings.items())]

def number(value):
    """Three digits that count."""
    if value is None or not math.isfinite(value):
        return DASH
    size = abs(value)
    if size == 0:
        return "0"
    if size >= 1e7 or size < 1e-4:
        return f"{value:.1e}"
    return f"{value:.{max(0, 2 - math.floor(math.log10(size)))}f}"

def kept(before, what):
    """The lines of a table as it was whose first cell starts so."""
    lines = [[cell.strip() for cell in line.strip("| ").split(" |")] for line in before.splitlines() if line.startswith("|")]
    return [line for line in lines if line[0].startswith(what)]

def percent(value):
    return DASH if value is None else f"{number(100 * value)} %"

def table(heads, rows):
    """A pipe stands close to the cell behind it: these tables are wide."""
    lines = ["|" + " |".join(str(cell) for cell in line) + "|\n" for line in [heads, *rows]]
    return lines[0] + "|---" * len(heads) + "|\n" + "".join(lines[1:])

def grouped(rows, *keys):
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row.get(key) for key in keys), []).append(row)
    return groups

def count(value):
    return f"{value:,}"

def rung(row):
    """Returns the configuration from model to effort, as text."""
    effort = row.get("effort")
    if not effort and row.get("newton_iterations"):
        effort = f"{row['newton_iterations']} × {row['solver_iterations']} to {row['solver_tolerance']:.0e}"
    elif not effort and row.get("solver_iterations"):
        effort = f"× {row['solver_iterations']}"
    solver = " ".join(part for part in (row["solver"], effort) if part)
    return f"`{row['model']}`, {row['element']}, {row['integrator']}, {solver}"
