#!/usr/bin/python3
"""fill_tables.py FOLDER: puts what prosector-bench measured into docs/.

FOLDER holds reports that `prosector-bench SUBJECT --json FILE` wrote, any number of each subject. Each table stands between
`<!-- measured: NAME -->` and `<!-- /measured -->`; those whose reports are not there stay as they are, and are named.
"""

import math
import pathlib
import re
import statistics
import sys

from contact_tables import contact, cut_models, cut_severing, cut_strokes, estimate, felt, layer, organ, pressed, usual, weight
from report_tables import DASH, Missing, Reports, count, grouped, kept, number, percent, rung, table

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = [f"docs/look-up/{page}.md" for page in ("measurements", "soft-tissue-figures", "collision-figures", "contact-figures", "cutting-costs")]
MARKED = re.compile(r"(<!-- measured: (\S+) -->\n)(.*?)(<!-- /measured -->)", re.DOTALL)

# Goals.

def cheapest(rows, allowed):
    """Of the rows that are allowed, the quickest with most threads, beside the same with one; None: there is none."""
    pairs = []
    for same in grouped(rows, "model", "element", "solver", "newton_iterations", "solver_iterations",
                        "solver_tolerance", "tets", "ground").values():
        by_threads = sorted(same, key=lambda row: row["threads"])
        if allowed(by_threads[-1]):
            pairs.append((by_threads[0], by_threads[-1]))
    return min(pairs, key=lambda pair: pair[1]["ms_per_frame"], default=None)

def goal_line(what, goal, peers, figure, rows, allowed, error):
    """None where nothing of the kind was run."""
    pair = cheapest(rows, allowed)
    if not rows:
        return None
    if not pair:
        return [what, goal, peers, "no run", DASH, DASH, DASH]
    one, most = pair
    off = percent(most[error]) + (f"; dynamic {percent(most['error_dynamic'])}" if "error_dynamic" in most else "")
    told = [f"{number(row[figure])} with {row['threads']}" for row in ([one] if one is most else [one, most])]
    return [what, goal, peers, rung(most) + f", {count(most['tets'])} tets", "; ".join(told),
            number(most["cpu_ms_per_frame"]), off]

def sofa_goals(reports):
    for ground, name in ((0, "free"), (1, "with the ground")):
        rows = reports.rows("beam101k", ground=ground)
        yield goal_line(f"SOFA's beam, {name}, 10 CG iterations", "≥ 50 steps/s", "17", "steps_per_s", rows,
                        lambda row: row["solver"] == "cg" and row["solver_iterations"] == 10, "error_mesh")
        yield goal_line(f"SOFA's beam, {name}, within 1 % of the converged path", "≥ 25 steps/s", "4.6", "steps_per_s", rows,
                        lambda row: row["error_mesh"] <= 0.01, "error_mesh")

def press_goals(reports):
    yield goal_line("organ pressed by a ball, within 1 % of the converged path", "≥ 60 steps/s", DASH, "steps_per_s",
                    reports.rows("press"), lambda row: row["error_mesh"] <= 0.01, "error_mesh")

def beam_goals(reports):
    for model, peers in (("fem_corotational", "74.5"), ("fem_neo_hookean_polynomial", "80.1")):
        rows = reports.rows("beam", model=model)
        yield goal_line("peers' beam, within 0.1 % of the same mesh's static solution", "≤ 15 ms", peers, "ms_per_frame",
                        [row for row in rows if row["tets"] == 31944], lambda row: row["error_mesh"] <= 0.001, "error_mesh")
        yield goal_line("peers' beam, within 1 % of the continuum's static solution", "≤ 8 ms", DASH, "ms_per_frame",
                        rows, lambda row: row["error_continuum"] <= 0.01, "error_continuum")

def goals(reports, before):
    sections = {"beam101k": (sofa_goals, "SOFA's beam"), "press": (press_goals, "organ"), "beam": (beam_goals, "peers' beam")}
    if not any(bench in reports.all for bench in sections):
        raise Missing(" or ".join(sections))
    lines = []
    for bench, (fill, what) in sections.items():
        lines += [line for line in fill(reports) if line] if bench in reports.all else kept(before, what)
    return table(["Test", "goal", "best peer, one thread", "configuration", "measured, by threads", "CPU ms per step", "error"], lines)

# Other codes' beams and the press, row by row.

def side_by_side(rows, figure, errors, **first):
    """A line for each setting, with a column for each number of threads."""
    threads = sorted({row["threads"] for row in rows})
    heads = [*first.values(), *(f"{figure[1]}, {n} thread{'s' if n > 1 else ''}" for n in threads),
             "iterations", *errors.values()]
    lines = []
    keys = [*first, "newton_iterations", "solver_iterations", "solver_tolerance"]
    for same in grouped(rows, *keys).values():
        by_threads = {row["threads"]: row for row in same}
        row = same[0]
        settings = [effort_in(row) if key == "solver" else cell(row[key]) for key in first]
        lines.append([*settings, *(number(by_threads[n][figure[0]]) if n in by_threads else DASH for n in threads),
                      number(row["iterations_per_frame"]), *(percent(row[key]) for key in errors)])
    return table(heads, lines)

def cell(value):
    return count(value) if isinstance(value, int) else value

def effort_in(row):
    return f"{row['solver']} {row['newton_iterations']} × {row['solver_iterations']} to {row['solver_tolerance']:.0e}"

def beam101k(reports):
    rows = [{**row, "where": "with" if row["ground"] else "without"} for row in reports.rows("beam101k")]
    return side_by_side(rows, ("steps_per_s", "steps/s"), {"error_mesh": "path error"},
                        where="ground", solver="solver")

def press(reports):
    return side_by_side(reports.rows("press"), ("steps_per_s", "steps/s"), {"error_mesh": "path error"},
                        tets="tets", solver="solver")

def ours(rows):
    return [row for row in rows if not row["model"].startswith("bullet_")]

# CPU ms a frame, one thread, on the machine that other codes were measured on.
BULLET_ELSEWHERE = {"bullet_deformable_linear": {648: 3.4, 5184: 42.9, 31944: 327},
                    "bullet_deformable_neo_hookean": {648: 6.1, 5184: 72.4, 31944: 584}}

def bullet_here(reports):
    lines = []
    for row in reports.rows("beam"):
        there = BULLET_ELSEWHERE.get(row["model"], {}).get(row["tets"])
        if there:
            here = row["cpu_ms_per_frame"]
            lines.append([f"`{row['model']}`", count(row["tets"]), number(there), number(here), number(here / there)])
    return table(["Bullet on this beam", "tets", "CPU ms, other machine", "this machine", "ratio"], lines)

def beam(reports):
    quickest = []
    for same in grouped(ours(reports.rows("beam")), "model", "element", "tets").values():
        pair = cheapest(same, lambda row: row["error_mesh"] <= 0.001)
        quickest += [] if not pair else [pair[1]] if pair[0] is pair[1] else list(pair)
    return side_by_side(quickest, ("ms_per_frame", "ms"),
                        {"error_mesh": "error, same mesh", "error_continuum": "error, continuum", "error_dynamic": "dynamic error"},
                        model="model", element="element", tets="tets", solver="solver")

# The trade.

ERROR_KEYS = {"bend": "error_material", "bend_incompressible": "error_material", "swing": "error_dynamic",
              "free": "angular_momentum_drift",
              **dict.fromkeys(("heavy", "cube", "slab", "hang", "press", "organ"), "error_material")}
MORE = {"error_frequency": ("frequency error", percent), "amplitude_lost_per_period": ("amplitude loss per period", percent),
        "energy_drift": ("energy drift", percent), "momentum_drift": ("momentum drift", percent),
        "largest_stable_step_s": ("largest stable step, s", number), "volume_loss": ("volume loss", percent), "force_N": ("force, N", number)}

def measured(rows, key):
    return [row for row in rows if row.get(key) is not None and row.get("ms_per_simulated_s")]

NEGLIGIBLE = 1e-5  # as trade_plot.h has it

def front(rows, key):
    """Rows than which nothing is both cheaper and better, cheapest first."""
    best, out = math.inf, []
    for row in sorted(rows, key=lambda row: (row["ms_per_simulated_s"], abs(row[key]))):
        error = max(abs(row[key]), NEGLIGIBLE)
        if error < best:
            best = error
            out.append(row)
    return out

def thinned(rows, key):
    """Rows of a front, without those that lower the last shown error by less than a fifth."""
    out = []
    for row in rows:
        if not out or abs(row[key]) < 0.8 * abs(out[-1][key]):
            out.append(row)
    return out

def trade_case(case):
    def fill(reports):
        rows = reports.rows("trade", case=case)
        if not rows:
            raise Missing(f"trade, case {case}")
        key = ERROR_KEYS[case]
        rows = measured(rows, key)
        told = [row for row in thinned(front(rows, key), key) if abs(row[key]) <= 1]
        more = [name for name in MORE if name != "largest_stable_step_s" and any(row.get(name) is not None for row in rows)]
        return table(["Configuration", "tets", "step, ms", "ms per frame", "error", *(MORE[name][0] for name in more)],
                     [[rung(row), count(row["tets"]), number(row["dt_ms"]), number(row["ms_per_frame"]),
                       percent(abs(row[key])), *(MORE[name][1](row.get(name)) for name in more)] for row in told])

    return fill

def refine(body):
    def fill(reports):
        rows = reports.rows("refine", body=body)
        if not rows:
            raise Missing(f"refine, body {body}")
        return table(["Elements", "cell, mm", "refined cell, mm", "max. tetrahedra", "static force, mN", "error", "sliding: deviation from trend", "largest change per tick", "CPU ms per tick, static", "sliding", "max. at mesh changes"],
                     [["quadratic" if row["element"] == "tet10" else "linear", number(row["cell_mm"]), number(row["refine_cell_mm"]) if row["refine_cell_mm"] else DASH,
                       count(row["tets_at_most"]), number(row["force_mN"]), percent(row["error_continuum"]),
                       percent(row["off_trend"]), percent(row["from_tick_to_tick"]), number(row["cpu_ms_held"]), number(row["cpu_ms_drawn"]),
                       number(row["cpu_ms_changed"]) if row.get("cpu_ms_changed") else DASH]
                      for row in rows])

    return fill

def references(reports):
    """Of bodies whose meshes are extrapolated, the finest alone."""
    rows = []
    for same in grouped(reports.rows("references"), "case").values():
        rows += same[-2:-1] if same[-1]["mesh"] == "extrapolated" else same
    return table(["Case", "quadratic mesh", "difference from stored", "error of stored", "force, N"],
                 [[row["case"], row["mesh"], percent(abs(row["off"])), percent(row["unsettled"]), number(row["force_N"]) if row.get("force_N") else DASH]
                  for row in rows])

def advice(reports, before):
    """A block for each case, headed by its name; those of cases that were not run stay."""
    blocks, block = {}, []
    told = [line for report in reports.of("trade") for line in report["recommendation"]]
    for line in [*before.splitlines(), *told]:
        limit = re.match(r"  within ([\d, ]+) %: (.*)", line)  # the fronts show what fits a budget
        if limit and block and block[-1].endswith(f" %: {limit[2]}"):
            block[-1] = block[-1].replace(" %:", f", {limit[1]} %:", 1)
        elif limit:
            block.append(line)
        elif not line.startswith((" ", "```")):
            block = blocks[line] = []
    return "```\n" + "".join(f"{line}\n" for head, lines in blocks.items() for line in (head, *lines)) + "```\n"

def cost_and_error(rows, key):
    """Of the cheapest run that ends within half a per cent of the best on its mesh: what solving better would not mend."""
    ended = measured(rows, key)
    if not ended:
        return f"{number(min(row['ms_per_frame'] for row in rows))} ms, {DASH}"
    best = min(abs(row[key]) for row in ended)
    run = min((row for row in ended if abs(row[key]) <= best + 0.005), key=lambda row: row["ms_per_frame"])
    return f"{number(run['ms_per_frame'])} ms, {percent(abs(run[key]))}"

def bend_sizes(reports):
    rows = reports.rows("trade", case="bend")
    if not rows:
        raise Missing("trade, case bend")
    sizes = sorted({row["tets"] for row in rows})
    lines = []
    for (model, element), same in grouped(rows, "model", "element").items():
        cells = []
        for tets in sizes:
            there = [row for row in same if row["tets"] == tets and row.get("ms_per_frame")]
            cells.append(cost_and_error(there, ERROR_KEYS["bend"]) if there else DASH)
        lines.append([f"`{model}`, {element}", *cells])
    return table(["Bending beam, ν = 0.3", *(f"{count(tets)} elements" for tets in sizes)], lines)

# For docs/look-up/soft-tissue-figures.md.

def place(reports, case, tets, **settings):
    rows = reports.rows("trade", case=case, tets=tets, **settings)
    if not rows:
        return DASH
    return cost_and_error(rows, ERROR_KEYS[case]) if rows else DASH

def verdicts(reports, **settings):
    rows = [row["verdict"] for row in reports.rows("stability", **settings) if row["verdict"]]
    return " / ".join(str(rows.count(name)) for name in ("survives", "degrades", "refuses", "fails")) if rows else DASH

def rungs(reports):
    lines = []
    for case in ("bend", "bend_incompressible", "heavy"):
        if not reports.rows("trade", case=case):
            raise Missing(f"trade, case {case}")
    reports.of("stability")
    for model, element in grouped(reports.rows("trade", case="bend"), "model", "element"):
        if model.startswith("bullet_"):
            continue
        kind = {"model": model, "element": element}
        lines.append([f"`{model}`, {element}", place(reports, "bend_incompressible", 1536, **kind), place(reports, "heavy", 384, **kind),
                      verdicts(reports, **kind)])
    return table(["Configuration", "beam, ν = 0.45", "cube under load, ν = 0.49",
                  "extremes: survives / degrades / refuses / fails"], lines)

EXPLICIT = ("explicit_euler", "symplectic_euler", "rk2", "rk4", "verlet")

def kind_of(row):
    if row["model"] == "xpbd":
        return "XPBD"
    return "explicit" if row["integrator"] in EXPLICIT else "implicit"

def extremes(reports):
    lines = []
    for (kind,), cells in grouped([{**row, "kind": kind_of(row)} for row in reports.rows("stability")], "kind").items():
        told = [row["verdict"] for row in cells]
        run = [row for row in cells if row["verdict"] and row["steps"]]
        late = sum(not row["met_deadline"] for row in run)
        lines.append([kind, len(cells), *(told.count(name) for name in ("survives", "degrades", "refuses", "fails")),
                      told.count(None), f"{late} of {len(run)}"])
    return table(["Methods", "cells", "survive", "degrade", "refuse", "fail", "not run", "missed deadlines"], lines)

def integrators(reports):
    key = ERROR_KEYS["swing"]
    rows = measured(reports.rows("trade", case="swing", model="fem_corotational"), key)
    if not rows:
        raise Missing("trade, case swing")
    rows = [row for row in rows if row["tets"] == min(r["tets"] for r in rows)]
    lines, carried = [], {}
    for (element, name, dt_ms), same in sorted(grouped(rows, "element", "integrator", "dt_ms").items(),
                                               key=lambda group: len(group[0][0])):  # tet4, then tet10
        run = min(same, key=lambda row: abs(row[key]))
        figures = percent(run[key]), percent(run["amplitude_lost_per_period"])
        implicit = carried.setdefault((element, dt_ms), figures)  # implicit_euler comes first
        if name in EXPLICIT and figures == implicit or (5 if name in EXPLICIT else 2) < dt_ms < 10:
            continue
        lines.append([f"`{name}`", element, number(dt_ms), number(run["ms_per_simulated_s"]), percent(run[key]),
                      *(shown(run.get(figure)) for figure, (_, shown) in MORE.items() if figure in INTEGRATOR_FIGURES)])
    return table(["Integrator", "element", "step, ms", "CPU ms per simulated s", "path error",
                  *(MORE[figure][0] for figure in MORE if figure in INTEGRATOR_FIGURES)], lines)

INTEGRATOR_FIGURES = ("error_frequency", "amplitude_lost_per_period", "energy_drift", "largest_stable_step_s")

def laws(reports):
    lines = []
    for (model,), same in grouped(reports.rows("soft"), "model").items():
        by_element = {row["element"]: row for row in same}
        lines.append([f"`{model}`", *(number(by_element[element][figure]) for element in ("tet4", "tet10")
                                     for figure in ("ms_iteration_per_1000_tets", "ms_multiply_per_1000_tets"))])
    return table(["Law", "linear: iteration", "product", "quadratic: iteration", "product"], lines)

def decades(rows):
    """Of each rung every other size, from the largest down."""
    out = []
    for same in grouped(rows, "model", "element", "solver").values():
        sizes = sorted({row["tets"] for row in same}, reverse=True)[::2]
        out += [row for row in same if row["tets"] in sizes]
    return out

def scaling(reports):
    rows = decades([row for row in reports.rows("scaling") if row["cpu_ms_per_frame"] <= 2000])
    models = ("fem_corotational", "xpbd")
    lines = []
    for same in grouped([row for row in rows if row["model"] in models], "model", "element", "solver", "tets").values():
        one = next(row for row in same if row["threads"] == 1)
        lines.append([f"`{one['model']}`, {one['element']}", one["solver"], count(one["tets"]),
                      number(one["cpu_ms_per_frame"]), number(one["cpu_us_per_tet"]), number(one["bytes_per_tet"]),
                      number(one["residual"])])
    return table(["Configuration", "solver", "tets", "CPU ms per frame", "CPU µs per tet", "bytes per tet",
                  "residual"], lines)

# Collision.

ERRORS = ["false hits", "missed hits", "depth error", "normal error, °"]

def per_fidelity(rows, columns):
    """A line for each fidelity: the median over shapes, then the greatest value with its shape."""
    lines = []
    for (fidelity,), same in grouped(rows, "fidelity").items():
        cells = []
        for key, shown in columns.items():
            values = [row for row in same if row[key] is not None]
            if not values:
                cells.append(DASH)
                continue
            worst = max(values, key=lambda row: row[key])
            cells.append(f"{shown(statistics.median(row[key] for row in values))}; {shown(worst[key])} {worst.get('shape', 'another organ')}")
        lines.append([f"`{fidelity}`", *cells])
    return lines

PAIR = {"us_per_pair": number, "false_hits": percent, "missed_hits": percent, "depth_error": percent, "normal_error_deg": number}

def collision_shapes(reports):
    """A line for each fidelity of rigid bodies."""
    lines = per_fidelity(reports.rows("collision", case="pairs"), {**PAIR, "bytes_per_object": lambda n: count(round(n))})
    return table(["Fidelity", "CPU µs per pair", *ERRORS, "bytes"], lines)

def collision_organs(reports):
    """A line for each fidelity of an organ."""
    rows = reports.rows("collision", case="organ_rigid") + reports.rows("collision", case="two_organs")
    return table(["Organ's fidelity", "CPU µs per pair", *ERRORS], per_fidelity(rows, PAIR))

def collision_bodies(reports):
    """A line for each size of scene, a column for each fidelity."""
    rows = reports.rows("collision", case="bodies")
    fidelities = list(dict.fromkeys(row["fidelity"] for row in rows))
    lines = []
    for (bodies,), same in sorted(grouped(rows, "bodies").items()):
        by_fidelity = {row["fidelity"]: row for row in same}
        lines.append([count(bodies), *(number(by_fidelity[f]["ms_scene"]) if f in by_fidelity else DASH for f in fidelities),
                      *(count(by_fidelity[f]["contacts"]) if f in by_fidelity else DASH for f in ("sphere", "hull"))])
    return table(["Bodies", *(f"`{f}`" for f in fidelities), "contacts, `sphere`", "contacts, `hull`"], lines)

def collision_surfaces(reports):
    keys = ["ms_build", "ms_refit", "ms_apart", "ms_crossing", "ms_list", "ms_self"]
    lines = [[count(row["triangles"]), *(number(row[key]) for key in keys), count(round(row["bytes_per_triangle"]))]
             for row in reports.rows("collision", case="surface")]
    return table(["Triangles per surface", "build", "refit", "contacts, nearly touching", "contacts, 10 % overlap", "self-collision, list built", "self-collision, later ticks",
                  "bytes per triangle"], lines)

def collision_layers(reports):
    lines = [[count(row["cells"]), number(row["ms_refit"]), number(row["ms_layers"]), count(row["meetings"])]
             for row in reports.rows("collision", case="layers")]
    return table(["Cells per sheet", "refit", "search", "contacts"], lines)

def collision_soft_sessions(reports):
    lines = [[count(row["bodies"]), count(row["all_pairs"]), number(row["ms_narrow"])] for row in reports.rows("collision", case="soft_session")]
    return table(["Soft bodies", "pairs", "ms"], lines)

USUAL = "2 cores", "avx512", "24 GiB", "g++ 12.2.0", "Release"  # named above the table

def machine(reports, before):
    if not reports.all:
        raise Missing("any bench")

    def where(report):
        m = report["machine"]
        parts = f"{m['cores']} cores", m["vector"], f"{m['memory_bytes'] / 2**30:.0f} GiB", report["compiler"], m["build"]
        return ", ".join([m["cpu"], *(part for part in parts if part not in USUAL)])

    runs = {}  # benches and loads
    for bench in reports.all:
        for told in reports.all[bench]:
            for report in told.get("measured", [told]):
                run = report["date"][:10], report["commit"], where(report | {"compiler": told["compiler"]})
                benches, loads = runs.setdefault(run, (set(), []))
                benches.add(f"`{bench}`")
                loads.append(report["machine"]["load_average"])
    lines = [[", ".join(sorted(benches)), *run[:2], number(min(loads)) + (f" to {number(max(loads))}" if len(loads) > 1 else ""), run[2]]
             for run, (benches, loads) in runs.items()]
    for line in kept(before, "`"):
        others = [bench for bench in line[0].split(", ") if bench.strip("`") not in reports.all]
        lines += [[", ".join(others), *line[1:]]] if others else []
    return table(["Bench", "date", "commit", "load average at the end", "machine"], sorted(lines))

# Cameras.

HAND_TRIALS = {"first": "single image", "followed": "followed"}  # the report's other rows are gestures

def hands(reports):
    return table(["Networks", "trial", "cameras", "seen", "points correct", "side correct", "point error", "lateral mm", "depth mm", "rotation °", "flexion error",
                  "find ms", "fit ms"],
                 [[row["nets"], HAND_TRIALS[row["trial"]], row["cameras"], *(f"{100 * row[key]:.1f} %" for key in
                   ("seen", "right_points", "right_side", "points_median")), f"{row['lateral_mm']:.1f}", f"{row['depth_mm']:.1f}",
                   f"{row['turn_deg']:.1f}", f"{row['flexion_median']:.3f}", f"{row['find_ms']:.1f}", f"{row['fit_ms']:.2f}"]
                  for row in reports.rows("hands") if row["trial"] in HAND_TRIALS])

def hand_gestures(reports):
    rows = {(row["nets"], row["trial"]): row for row in reports.rows("hands") if row["trial"] not in HAND_TRIALS}
    names = [name for nets, name in rows if nets == "full"]

    def told(nets, made):
        row = rows[nets, made]
        others = sorted((-row[name], name) for name in (*names, "none") if name != made and row[name] > 0)
        return [f"{100 * row['right_gesture']:.1f} %", ", ".join(f"{'none' if name == 'none' else f'`{name}`'} {-100 * part:.0f} %" for part, name in others) or DASH]

    def mean(nets):
        return f"**{100 * sum(rows[nets, name]['right_gesture'] for name in names) / len(names):.1f} %**"

    return table(["Gesture", "full: correct", "confused with", "lite: correct", "confused with"],
                 [[f"`{name}`", *told("full", name), *told("lite", name)] for name in names] + [["mean", mean("full"), "", mean("lite"), ""]])

KEEPING = {"machine": machine, "goals": goals, "advice": advice, "contact": contact}  # lines of what was not run stay
TABLES = {"beam": beam, "beam101k": beam101k, "press": press, "bullet-here": bullet_here,
          "bend-sizes": bend_sizes, "rungs": rungs, "extremes": extremes, "integrators": integrators, "laws": laws, "scaling": scaling,
          "collision-shapes": collision_shapes, "collision-bodies": collision_bodies, "collision-surfaces": collision_surfaces,
          "collision-organs": collision_organs, "collision-layers": collision_layers,
          "collision-soft-sessions": collision_soft_sessions,
          "usual": usual, "layer": layer, "organ": organ, "weight": weight, "felt": felt, "estimate": estimate,
          "cut-strokes": cut_strokes, "cut-severing": cut_severing, "cut-models": cut_models, "hands": hands, "hand-gestures": hand_gestures,
          **{f"trade-{case}": trade_case(case) for case in ERROR_KEYS},
          **{f"refine-{body}": refine(body) for body in ("layer", "organ", "liver")}, "references": references}

def main():
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_dir():
        sys.exit("usage: deploy/fill_tables.py FOLDER   (with reports written by prosector-bench --json)")
    reports = Reports(pathlib.Path(sys.argv[1]))

    def filled(match):
        name = match[2]
        if name not in TABLES | KEEPING:
            sys.exit(f"fill_tables: unknown table {name}; tables: {', '.join(TABLES | KEEPING)}")
        try:
            return match[1] + (KEEPING[name](reports, match[3]) if name in KEEPING else TABLES[name](reports)) + match[4]
        except Missing as missing:
            print(f"{name}: unchanged, no report of {missing}")
            return match[0]

    for page in PAGES:
        file = ROOT / page
        file.write_text(MARKED.sub(filled, file.read_text()))

if __name__ == "__main__":
    main()
