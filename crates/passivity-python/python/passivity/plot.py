"""Pictures of results by matplotlib: ``pip install passivity[plot]``."""

from __future__ import annotations

from .results import _COLOURS

__all__ = ["motion", "outcomes"]


def _axes(axes):
    try:
        from matplotlib import pyplot
    except ImportError:
        raise ImportError("pictures need matplotlib: pip install passivity[plot]") from None
    return axes if axes is not None else pyplot.subplots()[1]


def motion(simulation, *, column="xi0", axes=None):
    """A column of a :class:`passivity.Simulation` against the interval; gives the axes."""
    axes = _axes(axes)
    axes.plot(simulation.columns[column], drawstyle="steps-post" if column != "xi0" else "default")
    axes.set_xlabel("interval")
    axes.set_ylabel("position in ticks" if column == "xi0" else column)
    axes.set_title(f"{simulation['scene']}: {simulation['outcome']['exact'].replace('_', ' ')}")
    return axes


def outcomes(sweep, *, third=0, axes=None):
    """The map of a :class:`passivity.SweepResult` over its first two axes, at one value of the third, by its
    place; gives the axes."""
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    axes = _axes(axes)
    columns, names = sweep.columns, sweep.axes
    levels = [sorted(set(columns[name])) for name in names]
    places = [{value: i for i, value in enumerate(level)} for level in levels]
    kinds = list(_COLOURS)
    image = [[float("nan")] * len(levels[0]) for _ in levels[1]]
    for i, outcome in enumerate(columns["exact"]):
        if len(names) < 3 or columns[names[2]][i] == levels[2][third]:
            x, y = (places[axis][columns[names[axis]][i]] for axis in (0, 1))
            image[y][x] = kinds.index(outcome)
    colours = ListedColormap([_COLOURS[kind] for kind in kinds])
    axes.pcolormesh(levels[0], levels[1], image, cmap=colours, vmin=-0.5, vmax=len(kinds) - 0.5, shading="nearest")
    axes.set_xlabel(names[0])
    axes.set_ylabel(names[1])
    axes.legend(handles=[Patch(color=_COLOURS[kind], label=kind.replace("_", " ")) for kind in kinds])
    return axes
