from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import date as _date
from decimal import Decimal
from fractions import Fraction
from os import PathLike
from typing import Any, Literal

from ._passivity import IdentificationError as IdentificationError
from ._passivity import SceneError as SceneError
from ._passivity import SimulationError as SimulationError
from ._passivity import TraceError as TraceError
from ._passivity import __version__ as __version__
from .results import AuditReport as AuditReport
from .results import Identification as Identification
from .results import Record as Record
from .results import Simulation as Simulation
from .results import SweepResult as SweepResult
from .results import Verdict as Verdict

__all__ = [
    "AuditReport",
    "Identification",
    "IdentificationError",
    "Record",
    "SceneError",
    "Simulation",
    "SimulationError",
    "SweepResult",
    "TraceError",
    "Verdict",
    "__version__",
    "audit",
    "check",
    "identify",
    "interval",
    "simulate",
    "sweep",
]

_Path = str | PathLike[str]
_Scene = _Path | Mapping[str, Any]
_Exact = str | int | float | Fraction | Decimal
_Numbers = Sequence[int] | Sequence[float] | Any
_Range = str | _Exact | Iterable[_Exact]
_Progress = Callable[[int, int | None], object]

def check(scene: _Scene) -> Verdict: ...
def interval(xi0: _Exact, xi1: _Exact, *, beta: _Exact, sigma: _Exact, dtau: _Exact = 1) -> Record: ...
def audit(
    trace: _Path | Sequence[_Path] | _Numbers,
    scene: _Scene,
    *,
    unit: str | None = None,
    t: _Numbers | None = None,
    t_unit: str | None = "s",
    f: _Numbers | None = None,
    f_unit: str | None = None,
    columns: str | Sequence[str] | Mapping[str, str] | None = None,
    delimiter: str | None = None,
    decimal_comma: bool = False,
    law: bool = False,
    out: _Path | None = None,
    threads: int = 0,
    progress: _Progress | None = None,
) -> AuditReport: ...
def identify(
    logs: _Path | Sequence[_Path],
    sketch: _Scene,
    *,
    count_error: float = 1.0,
    force_error: float = 0.0,
    scale_error: float | None = None,
    inertia: Literal["sketch", "free"] = "sketch",
    effort: int | None = None,
    columns: str | Sequence[str] | Mapping[str, str] | None = None,
    delimiter: str | None = None,
    decimal_comma: bool = False,
    out: _Path | None = None,
    device: str | None = None,
    date: str | _date | None = None,
    progress: _Progress | None = None,
) -> Identification: ...
def simulate(
    scene: _Scene,
    *,
    method: str = "closed-form",
    intervals: int | None = None,
    speed: _Exact | None = None,
    trace: bool = True,
    progress: _Progress | None = None,
) -> Simulation: ...
def sweep(
    scene: _Scene,
    *,
    beta: _Range | None = None,
    sigma: _Range | None = None,
    speed: _Range | None = None,
    vary: Mapping[str, _Range] | None = None,
    intervals: int | None = None,
    out: _Path | None = None,
    resume: bool = False,
    threads: int = 0,
    progress: _Progress | None = None,
) -> SweepResult: ...
