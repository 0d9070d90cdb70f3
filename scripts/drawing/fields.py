"""The boxes of a fields file, level by level."""
from collections import namedtuple

import numpy as np

# lo, hi: first and last cell (i, j, k); shape: of the data, (k, j, i)
FieldBox = namedtuple("FieldBox", "level h lo hi shape cells data")


def boxes_of(file):
    """Yields the FieldBoxes of an open VTKHDF file, coarse to fine."""
    root = file["VTKHDF"]
    for name in sorted((k for k in root if k.startswith("Level")), key=lambda k: int(k[5:])):
        level, first = root[name], 0
        for box in level["AMRBox"][:].reshape(-1, 3, 2):
            n = box[:, 1] - box[:, 0] + 1
            cells = slice(first, first + int(np.prod(n)))
            yield FieldBox(int(name[5:]), level.attrs["Spacing"][0], box[:, 0], box[:, 1], tuple(n[::-1]), cells,
                           level["CellData"])
            first = cells.stop


def values(box, name):
    """An array of a box as (k, j, i), with the components last if it has several."""
    data = box.data[name]
    return data[box.cells].reshape(*box.shape, *data.shape[1:])


def middle_of(file):
    """The centre (x, y) of the domain, which level 0 covers."""
    coarsest = [box for box in boxes_of(file) if box.level == 0]
    last = np.max([box.hi[:2] for box in coarsest], axis=0)
    return file["VTKHDF"].attrs["Origin"][:2] + 0.5 * coarsest[0].h * (last + 1)
