"""Search for pairs of close discs by a grid of cells."""

from orthocut.kernels.dem.layout import ROW
from orthocut.kernels.jit import part


@part
def sort_into_cells(cell_start, cell_disc, cell_of, position, grid):
    """Counting sort of discs into cells; discs outside the grid go into its outermost cells.

    Parameters
    ----------
    cell_start : int array, shape (n_cells + 1,)
    cell_disc, cell_of : int arrays, shape (n_discs,)
        Discs cell by cell in ascending order, and the cell of each disc.
    position : float array, shape (4 n_discs,)
    grid : tuple
        Corner (x, y) [m], cell size [m], number of columns and of rows.

    Returns
    -------
    bool
        False, with the cells left unfinished, if a position is not a number.
    """
    left, bottom, size, columns, rows = grid
    cell_start[:] = 0
    for m in range(cell_of.size):
        column = (position[m * ROW] - left) / size
        row = (position[m * ROW + 1] - bottom) / size
        if column != column or row != row:
            return False
        cell_of[m] = int(min(max(row, 0.0), rows - 1.0)) * columns + int(min(max(column, 0.0), columns - 1.0))
        cell_start[cell_of[m] + 1] += 1
    for c in range(columns * rows):
        cell_start[c + 1] += cell_start[c]
    for m in range(cell_of.size):
        cell_disc[cell_start[cell_of[m]]] = m
        cell_start[cell_of[m]] += 1
    for c in range(columns * rows, 0, -1):
        cell_start[c] = cell_start[c - 1]
    cell_start[0] = 0
    return True


@part
def find_pairs(pair_start, pair_second, cell_start, cell_disc, cell_of, position, radius, skin, grid):
    """List all pairs i < j whose surfaces are closer than `skin`, in ascending order of i.

    Valid while the cells are larger than twice the largest radius plus `skin`.

    Returns
    -------
    int
        Number of pairs, or -1 if `pair_second` is too short or a position is not a number.
    """
    if not sort_into_cells(cell_start, cell_disc, cell_of, position, grid):
        return -1
    _, _, _, columns, rows = grid
    count = 0
    for i in range(radius.size):
        pair_start[i] = count
        x, y, reach = position[i * ROW], position[i * ROW + 1], radius[i] + skin
        row, column = divmod(cell_of[i], columns)
        for r in range(max(row - 1, 0), min(row + 2, rows)):
            first = cell_start[r * columns + max(column - 1, 0)]
            last = cell_start[r * columns + min(column + 1, columns - 1) + 1]
            for c in range(first, last):
                j = cell_disc[c]
                if j > i:
                    dx = position[j * ROW] - x
                    dy = position[j * ROW + 1] - y
                    distance = reach + radius[j]
                    if dx * dx + dy * dy < distance * distance:
                        if count >= pair_second.size:
                            return -1
                        pair_second[count] = j
                        count += 1
    pair_start[radius.size] = count
    return count
