"""What the stubs promise: checked by mypy --strict and pyright, not run."""

from collections.abc import Sequence

import passivity
from passivity import adaptive, distributed, plot


def all_of_it(client: object, path: str) -> None:
    verdict: passivity.Verdict = passivity.check(path)
    name: str = verdict.verdict
    row: passivity.Record = passivity.interval(0, "1/2", beta=1, sigma=0.5)
    report = passivity.audit([1, 2], path, t=[0.0, 1.0], f=[0.0, 1.0], f_unit="N m")
    intervals: int = report.intervals
    motion = passivity.simulate(path, speed="5 rad/s", method="exact")
    text: str = motion.svg()
    grid = passivity.sweep(path, vary={"stiffness": "1:2:3 N/m", "viscous": "0:1:2 N s/m"})
    cells: dict[str, list[object]] = grid.columns
    points: int = distributed.sweep(client, path, {"beta": [0, 1], "sigma": "0:1:2"}, out="x").points
    one: passivity.AuditReport = distributed.audit(client, path, path)
    many: list[passivity.AuditReport] = distributed.audit(client, [path], path)
    border: adaptive.Border = distributed.border(None, path, {"beta": "0:1:9", "sigma": "0:1:9"})
    found: passivity.Identification = passivity.identify([path], path, inertia="free", effort=5)
    scene: str | None = found.toml
    plot.motion(motion)
    plot.outcomes(grid)
    try:
        passivity.check(path)
    except passivity.SceneError as error:
        line: int | None = error.line
        print(line, name, row, intervals, text, cells, points, one, many, border.cells, scene)


def outcomes(indices: list[int]) -> Sequence[bool]:
    return [index > 3 for index in indices]


adaptive.refine((3, 3, 1), outcomes)
