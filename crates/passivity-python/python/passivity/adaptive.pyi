from collections.abc import Callable, Hashable, Sequence
from typing import TypeVar

from .results import Record

__all__ = ["Border", "refine"]

_Outcome = TypeVar("_Outcome", bound=Hashable)

class Border(Record):
    points: int
    simulated: int
    cells: list[tuple[int, int, int]]
    outcomes: dict[int, str]
    axes: list[str]

def refine(
    shape: Sequence[int],
    evaluate: Callable[[list[int]], Sequence[_Outcome]],
    *,
    coarse: int = 16,
    thorough: bool = True,
) -> tuple[list[tuple[int, int, int]], dict[int, _Outcome]]: ...
