from collections.abc import Mapping, Sequence
from typing import Any, overload

from . import _Path, _Progress, _Scene
from .adaptive import Border
from .results import AuditReport, SweepResult

__all__ = ["audit", "border", "sweep"]

def sweep(
    client: Any,
    scene: _Scene,
    grid: Mapping[str, Any],
    *,
    out: _Path,
    parts: _Path | None = None,
    storage_options: Mapping[str, Any] | None = None,
    seconds: float = 5.0,
    shards: int | None = None,
    threads: int = 1,
    retries: int = 20,
    merge: bool = True,
    keep: bool = False,
    progress: _Progress | None = None,
) -> SweepResult: ...
@overload
def audit(
    client: Any,
    files: _Path,
    scene: _Scene,
    *,
    columns: str | Sequence[str] | Mapping[str, str] | None = None,
    delimiter: str | None = None,
    decimal_comma: bool = False,
    law: bool = False,
    parts: _Path | None = None,
    storage_options: Mapping[str, Any] | None = None,
    seconds: float = 5.0,
    shards: int | None = None,
    threads: int = 1,
    retries: int = 20,
    progress: _Progress | None = None,
) -> AuditReport: ...
@overload
def audit(
    client: Any,
    files: Sequence[_Path],
    scene: _Scene,
    *,
    columns: str | Sequence[str] | Mapping[str, str] | None = None,
    delimiter: str | None = None,
    decimal_comma: bool = False,
    law: bool = False,
    parts: _Path | None = None,
    storage_options: Mapping[str, Any] | None = None,
    seconds: float = 5.0,
    shards: int | None = None,
    threads: int = 1,
    retries: int = 20,
    progress: _Progress | None = None,
) -> list[AuditReport]: ...
def border(
    client: Any | None,
    scene: _Scene,
    grid: Mapping[str, Any],
    *,
    coarse: int = 16,
    thorough: bool = True,
    chunk: int = 2000,
    threads: int = 1,
    retries: int = 20,
    progress: _Progress | None = None,
) -> Border: ...
