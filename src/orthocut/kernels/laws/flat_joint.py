"""Flat joint: two rigid flat faces glued to two discs, with an elastic, breakable interface between them.

Yang et al. (2018), eqs 1-6, after Potyondy's flat-joint model. Tension is positive, the gap is positive when open. The
faces have half-length R and are cut into equal elements of half-length a. With the normal n from the first to the
second disc and the tangent s = n turned by +90 degrees, the gap at the place y along s is g(y) = gap - rotation y,
where rotation is the rotation of the second disc less that of the first. Unit width out of the plane.

The paper's eq. 5 prints a minus sign for closed unbonded elements; with tension positive it must be +k_n g.
"""

from orthocut.kernels.jit import inline


@inline
def joint_intact(gap, rotation, stress_shear, half_length, stiffness, reach):
    """Resultants of a joint whose elements are all bonded.

    Parameters
    ----------
    gap : float
        Gap at the centre of the interface [m].
    rotation : float
        Relative rotation of the faces [rad].
    stress_shear : float
        Shear stress [Pa].
    half_length : float
        Half-length of the faces R [m].
    stiffness : float
        Normal stiffness k_n [Pa/m].
    reach : float
        Offset of the outermost element's centre over R, (N - 1)/N for N elements.

    Returns
    -------
    force_normal, force_shear : float
        Resultants [N/m].
    moment : float
        Moment of the normal stress, the integral of y sigma [N].
    stress_largest : float
        Largest normal stress at the centre of an element [Pa].
    """
    force_normal = 2.0 * half_length * stiffness * gap
    force_shear = 2.0 * half_length * stress_shear
    moment = -stiffness * rotation * (2.0 / 3.0) * half_length * half_length * half_length
    stress_largest = stiffness * (gap + abs(rotation) * reach * half_length)
    return force_normal, force_shear, moment, stress_largest


@inline
def element_failure(stress_normal, stress_shear, strength_tensile, cohesion, tangent):
    """Mode in which a bonded element fails: 0 none, 1 tension, 2 shear (eq. 3; tension is tested first).

    Parameters
    ----------
    stress_normal, stress_shear : float
        Stresses at the centre of the element [Pa].
    strength_tensile, cohesion : float
        Strengths [Pa].
    tangent : float
        Tangent of the friction angle of bonded elements.
    """
    shear = 2.0 if abs(stress_shear) > cohesion - stress_normal * tangent else 0.0
    return 1.0 if stress_normal > strength_tensile else shear


@inline
def element_closure(bonded, gap, rotation, half_length, stiffness):
    """Normal response of one element; of an unbonded one only the closed part transmits (eq. 5).

    Parameters
    ----------
    bonded : float
        1 while bonded, else 0.
    gap : float
        Gap at the centre of the element [m].
    rotation : float
        Relative rotation of the faces [rad].
    half_length : float
        Half-length of the element a [m].
    stiffness : float
        Normal stiffness [Pa/m].

    Returns
    -------
    force : float
        Normal force [N/m].
    moment : float
        Moment of the normal stress about the centre of the element [N].
    energy : float
        Elastic energy of the normal stress [J/m].
    """
    spread = abs(rotation) * half_length
    low = gap - spread
    high = gap + spread
    closed = 1.0
    if bonded == 0.0 and high > 0.0:
        closed = low / (low - high) if low < 0.0 else 0.0
        high = 0.0
        low = low if low < 0.0 else 0.0
    length = 2.0 * half_length * closed
    side = 1.0 if rotation > 0.0 else -1.0
    force = 0.5 * stiffness * (low + high) * length
    moment = side * (force * (half_length - 0.5 * length) + stiffness * (low - high) * length * length / 12.0)
    energy = stiffness * length * (low * low + low * high + high * high) / 6.0
    return force, moment, energy


@inline
def element_slip(trial, stress_normal, friction):
    """Shear stress of an unbonded element after Coulomb's limit (eqs 4, 6).

    Parameters
    ----------
    trial : float
        Shear stress without slip [Pa].
    stress_normal : float
        Mean normal stress of the element [Pa], never positive.
    friction : float
        Residual friction coefficient.
    """
    limit = -friction * stress_normal
    below = trial if trial < limit else limit
    return below if below > -limit else -limit
