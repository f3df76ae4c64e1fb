from collections.abc import Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from os import PathLike
from typing import Any

__version__: str

Scene = str | PathLike[str] | Mapping[str, Any]
Exact = str | int | float | Fraction | Decimal

def check(scene: Scene) -> dict[str, Any]: ...
def interval(
    xi0: Exact, xi1: Exact, *, beta: Exact, sigma: Exact, dtau: Exact = 1
) -> dict[str, Any]: ...
def audit(
    trace: str | PathLike[str] | Sequence[int] | Sequence[float] | Any,
    scene: Scene,
    *,
    unit: str | None = None,
    t: Sequence[float] | Any | None = None,
    t_unit: str | None = "s",
    out: str | PathLike[str] | None = None,
    threads: int = 0,
) -> dict[str, Any]: ...

class Simulation(dict[str, Any]):
    columns: dict[str, Any]

def simulate(
    scene: Scene,
    *,
    method: str = "closed-form",
    intervals: int | None = None,
    trace: bool = True,
) -> Simulation: ...
