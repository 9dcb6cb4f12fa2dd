# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
from numpy.typing import ArrayLike, NDArray

def overlay(depth: ArrayLike, labels: ArrayLike) -> NDArray[np.uint8]: ...
