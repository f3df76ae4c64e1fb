from typing import Any

from .results import Simulation, SweepResult

__all__ = ["motion", "outcomes"]

def motion(simulation: Simulation, *, column: str = "xi0", axes: Any | None = None) -> Any: ...
def outcomes(sweep: SweepResult, *, third: int = 0, axes: Any | None = None) -> Any: ...
