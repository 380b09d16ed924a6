import os
from typing import Any, Iterable, Sequence, Tuple

import numpy as np

from . import Shape, WorldView

class CommonError(RuntimeError): ...

nearest: np.dtype[Any]

def sweep_configurations(
    poses: str | os.PathLike[str],
    out: str | os.PathLike[str],
    links: Sequence[Shape],
    scene: WorldView,
    *,
    pairs: Iterable[Tuple[int, int]] = ...,
    limit: float = ...,
    journal: str | os.PathLike[str] | None = ...,
    name: str = ...,
    comm: Any = ...,
) -> dict[str, Any]: ...
