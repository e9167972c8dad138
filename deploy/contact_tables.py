"""Tables of contact, of estimated errors and of cuts, which fill_tables.py puts into docs/."""

from report_tables import DASH, Missing, count, grouped, kept, number, percent, table

def contact(reports, before):
    """A line for each figure of a case: the setting nearest to its tolerance; besides it, those that failed.
    Lines of cases that were not run stay."""
    def shown(row, of):
        tolerance = "none" if row["tolerance"] is None else f"± {number(row['tolerance'])}"
        return [row["case"], row["figure"], row["setting"], of, f"{number(row['measured'])} {row['unit'].strip('1')}".strip(),
                number(row["reference"]), tolerance, number(row["ms_per_tick"]), row.get("verdict", DASH)]

    def nearness(row):
        return abs(row["measured"] - row["reference"]) / row["tolerance"] if row["tolerance"] else 0

    rows = [row for row in reports.rows("contact") if row["case"] != "hertz" or row["tolerance"] is not None]
    cases = {}
    for line in kept(before, "")[2:]:
        cases.setdefault(line[0], []).append(line)
    cases |= {row["case"]: [] for row in rows}
    for (case, _), same in grouped(rows, "case", "figure").items():
        nearest = max(same, key=nearness)
        cases[case] += [shown(row, len(same)) for row in same if row is nearest or row.get("verdict", "survives") != "survives"]
    lines = [line for same in cases.values() for line in same]
    return table(["case", "figure", "setting nearest to its tolerance", "settings", "measured", "reference", "tolerance", "CPU ms per tick", "verdict"], lines)

def pressed(reports, case, **settings):
    """Figures of each press of a contact case, by the name of the press."""
    presses = {}
    for row in reports.rows("contact", case=case, **settings):
        presses.setdefault(row["setting"], {})[row["figure"]] = row["measured"]
    if not presses:
        raise Missing(f"contact, case {case}")
    return presses

def usual(reports):
    lines = []
    for setting, of in pressed(reports, "usual").items():
        layer, depth, nu = (part.strip() for part in setting.split(","))
        lines.append([nu.removeprefix("nu "), f"{layer.removeprefix('layer ')}, {depth.removesuffix(' deep')}",
                      f"{of['force over tabulated force']:.3f}",
                      f"{of['sliding: least force']:.3f} to {of['sliding: greatest force']:.3f}",
                      percent(of["sliding: largest change per tick"]), f"{100 * of['contact compression over depth']:.0f} %",
                      number(of["median CPU time per tick"]), number(of["median wall time per tick"])])
    return table(["ν", "Layer, depth", "Force relative to the table", "while sliding", "Largest change per tick",
                  "The contact gives", "CPU ms per tick", "wall ms"], sorted(lines))

def layer(reports):
    """A line for each mesh and press: forces by Poisson's ratio, then the largest figures."""
    groups = {}
    for setting, of in pressed(reports, "layer").items():
        thick, depth, nu, element, cells = (part.strip() for part in setting.split(","))
        groups.setdefault((element, cells.removesuffix(" cells"), f"{thick.removeprefix('layer ')}, {depth.removesuffix(' deep')}"), []).append(of)

    def span(same, figure):
        values = [of[figure] for of in same]
        return f"{number(min(values))} to {number(max(values))}"

    lines = [[f"{element}, {cells}", press, ", ".join(f"{of['force over tabulated force']:.2f}" for of in same),
              *(percent(max(of[figure] for of in same)) for figure in ("sliding: largest change per tick", "sliding: relative force range")),
              span(same, "median CPU time per tick"), span(same, "median wall time per tick")]
             for (element, cells, press), same in sorted(groups.items(), reverse=True)]
    return table(["Elements, cells per contact radius", "Layer, depth", "Force relative to the table", "Largest change per tick",
                  "Largest minus smallest", "CPU ms per tick", "wall ms"], lines)

def organ(reports):
    lines = []
    for setting, of in pressed(reports, "organ").items():
        lines.append(["quadratic" if "tet10" in setting else "linear", number(of["force over reference force"]),
                      number(of["indentation over reference indentation"]), percent(of["stroking: largest force error"]),
                      percent(of["stroking: largest change per tick"]), number(of["median CPU time per tick"])])
    return table(["Elements", "Force relative to the reference", "Dent relative to the reference", "Stroking: largest error",
                  "Stroking: largest change per tick", "CPU ms per tick"], lines)

# Tissue under its weight, a recorded session, and estimates.

def weight(reports):
    """A line for each of the finest meshes at one Poisson's ratio: when it stands and when it hangs."""
    lines = []
    for (body, element, grade, tets), acts in grouped(reports.rows("weight", poisson_ratio=0.49), "body", "element", "grade", "tets").items():
        by_act = {row["act"]: row for row in acts}
        sizes = sorted({row["tets"] for row in reports.rows("weight", body=body, element=element, grade=grade)})
        if tets not in sizes[-1 if element == "tet4" else -2:]:
            continue
        kind = {"tet4": "linear", "tet10": "quadratic"}[element] + (", graded" if grade != "none" else "")
        lines.append([body, f"{count(tets)} {kind}", *(shown(by_act[act][key]) for act in ("stands", "hangs")
                                                       for key, shown in (("error", percent), ("cpu_ms_per_frame", number)))])
    return table(["ν = 0.49", "Elements", "Stands: error", "CPU ms", "Hangs: error", "CPU ms"], lines)

def felt(reports):
    """A line for each model, relative to the finest, which comes last."""
    rows = reports.rows("felt")
    finest = rows[-1]["force_N"]
    return table(["Model", "Cells", "Tetrahedra", "Force", "Relative", "Indentation"],
                 [[f"`{row['model']}`, {row['element']}", f"{row['cell_mm']:.0f} mm", count(row["tets"]), f"{row['force_N']:.2f} N",
                   DASH if row is rows[-1] else f"{100 * (row['force_N'] / finest - 1):+.0f} %", f"{row['moved_mm']:.1f} mm"]
                  for row in rows])

def estimate(reports):
    lines = []
    for element, name in (("tet10", "quadratic"), ("tet4", "linear")):
        for load, loaded in (("by weight", "weight"), ("pressed", "press")):
            of = reports.of("estimate")[0][f"{element}, {load}"]
            lines.append([name, loaded, of["cases"], of["kept"], ", ".join(f"{of[key]:.2f}" for key in ("least", "median", "most"))])
    return table(["Elements", "Load", "Cases", "Ratio 0.8 to 1.5", "Least, median, greatest ratio"], lines)

# Cutting.

def default_cuts(reports, **settings):
    return reports.rows("cut", model="fem_corotational", element="tet4", solver="cg", **settings) + [
        row for row in reports.rows("cut", **settings) if row["tissue"].endswith("sheet")]

def cut_strokes(reports):
    lines = []
    for row in default_cuts(reports):
        if "ms_p50_cutting" not in row:
            continue
        sheet = row["tissue"] != "liver"
        if sheet != (row["stroke"] == "curved"):
            continue
        lines.append([row["stroke"] + (f", a sheet under `{row['model']}`" if sheet else ""),
                      f"{count(row['tets'])} → {count(row['tets_after'])}" + (" triangles" if sheet else ""),
                      f"{row['ms_p50_cutting']:.1f} / {row['ms_p99_cutting']:.1f}", f"{row['ms_p50_other']:.1f}", f"{row['added_ms_p50']:.1f}",
                      f"{row['least_angle_deg_after']:.0f}, {row['median_angle_deg_after']:.0f}",
                      ", ".join(f"{row[key]:.0f}" for key in ("solver_iterations_cutting", "solver_iterations_between", "solver_iterations_after"))])
    return table(["Stroke", "tetrahedra before → after", "tick that cuts, p50 / p99", "others, p50", "the cut's share, p50", "angles, degrees",
                  "iterations"], lines)

def cut_severing(reports):
    keys = "ms_made_ready", "ms_cutting_mesh", "ms_making_bodies", "ms_making_bodies_anew", "added_ms_p50"
    lines = [[row["stroke"], f"{count(row['tets'])} → {count(row['tets_after'])}", *(f"{row[key]:.1f}" for key in keys),
              f"{row['ms_end_of_stroke']:.1f}, {row['ms_end_of_half_a_stroke']:.1f}", f"{row['ms_undoing']:.1f}, {row['ms_undoing_anew']:.1f}"]
             for row in default_cuts(reports) if "ms_cutting_mesh" in row]
    return table(["Stroke", "tetrahedra", "computed with the scene", "cutting the mesh", "pieces' bodies, updated", "rebuilt", "both",
                  "end of a stroke, of half a stroke", "undo, updated and rebuilt"], lines)

def cut_models(reports):
    """A line for each model, element and solver: medians of ticks that cut, and of others."""
    lines = []
    for (model, element, solver, tets), rows in grouped(reports.rows("cut", tissue="liver"), "model", "element", "solver", "tets").items():
        by_stroke = {row["stroke"]: row for row in rows}
        straight, fast = by_stroke.get("straight"), by_stroke.get("as fast as a hand")
        if not straight or not fast:  # severing cuts only
            continue
        whole = by_stroke.get("through at once")
        lines.append([f"`{model}`, {element}, {solver}", count(tets), *(f"{row[key]:.1f}" for row in (straight, fast)
                                                                      for key in ("ms_p50_other", "ms_p50_cutting")),
                      f"{whole['added_ms_p50']:.1f}" if whole else DASH])
    return table(["Configuration", "tetrahedra", "straight stroke: other ticks", "ticks that cut", "fast stroke: other ticks", "ticks that cut",
                  "severing at once"], lines)
