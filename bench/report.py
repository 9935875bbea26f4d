"""Writes docs/performance.md and its plots from the figures of sturnus-yardsticks.

Usage: report.py figures.json page.md    (the plots go to images/speed-*.png beside the page)
"""
import json
import pathlib
import sys

from plots import PLOTS, median_ms, median_ns, select

DIMENSIONS = (2, 3)

# (yardstick, boids): at least so many times faster, in 2D and in 3D.
YARDSTICK_TARGETS = {
    ("all pairs", 10_000): (300, 130),
    ("scalar grid", 100_000): (14, 8),
    ("nanoflann", 100_000): (25, 17),
    ("nanoflann", 1_000_000): (25, 17),
}
# Ten million boids against a hundred thousand, ns per boid: at most so many times slower.
GROWTH_TARGETS = (1.6, 1.4)
# Two threads against one, a million boids.
THREADS_TARGETS = (1.75, 1.85)
# (separation, neighbours): the dense path against the sparse one.
DENSE_TARGETS = {
    ("1/d at r/5", 1000): (1.5, 1.4),
    ("1/d at r/5", 10_000): (4, 3),
    ("linear at r", 1000): (2, 1.5),
    ("linear at r", 10_000): (6, 4),
}

# A living world against the flock alone, 100 000 boids: at most so many times slower.
LIVING_TARGETS = (2, 1.5)

ABOUT_YARDSTICKS = {
    "all pairs": "array of structs, every boid looks at every other; the nearest image by comparison, in the fastest of "
                 "five spellings",
    "scalar grid": "the cell grid that the engine uses too, sorted by counting in each step, struct of arrays in order of "
                   "cells, one neighbour at a time",
    "nanoflann": "radius search of nanoflann's k-d tree, built anew in each step over points kept in order of cells; "
                 "neighbours are summed as they are found, and places near the seam search twice",
    "pointer tree": "quadtree or octree of nodes on the heap, 16 boids in a leaf, built anew in each step, a search "
                    "returns a vector of pointers",
}


def number(value):
    """Three digits that matter, thousands set apart."""
    digits = 0 if abs(value) >= 100 else 1 if abs(value) >= 10 else 2
    return f"{value:,.{digits}f}".replace(",", " ")


def whole(value):
    return f"{value:,}".replace(",", " ")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def verdict(value, target, at_most=False):
    """The word for a ratio beside its target."""
    if value is None:
        return "not measured"
    return "reached" if (value <= target if at_most else value >= target) else "missed"


def times(value):
    return "–" if value is None else number(value) + "x"


def timing(row):
    """Least and median time per boid."""
    return f"{number(row['ns_per_boid']['min'])} / {number(median_ns(row))}"


def only(rows):
    return rows[0] if rows else None


def machine_text(machine):
    caches = ", ".join(f"{name} {size}" for name, size in machine["caches"].items())
    return table(["", ""], [
        ["date", machine["date"]],
        ["processor", f"{machine['processor']}, {machine['cores']} cores, {caches}"],
        ["load before the run", f"{machine['load_before']:.1f}; more than a few tenths means that others were at work"],
        ["instruction set", machine["instruction_set"]],
        ["compiler", machine["compiler"]],
        ["flags of the engine and the yardsticks", f"`{machine['flags']}`"],
        ["flags of all pairs", f"`{machine['flags_of_all_pairs']}`"],
        ["nanoflann", machine["nanoflann"] + " by its header"],
        ["Sturnus", machine["version"]],
    ])


def yardsticks_text(figures):
    rows = []
    for row in sorted(figures["yardsticks"], key=lambda row: (row["yardstick"], row["boids"], row["dimensions"])):
        agreement = row["agreement"]
        rows.append([row["yardstick"], f"{row['dimensions']}D", whole(row["boids"]), timing(row["ours"]),
                     timing(row["theirs"]), times(row["ratio"]["of_minima"]) + " / " + times(row["ratio"]["of_medians"]),
                     f"{agreement['off']} of {whole(agreement['boids'])}", f"`{row['hash']}`"])
    return table(["yardstick", "", "boids", "Sturnus, ns", "yardstick, ns", "ratio", "boids that differ", "hash"], rows)


def yardstick_verdicts(figures):
    for (name, boids), targets in YARDSTICK_TARGETS.items():
        for dimensions, target in zip(DIMENSIONS, targets):
            row = only(select(figures["yardsticks"], yardstick=name, boids=boids, dimensions=dimensions))
            value = row and row["ratio"]["of_medians"]
            yield [f"{name}, {whole(boids)} boids", f"{dimensions}D", f"at least {target}x", times(value),
                   verdict(value, target)]


def growth_verdicts(figures):
    for dimensions, target in zip(DIMENSIONS, GROWTH_TARGETS):
        small = only(select(figures["sizes"], boids=100_000, dimensions=dimensions))
        large = only(select(figures["sizes"], boids=10_000_000, dimensions=dimensions))
        value = median_ns(large) / median_ns(small) if small and large else None
        yield ["a boid among ten million against one among 100 000", f"{dimensions}D", f"at most {target}x", times(value),
               verdict(value, target, at_most=True)]


def threads_verdicts(figures):
    for dimensions, target in zip(DIMENSIONS, THREADS_TARGETS):
        row = only(select(figures["threads"], boids=1_000_000, threads=2, dimensions=dimensions))
        value = row["speedup"]["cpu_of_medians"] if row and row["threads_told"] == 2 else None
        yield ["two threads against one, 1 000 000 boids", f"{dimensions}D", f"at least {target}x", times(value),
               verdict(value, target)]


def dense_verdicts(figures):
    for (separation, neighbours), targets in DENSE_TARGETS.items():
        for dimensions, target in zip(DIMENSIONS, targets):
            both = select(figures["dense"], separation=separation, neighbours=neighbours, dimensions=dimensions)
            sparse, dense = only(select(both, path="sparse")), only(select(both, path="dense"))
            value = median_ms(sparse) / median_ms(dense) if sparse and dense else None
            yield [f"dense path against sparse, {whole(neighbours)} in reach, separation {separation}", f"{dimensions}D",
                   f"at least {target}x", times(value), verdict(value, target)]


def verdicts_text(figures):
    rows = [*yardstick_verdicts(figures), *growth_verdicts(figures), *threads_verdicts(figures),
            *dense_verdicts(figures), *living_verdicts(figures)]
    return table(["against", "", "wanted", "measured", ""], rows)


def sizes_text(figures):
    rows = [[f"{row['dimensions']}D", whole(row["boids"]), timing(row), number(median_ms(row)), f"`{row['hash']}`"]
            for row in figures["sizes"]]
    return table(["", "boids", "ns per boid", "ms per step", "hash"], rows)


def neighbours_text(figures):
    rows = [[f"{row['dimensions']}D", whole(row["neighbours"]), timing(row), f"`{row['hash']}`"]
            for row in figures["neighbours"]]
    return table(["", "in reach", "ns per boid", "hash"], rows)


def paths_text(rows, counted):
    """A line for each case, with the median milliseconds of every path."""
    lines = []
    for key in dict.fromkeys((row["dimensions"], row["separation"], row[counted]) for row in rows):
        both = select(rows, dimensions=key[0], separation=key[1], **{counted: key[2]})
        spent = [only(select(both, path=path)) for path in ("sparse", "dense", "auto")]
        lines.append([f"{key[0]}D", key[1], whole(key[2]), *("–" if row is None else number(median_ms(row)) for row in spent)])
    return table(["", "separation", "in reach" if counted == "neighbours" else "boids", "sparse, ms", "dense, ms", "auto, ms"],
                 lines)


def instruction_sets_text(figures):
    rows = []
    for row in figures["instruction_sets"]:
        scalar = only(select(figures["instruction_sets"], dimensions=row["dimensions"], instruction_set="scalar"))
        rows.append([f"{row['dimensions']}D", row["instruction_set"], timing(row),
                     times(median_ns(scalar) / median_ns(row)), f"`{row['hash']}`"])
    return table(["", "instruction set", "ns per boid", "against scalar", "hash"], rows)


def threads_text(figures):
    rows = []
    for row in figures["threads"]:
        is_told = row["threads_told"] == row["threads"]
        phases = row["phases_ms"]
        rows.append([f"{row['dimensions']}D", whole(row["boids"]), str(row["threads"]), number(row["wall_ms"]["min"]),
                     number(row["busiest_cpu_ms"]["median"]) if is_told else "–",
                     " + ".join(number(phases[name]) for name in ("sort", "neighbours", "motion")) if is_told else "–",
                     times(row["speedup"]["wall_of_minima"]), times(row["speedup"]["cpu_of_medians"] if is_told else None),
                     f"`{row['hash']}`"])
    return table(["", "boids", "threads", "wall, ms", "busiest, ms", "sort + neighbours + motion", "by wall", "by CPU",
                  "hash"], rows)


def living_text(figures):
    rows = [[f"{row['dimensions']}D", row["world"], timing(row), times(row["ratio"]["of_medians"]), f"`{row['hash']}`"]
            for row in figures["living"]]
    return table(["", "", "ns per boid and step", "of the flock alone", "hash"], rows)


def living_verdicts(figures):
    for dimensions, target in zip(DIMENSIONS, LIVING_TARGETS):
        row = only(select(figures["living"], dimensions=dimensions, world="with hunters, obstacles and food"))
        value = row and row["ratio"]["of_medians"]
        yield ["a flock with hunters, obstacles and food against the flock alone", f"{dimensions}D",
               f"at most {target}x", times(value), verdict(value, target, at_most=True)]


def colour_text(figures):
    added = []
    for dimensions in DIMENSIONS:
        plain, drifting = (only(select(figures["living"], dimensions=dimensions, world=world))
                           for world in ("with hunters, obstacles and food", "and with colours that drift"))
        added.append(f"{number(median_ns(drifting) - median_ns(plain))} ns in {dimensions}D")
    return f"Colours that drift add {' and '.join(added)} for each boid and step."


def living_section(figures):
    return f"""## A living world

The scenarios `bench-living-2d` and `bench-living-3d`: 100 000 boids of the base case that flee 20 hunters within 10, look 30 ahead for 200
obstacles (spheres with radii from 5 to 15, in 3D from 2 to 6) and smell 500 pieces of food within 20; nobody is born. Beside them
the base case with as many boids, and the same living world where each boid's colour drifts toward its neighbours' with a little noise.
Turns of ten steps. `sturnus bench bench-living-2d --threads 1` and `sturnus bench bench-2d --boids 1e5 --threads 1` measure the same.

{living_text(figures)}
{colour_text(figures)}
"""


def sixty_text(figures):
    rows = [["the project's own words, without a tree", "100 to 150", "", ""],
            ["the project's own words, with a quadtree", "1000 to 5000", "", ""]]
    for row in figures["sixty"]:
        count = ("at least " if row["is_at_least"] else "") + whole(row["boids"])
        rows.append([row["who"], count, number(row["ms_per_step"]), f"`{row['hash']}`"])
    return table(["", "boids", "ms per step", "hash"], rows)


def page_text(figures):
    names = "\n".join(f"- **{name}**: {text}." for name, text in ABOUT_YARDSTICKS.items())
    return f"""# How fast it is

Written by `script/bench` from one run of `sturnus-yardsticks` ({figures['effort']}, {figures['seconds']:.0f} seconds); don't edit it.
The programs are in `bench/`, one yardstick a file.

{machine_text(figures['machine'])}
## How it is measured

The base case is the scenarios `bench-2d` and `bench-3d`: float32, a wrapped space, boids spread evenly, 20 neighbours in a radius r,
separation 1/d within r/2, alignment and cohesion within r, acceleration cap, speed limits, semi-implicit Euler. The *whole* step
counts, with sorting and motion. Times are CPU time of the one thread (`CLOCK_THREAD_CPUTIME_ID`); contenders take turns in one
process, so that a slow minute of the machine hits all of them. "3 / 4" is the least and the median of the turns, at least five
of them except where a turn takes seconds; verdicts go by medians. A hash names the state that the steps led to; the program prints
one beside every figure, also those that are only drawn here.

A speed counts only beside the same result: every yardstick begins with our boids, and after one step velocities and places have to agree
within a ten-thousandth for all but one boid in a thousand (a neighbour just on the rim may count for one and not for
the other), or the program fails. The same comparison has to tell a step from no step.

## What was wanted, and what was reached

{verdicts_text(figures)}
## Beside the yardsticks

{names}

{yardsticks_text(figures)}
![Time per boid against the number of boids, Sturnus and the yardsticks](images/speed-sizes.png)

## The number of boids

{sizes_text(figures)}
## The number of neighbours

{neighbours_text(figures)}
![Time per boid against the number of neighbours in reach](images/speed-neighbours.png)

## Instruction sets

{instruction_sets_text(figures)}
## Threads

"busiest" is the CPU time of the busiest thread, phase by phase, added up: what a step would take on a machine with nothing else
to do. "–": not every thread told of its work, so it is not known.

{threads_text(figures)}
## Which index for which flock

uniform: the base case. clumped: balls of 200 boids. lost: an open world a million long, everybody at the usual density in one
place and one boid in a hundred astray.

![Time per boid with grid, tree and all pairs on three spreads](images/speed-indexes.png)

## Dense flocks

100 000 boids all over the space, many in reach: neighbours one by one (sparse), those well inside a radius together
(dense), and as the engine chooses (auto). All three have to make the same step, as the yardsticks do.

{paths_text(figures['dense'], 'neighbours')}
![Milliseconds per step against the number of neighbours in reach](images/speed-dense.png)

The whole flock inside one radius. Separation is linear, or 1/d within a radius that holds 50 boids, or 1/d of all boids, which is a true
sum over pairs. A line ends where a step would take seconds.

{paths_text(figures['clumps'], 'boids')}
![Milliseconds per step for clumps](images/speed-clumps.png)

{living_section(figures)}
## How many boids at 60 steps a second

The rules and the world of the scenario `quadtree` without its noise, which no two programs draw alike, after a second of flocking; wall
time of a step, best of ten, without drawing. The project that the scenario comes from drew its boids too, on its own machine, so its
numbers stand beside ours as a scale and not as a contest.

{sixty_text(figures)}
![Boids at 60 steps a second](images/speed-sixty.png)
"""


def main(source, page):
    figures = json.loads(pathlib.Path(source).read_text(encoding="utf-8"))
    page = pathlib.Path(page)
    images = page.parent / "images"
    images.mkdir(parents=True, exist_ok=True)
    for name, plot in PLOTS.items():
        plot(figures, images / f"speed-{name}.png")
    page.write_text(page_text(figures), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("report.py: say the figures and the page: report.py figures.json page.md")
    main(sys.argv[1], sys.argv[2])
