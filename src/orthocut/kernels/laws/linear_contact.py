"""Linear contact with Coulomb friction and no tension, for discs at walls and discs that meet later."""

from orthocut.kernels.jit import inline


@inline
def linear_contact(gap, shear, slip, stiffness, stiffness_ratio, friction):
    """Normal and shear force of a contact.

    Parameters
    ----------
    gap : float
        Distance of the surfaces [m], negative when they overlap.
    shear : float
        Shear force before the step [N/m].
    slip : float
        Relative tangential displacement in the step [m].
    stiffness : float
        Normal stiffness [Pa] for unit width.
    stiffness_ratio : float
        Normal over shear stiffness.
    friction : float
        Coulomb coefficient.

    Returns
    -------
    push : float
        Normal force [N/m], never negative.
    shear_new : float
        Shear force after the step [N/m], opposed to the slip.
    loss : float
        Work of friction in the step [J/m].
    """
    push = -stiffness * gap if gap < 0.0 else 0.0
    stiffness_shear = stiffness / stiffness_ratio
    trial = shear - stiffness_shear * slip
    limit = friction * push
    shear_new = min(max(trial, -limit), limit)
    loss = 0.5 * (shear + shear_new) * (shear_new - trial) / stiffness_shear
    return push, shear_new, -loss
