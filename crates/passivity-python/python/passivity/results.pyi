from collections.abc import Sequence
from typing import Any, Self

__all__ = ["AuditReport", "Identification", "Record", "Simulation", "SweepResult", "Verdict"]

class Record(dict[str, Any]):
    def __getattr__(self, name: str) -> Any: ...
    @classmethod
    def from_json(cls, text: str) -> Self: ...
    def _repr_html_(self) -> str: ...
    def to_arrow(self) -> Any: ...

class Verdict(Record):
    scene: str
    verdict: str
    region: str
    because: list[str]
    not_covered: list[str]
    spare: Record

class AuditReport(Record):
    certificate: Record | None
    scene: str
    verdict: str
    judged: str
    samples: int
    intervals: int
    totals: Record
    error: Record | None

class Identification(Record):
    toml: str | None
    picture: str | None
    scene: str
    logs: list[Record]
    samples: int
    parameters: Record
    refuted_by: Record | None
    informative: bool
    lacks: list[str]
    stopped_early: bool
    best_refuted: bool
    def svg(self) -> str: ...

class Simulation(Record):
    columns: dict[str, Any]
    scene: str
    method: str
    intervals: int
    outcome: Record
    totals: Record
    def svg(self, width: int = 640, height: int = 240) -> str: ...

class SweepResult(Record):
    path: str | None
    axes: list[str]
    scene: str
    points: int
    simulated: int
    exact: Record
    paper: Record
    @classmethod
    def of_file(cls, report: str, axes: list[str], path: str) -> Self: ...
    @property
    def columns(self) -> dict[str, list[Any]]: ...
    def svg(self, size: int = 320) -> str: ...

def doubles(data: bytes) -> Sequence[float]: ...
