"""The plots of docs/performance.md, from the figures of sturnus-yardsticks."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

# Colours that people of every sight can tell apart (Okabe and Ito).
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
MARKERS = ["o", "s", "^", "D", "v", "P"]

plt.rcParams.update({
    "font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False, "axes.spines.right": False,
    "lines.markersize": 4, "lines.linewidth": 1.4, "legend.frameon": False, "legend.fontsize": 8,
    "figure.constrained_layout.use": True,
})


def select(rows, **wanted):
    """The rows in which each key has the wanted value."""
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def values_of(rows, key):
    """The values of a key in the order in which they come up."""
    return list(dict.fromkeys(row[key] for row in rows))


def median_ns(row):
    return row["ns_per_boid"]["median"]


def median_ms(row):
    return row["ms_per_step"]["median"]


def draw_line(axes, rows, x, y, label, number):
    rows = sorted(rows, key=lambda row: row[x])
    axes.loglog([row[x] for row in rows], [y(row) for row in rows], color=COLOURS[number % len(COLOURS)],
                marker=MARKERS[number % len(MARKERS)], label=label)


def in_words(value, _=None):
    """0.5, 200, 10k, 1M."""
    for size, letter in ((1e6, "M"), (1e3, "k")):
        if value >= size:
            return f"{value / size:g}{letter}"
    return f"{value:g}"


def label_axis(axis, low, high):
    """Names enough numbers on a logarithmic axis that values between can be read."""
    steps = (1.0, 2.0, 5.0) if high < 300 * low else (1.0,)
    axis.set_major_locator(LogLocator(base=10, subs=steps))
    axis.set_major_formatter(FuncFormatter(in_words))
    axis.set_minor_formatter(NullFormatter())


def save(figure, path):
    for plot in figure.axes:
        if plot.get_xscale() == "log":
            label_axis(plot.xaxis, *plot.get_xlim())
        if plot.get_yscale() == "log":
            label_axis(plot.yaxis, *plot.get_ylim())
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)


def panels(rows, columns, height=3.2):
    return plt.subplots(rows, columns, figsize=(9, height * rows), squeeze=False, sharey="row")


def plot_sizes(figures, path):
    """Boids against time: ours as a line, yardsticks as lines above it."""
    figure, axes = panels(1, 2, 3.8)
    for column, dimensions in enumerate((2, 3)):
        plot = axes[0][column]
        draw_line(plot, select(figures["sizes"], dimensions=dimensions), "boids", median_ns, "sturnus", 0)
        rivals = select(figures["yardsticks"], dimensions=dimensions)
        for number, name in enumerate(values_of(rivals, "yardstick")):
            draw_line(plot, select(rivals, yardstick=name), "boids", lambda row: median_ns(row["theirs"]), name, number + 1)
        plot.set(title=f"{dimensions}D, 20 neighbours in reach, one thread", xlabel="boids",
                 ylabel="ns per boid and step" if column == 0 else None)
        plot.legend(loc="upper right")
    save(figure, path)


def plot_neighbours(figures, path):
    figure, axes = panels(1, 1, 3.4)
    for number, dimensions in enumerate((2, 3)):
        rows = select(figures["neighbours"], dimensions=dimensions)
        draw_line(axes[0][0], rows, "neighbours", median_ns, f"{dimensions}D", number)
    axes[0][0].set(xlabel="neighbours in reach", ylabel="ns per boid and step",
                   title=f"{figures['neighbours'][0]['boids']} boids, one thread")
    axes[0][0].legend()
    save(figure, path)


def plot_grid_of(rows, columns_key, lines_key, x, xlabel, y, ylabel, path):
    """One panel for each dimension and value of one key, one line for each value of another."""
    columns = values_of(rows, columns_key)
    figure, axes = panels(2, len(columns), 2.8)
    for line, dimensions in enumerate((2, 3)):
        for column, value in enumerate(columns):
            plot = axes[line][column]
            mine = select(rows, dimensions=dimensions, **{columns_key: value})
            for number, name in enumerate(values_of(mine, lines_key)):
                draw_line(plot, select(mine, **{lines_key: name}), x, y, name, number)
            plot.set(title=f"{dimensions}D, {value}", xlabel=xlabel, ylabel=ylabel if column == 0 else None)
            plot.legend()
    save(figure, path)


def plot_indexes(figures, path):
    plot_grid_of(figures["indexes"], "spread", "index", "boids", "boids", median_ns, "ns per boid and step", path)


def plot_dense(figures, path):
    plot_grid_of(figures["dense"], "separation", "path", "neighbours", "neighbours in reach", median_ms, "ms per step",
                 path)


def plot_clumps(figures, path):
    plot_grid_of(figures["clumps"], "separation", "path", "boids", "boids, all in one radius", median_ms, "ms per step",
                 path)


def plot_sixty(figures, path):
    """Bars, with the project's own numbers beside."""
    rows = [("the project, no tree", 150), ("the project, quadtree", 5000)]
    rows += [(row["who"], row["boids"]) for row in figures["sixty"]]
    figure, axes = panels(1, 1, 3.2)
    plot = axes[0][0]
    colours = [COLOURS[0] if name.startswith("sturnus") else "#999999" for name, _ in rows]
    bars = plot.barh([name for name, _ in rows], [count for _, count in rows], color=colours)
    plot.bar_label(bars, padding=3)
    plot.invert_yaxis()
    plot.set(xscale="log", xlabel="boids at 60 steps a second", xlim=(50, 4 * max(count for _, count in rows)))
    plot.grid(axis="y", visible=False)
    save(figure, path)


PLOTS = {"sizes": plot_sizes, "neighbours": plot_neighbours, "indexes": plot_indexes, "dense": plot_dense,
         "clumps": plot_clumps, "sixty": plot_sixty}
