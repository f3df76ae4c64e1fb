from collections.abc import Callable, Sequence
from typing import Any

__version__: str
MAX_INTERVALS: int
EFFORT: tuple[int, int]

class SceneError(ValueError):
    line: int | None
    column: int | None
    key: str | None
    kind: str | None
    diagnostics: str

class TraceError(ValueError):
    row: int | None
    column: str | None
    kind: str
    file: str | None

class SimulationError(ValueError): ...

class IdentificationError(ValueError):
    not_covered: bool

_Scene = tuple[str, str]
_Progress = Callable[[int], object] | None
_Report = tuple[str, str | None]

def check(scene: _Scene) -> str: ...
def answer(request: bytes) -> str: ...
def audit_file(
    traces: Sequence[str],
    scene: _Scene,
    reading: dict[str, Any],
    out: str | None = None,
    progress: _Progress = None,
) -> _Report: ...
def audit_arrays(
    columns: Sequence[tuple[str, Any]],
    scene: _Scene,
    reading: dict[str, Any],
    out: str | None = None,
    progress: _Progress = None,
) -> _Report: ...
def audit_piece(
    trace: str, scene: _Scene, reading: dict[str, Any], stretch: str, progress: _Progress = None
) -> tuple[str, int, int]: ...
def audit_merge(parts: Sequence[tuple[str, str]], scene: _Scene) -> _Report: ...
def identify(
    logs: Sequence[str],
    sketch: _Scene,
    asked: dict[str, Any],
    out: str | None = None,
    progress: _Progress = None,
) -> tuple[str, str | None, str | None, str | None]: ...
def simulate(
    scene: _Scene,
    method: str,
    intervals: int | None = None,
    speed: str | None = None,
    trace: bool = True,
    progress: _Progress = None,
) -> tuple[str, list[tuple[str, bytes]]]: ...
def grid(scene: _Scene, ranges: dict[str, Any]) -> tuple[int, list[str], list[list[float]]]: ...
def sweep(
    scene: _Scene,
    ranges: dict[str, Any],
    out: str,
    shard: tuple[int, int, int] | None = None,
    resume: bool = False,
    threads: int = 0,
    progress: _Progress = None,
) -> str: ...
def sweep_merge(
    scene: _Scene, ranges: dict[str, Any], parts: Sequence[str], out: str, progress: _Progress = None
) -> str: ...
def sweep_points(
    scene: _Scene,
    ranges: dict[str, Any],
    indices: Sequence[int],
    threads: int = 0,
    progress: _Progress = None,
) -> list[tuple[str, str, int | None, float, float]]: ...
