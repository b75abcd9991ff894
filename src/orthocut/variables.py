"""The table of variables: name, symbol, unit and meaning of everything that datasets, axes and tables show.

Axes: x along the cut, against the motion of the tool; y up, out of the workpiece. All quantities are SI for unit width
out of the plane: forces in N/m, energies in J/m. Tension is positive. Forces on the tool are positive where the tool
pushes the workpiece along its motion (cutting) and down into it (thrust). Reactions are forces of the clamp on the
workpiece in the same directions, so that a steady reaction is the negative of the force.
"""

from __future__ import annotations

from typing import Any, NamedTuple


class Variable(NamedTuple):
    """One row of the table."""

    symbol: str
    """Symbol in mathtext, without the dollar signs."""
    unit: str
    """SI unit of the stored values."""
    long_name: str
    """Meaning in words."""
    display: str = ""
    """Unit in figures and tables; empty where the SI unit serves."""
    scale: float = 1.0
    """Number of display units in one SI unit."""


_MM = ("mm", 1e3)
_MPA = ("MPa", 1e-6)
_N_MM = ("N/mm", 1e-3)
_MS = ("ms", 1e3)
_DEG = ("deg", 57.29577951308232)

VARIABLES: dict[str, Variable] = {
    # parameters that sweeps vary
    "cut_depth": Variable("h", "m", "depth of cut", *_MM),
    "cut_speed": Variable("v", "m/s", "speed of the tool"),
    "rake_angle": Variable(r"\alpha", "rad", "rake angle", *_DEG),
    "friction": Variable(r"\mu", "1", "friction coefficient"),
    "modulus_tangent": Variable("E_T", "Pa", "tangent modulus", *_MPA),
    "strength": Variable(r"\sigma_c", "Pa", "cohesive stress", *_MPA),
    "points_per_cell": Variable("n_c", "1", "material points along each side of a cell"),
    "grid_offset": Variable("", "1", "height of the row of nodes next above the cut over the cell size"),
    "points_per_depth": Variable("n", "1", "material points through the depth of cut"),
    "seed": Variable("s", "1", "seed of the packing"),
    "grooved": Variable(r"g", "1", "grooves in the surface (1) or not (0)"),
    # other parameters of cases
    "kind": Variable("", "1", "kind of the run"),
    "case_id": Variable("", "1", "name of the case"),
    "case_json": Variable("", "1", "the whole case"),
    "status": Variable("", "1", "how the run ended"),
    "failure": Variable("", "1", "why the run failed"),
    "component": Variable("", "1", "component of the deformation gradient"),
    "wall_time": Variable("", "s", "run time"),
    "steps_taken": Variable("", "1", "time steps that the run took"),
    "clearance_angle": Variable(r"\theta", "rad", "clearance angle", *_DEG),
    "travel": Variable("s", "m", "travel of the tool", *_MM),
    "travel_ratio": Variable("s/h", "1", "travel of the tool over depth of cut"),
    "window_ratio": Variable("", "1", "travel over depth of cut at which averages start"),
    "modulus_bulk": Variable("K", "Pa", "bulk modulus", *_MPA),
    "modulus_shear": Variable("G", "Pa", "shear modulus", *_MPA),
    "density": Variable(r"\rho", "kg/m3", "density"),
    "stress_yield": Variable(r"\sigma_y", "Pa", "initial yield stress", *_MPA),
    "hardening": Variable("", "1", "law of the yield stress"),
    "hardening_modulus": Variable("K_h", "Pa", "factor of the power of the plastic strain", *_MPA),
    "hardening_exponent": Variable("n_h", "1", "exponent of the plastic strain"),
    "stress_saturation": Variable(r"\sigma_s", "Pa", "limit of the yield stress", *_MPA),
    "strain_saturation": Variable(r"\epsilon_s", "1", "plastic strain in which the yield stress nears its limit"),
    "law": Variable("", "1", "shape of the cohesive law"),
    "peak_ratio": Variable(r"\delta_p/\delta_c", "1", "opening at the cohesive stress over the critical opening"),
    "failure_criterion": Variable("", "1", "criterion of failure of the interface"),
    "toughness": Variable("G_c", "J/m2", "fracture toughness"),
    "length_ratio": Variable("w", "1", "length of the workpiece over depth of cut"),
    "base_ratio": Variable("d", "1", "depth of the base over depth of cut"),
    "notch_ratio": Variable("a", "1", "length of the notch over depth of cut"),
    "path_ratio": Variable("", "1", "length of notch and cohesive path over depth of cut"),
    "bottom": Variable("", "1", "kind of support of the bottom"),
    "window": Variable("", "1", "how the window of averages begins"),
    "error_target": Variable("", "1", "relative standard error at which a cut ends"),
    "courant": Variable("C", "1", "Courant number"),
    "affine": Variable("", "1", "share of the velocity gradient that points hand on"),
    "support": Variable("", "1", "share of a cell's mass below which nodes follow others"),
    "reach_ratio": Variable("r", "1", "reach of what moves ahead of the tool over depth of cut"),
    "scheme": Variable("", "1", "loop of a time step"),
    "flip": Variable(r"\beta", "1", "share of their own velocity that points keep"),
    "position_order": Variable("", "1", "order of the update of positions"),
    "contact": Variable("", "1", "how contact with the tool is found"),
    "ramp_fraction": Variable("", "1", "fraction of the duration in which the tool speeds up"),
    "ramp_feedback": Variable("g", "m-2", "gain of the feedback damping", "mm$^{-2}$", 1e-6),
    "packing_width": Variable("W", "m", "width of the packing", *_MM),
    "packing_height": Variable("H", "m", "height of the packing", *_MM),
    "packing_radius_min": Variable("R_{min}", "m", "smallest radius", "um", 1e6),
    "packing_radius_ratio": Variable("R_{max}/R_{min}", "1", "largest over smallest radius"),
    "packing_pressure_ratio": Variable("P/E^*", "1", "packing pressure over contact modulus"),
    "packing_porosity_cloud": Variable("n_c", "1", "porosity of the cloud of discs before scaling"),
    "joint_modulus": Variable("E^*", "Pa", "contact and joint modulus", "GPa", 1e-9),
    "joint_stiffness_ratio": Variable(r"\kappa", "1", "normal over shear stiffness"),
    "joint_strength_tensile": Variable(r"\sigma_c", "Pa", "tensile strength of a joint", *_MPA),
    "joint_cohesion": Variable("c", "Pa", "cohesion of a joint", *_MPA),
    "joint_friction_angle": Variable(r"\phi", "rad", "friction angle of a joint", *_DEG),
    "joint_friction": Variable(r"\mu", "1", "residual friction coefficient of a joint"),
    "joint_elements": Variable("N_r", "1", "elements of a joint"),
    "joint_radius_multiplier": Variable(r"\lambda", "1", "half-length of a joint over the smaller radius"),
    "joint_gap_ratio": Variable("g_i/R", "1", "installation gap over the smaller radius"),
    "joint_fraction_slit": Variable(r"f_S", "1", "fraction of slit joints"),
    "joint_fraction_gapped": Variable(r"f_G", "1", "fraction of gapped joints"),
    "joint_gapped_opening": Variable("g_0/R", "1", "initial gap of gapped joints over the smaller radius"),
    "joint_density": Variable(r"\rho", "kg/m3", "density of the discs"),
    "joint_damping": Variable("", "1", "local damping coefficient"),
    "joint_time_step_factor": Variable("", "1", "time step factor"),
    "groove_width": Variable("", "m", "width of a groove at the surface", *_MM),
    "groove_bottom_ratio": Variable("", "1", "width of a groove at its bottom over that at the surface"),
    "groove_distance": Variable("", "m", "clear distance between grooves at the surface", *_MM),
    "grip_speed": Variable("v", "m/s", "speed of a grip", "mm/s", 1e3),
    "crack_ratio": Variable("2a/W", "1", "length of the crack over the width of the specimen"),
    "grip_ratio": Variable("", "1", "height of a grip over height of the specimen"),
    "drop_fraction": Variable("", "1", "fraction of the peak stress at which a test ends"),
    "strain_max": Variable("", "1", "axial strain at which a test ends", "%", 100.0),
    "flat_ratio": Variable("", "1", "width of the flats of a round specimen over its diameter"),
    "friction_platen": Variable(r"\mu_p", "1", "friction coefficient of the platens"),
    # results of the cutting models
    "force_over_toughness": Variable("F_c/(bG_c)", "1", "cutting force over toughness"),
    "thrust_over_toughness": Variable("F_t/(bG_c)", "1", "thrust force over toughness"),
    "depth_dimensionless": Variable(r"h\sigma_y^2/(2E'G_c)", "1", "dimensionless depth of cut"),
    "curvature_ratio": Variable(r"k_0", "1", "curvature over curvature at first yield"),
    "angle_shear": Variable(r"\phi", "rad", "angle of the shear plane", *_DEG),
    # histories
    "time": Variable("t", "s", "time", *_MS),
    "tool_travel": Variable("s", "m", "travel of the tool", *_MM),
    "force_cutting": Variable("F_c", "N/m", "cutting force on the tool", *_N_MM),
    "force_thrust": Variable("F_t", "N/m", "thrust force on the tool", *_N_MM),
    "force_cutting_chip": Variable("F_c^{chip}", "N/m", "cutting force from the chip", *_N_MM),
    "force_thrust_chip": Variable("F_t^{chip}", "N/m", "thrust force from the chip", *_N_MM),
    "force_cutting_base": Variable("F_s^b", "N/m", "cutting force from rubbing on the base", *_N_MM),
    "force_thrust_base": Variable("F_n^b", "N/m", "thrust force from rubbing on the base", *_N_MM),
    "reaction_cutting": Variable("R_c", "N/m", "force of the clamp on the workpiece along the cut", *_N_MM),
    "reaction_thrust": Variable("R_t", "N/m", "force of the clamp on the workpiece across the cut", *_N_MM),
    "tool_tip": Variable("x_{tool}", "m", "position of the tool tip", *_MM),
    "crack_tip": Variable("x_{crack}", "m", "position of the crack tip", *_MM),
    "crack_gap": Variable("g", "m", "distance from the tool tip ahead to the crack tip", *_MM),
    "work_tool": Variable("W", "J/m", "work of the tool"),
    "energy_kinetic": Variable("E_{kin}", "J/m", "kinetic energy"),
    "energy_elastic": Variable("E_{el}", "J/m", "elastic energy"),
    "energy_plastic": Variable("E_{pl}", "J/m", "plastic work"),
    "work_plastic_base": Variable("E_{pl}^b", "J/m", "plastic work in the base"),
    "energy_cohesive": Variable("E_{coh}", "J/m", "work on the cohesive zone"),
    "energy_fracture": Variable("E_{frac}", "J/m", "energy released by broken joints"),
    "energy_friction": Variable("E_{fric}", "J/m", "work of friction"),
    "energy_contact": Variable("E_{con}", "J/m", "energy lost in contacts, by impacts and transfers"),
    "energy_numerical": Variable("E_{num}", "J/m", "energy lost in transfers between points and grid"),
    "energy_damping": Variable("E_{damp}", "J/m", "energy removed by damping"),
    "energy_residual": Variable("E_{res}", "J/m", "work of the tool not accounted for"),
    "strain_axial": Variable(r"\varepsilon", "1", "axial strain", "%", 100.0),
    "strain_gauge": Variable(r"\varepsilon_g", "1", "axial strain in the measurement region", "%", 100.0),
    "strain_lateral": Variable(r"\varepsilon_{lat}", "1", "lateral strain", "%", 100.0),
    "stress_axial": Variable(r"\sigma", "Pa", "axial stress in the measurement region", *_MPA),
    "stress_grip": Variable(r"\sigma_{grip}", "Pa", "axial stress from the grip reaction", *_MPA),
    "cracks_tension": Variable("N_t", "1", "number of elements broken in tension"),
    "cracks_shear": Variable("N_s", "1", "number of elements broken in shear"),
    # results of a run
    "force_cutting_mean": Variable("F_c", "N/m", "mean cutting force", *_N_MM),
    "force_thrust_mean": Variable("F_t", "N/m", "mean thrust force", *_N_MM),
    "force_rubbing_mean": Variable("F_n^b", "N/m", "mean rubbing force", *_N_MM),
    "force_rubbing_error": Variable(r"\Delta F_n^b", "N/m", "standard error of the mean rubbing force", *_N_MM),
    "force_cutting_error": Variable(r"\Delta F_c", "N/m", "standard error of the mean cutting force", *_N_MM),
    "force_thrust_error": Variable(r"\Delta F_t", "N/m", "standard error of the mean thrust force", *_N_MM),
    "force_cutting_peak": Variable(r"F_{c,max}", "N/m", "peak cutting force", *_N_MM),
    "force_thrust_peak": Variable(r"F_{t,max}", "N/m", "peak thrust force", *_N_MM),
    "force_cutting_rms": Variable(
        r"F_{c,rms}", "N/m", "root mean square of the interval means of the cutting force", *_N_MM
    ),
    "force_thrust_rms": Variable(
        r"F_{t,rms}", "N/m", "root mean square of the interval means of the thrust force", *_N_MM
    ),
    "force_cutting_contact": Variable(r"F_c^{con}", "N/m", "mean cutting force while the tool is in contact", *_N_MM),
    "force_thrust_contact": Variable(r"F_t^{con}", "N/m", "mean thrust force while the tool is in contact", *_N_MM),
    "air_share": Variable("a", "1", "share of the travel in which the tool is in the air", "%", 100.0),
    "force_cutting_drift": Variable(r"\delta_F", "1", "drift of the cutting force in the window, over its mean"),
    "window_start": Variable("s_0", "m", "travel from which averages are taken", *_MM),
    "chip_thickness_ratio": Variable("h_c/h", "1", "thickness of the chip over depth of cut"),
    "shear_largest": Variable(r"\gamma", "1", "largest shear strain of the chip (99th percentile)", "%", 100.0),
    "crack_gap_mean": Variable("g", "m", "mean distance from tool tip to crack tip", *_MM),
    "touching": Variable(
        r"I_{touch}", "1", "whether the tool touches the crack tip (1) or the chip bends ahead of it (0)"
    ),
    "mode_one_fraction": Variable(r"J_I/J_c", "1", "fraction of mode I in the energy of failure", "%", 100.0),
    "energy_closure": Variable(r"\delta_E", "1", "energy not accounted for, over the work of the tool", "%", 100.0),
    "modulus_young": Variable("E", "Pa", "Young's modulus", "GPa", 1e-9),
    "ratio_poisson": Variable(r"\nu", "1", "Poisson's ratio"),
    "strength_ultimate": Variable(r"\sigma_u", "Pa", "magnitude of the largest axial stress", *_MPA),
    "toughness_fracture": Variable(
        "K_{Ic}", "Pa m^0.5", "fracture toughness: stress intensity at the largest stress", "MPa m^0.5", 1e-6
    ),
    "strain_peak": Variable(
        r"\varepsilon_u", "1", "axial strain in the measurement region at the largest stress", "%", 100.0
    ),
    "strength_tension": Variable(r"\sigma_t", "Pa", "tensile strength", *_MPA),
    "strength_compression": Variable(r"\sigma_{UCS}", "Pa", "compressive strength", *_MPA),
    "trial_purpose": Variable("", "1", "purpose of an evaluation"),
    "fit_evaluation": Variable("", "1", "index of the fitted evaluation"),
    "fit_converged": Variable("", "1", "whether all properties are within the tolerance"),
    "fit_slope": Variable("J", "1", "relative change of a property over that of a parameter"),
    "fit_spread": Variable("", "1", "relative standard deviation over packings of a fitted parameter"),
    "fit_error": Variable("", "1", "relative standard error of a fitted parameter"),
    "cracks_tension_total": Variable("N_t", "1", "number of elements broken in tension at the end"),
    "cracks_shear_total": Variable("N_s", "1", "number of elements broken in shear at the end"),
    "disc_count": Variable("N", "1", "number of discs of the packing"),
    "bond_count": Variable("N_b", "1", "number of joints"),
    "bonds_gapped": Variable("N_G", "1", "number of joints installed open and not bonded"),
    "bonds_slit": Variable("N_S", "1", "number of joints installed closed and not bonded"),
    "pressure_reached": Variable("p/E", "1", "pressure of the packing over contact modulus, as reached"),
    "porosity": Variable("n_p", "1", "porosity of the packing"),
    "coordination": Variable("z", "1", "mean number of contacts of a disc"),
    "floaters": Variable("N_f", "1", "number of discs with fewer than three contacts"),
    "damage_depth": Variable("d", "m", "depth of the deepest crack below the cut", *_MM),
    "damage_depth_most": Variable("d_{95}", "m", "depth that 95 % of the cracks below the cut keep to", *_MM),
    "cracks_tension_below": Variable("N_t^b", "1", "number of elements broken in tension below the cut"),
    "cracks_shear_below": Variable("N_s^b", "1", "number of elements broken in shear below the cut"),
    "chip_count": Variable("N_c", "1", "number of chips of two discs or more"),
    "chip_area_largest": Variable("A_{max}", "m2", "area of the largest chip", "mm$^2$", 1e6),
    "chip_area_total": Variable(r"\Sigma A", "m2", "area of all chips of two discs or more", "mm$^2$", 1e6),
    "grain_count": Variable("N_1", "1", "number of single discs that came off"),
    "grain_area_total": Variable(r"\Sigma A_1", "m2", "area of single discs that came off", "mm$^2$", 1e6),
    # material points and discs in snapshots
    "time_snapshot": Variable("t", "s", "time of the snapshot", *_MS),
    "point_x": Variable("x", "m", "position along the cut", *_MM),
    "point_y": Variable("y", "m", "position across the cut", *_MM),
    "point_deformation": Variable("F", "1", "deformation gradient (xx, xy, yx, yy)"),
    "point_stress": Variable(r"\sigma_{eq}", "Pa", "equivalent stress", *_MPA),
    "point_strain_plastic": Variable(r"\epsilon", "1", "cumulative plastic strain"),
    "point_half_width": Variable("l", "m", "half-width of an undeformed material point", *_MM),
    "tool_tip_snapshot": Variable("x_{tool}", "m", "position of the tool tip", *_MM),
    "disc_x": Variable("x", "m", "position along the cut", *_MM),
    "disc_y": Variable("y", "m", "position across the cut", *_MM),
    "disc_radius": Variable("R", "m", "radius", "um", 1e6),
    "disc_fixed": Variable("", "1", "whether the disc is fixed (1) or free (0)"),
    "bond_first": Variable("i", "1", "index of the first disc of a joint"),
    "bond_second": Variable("j", "1", "index of the second disc of a joint"),
    "bond_kind": Variable("k", "1", "kind of a joint as installed: 0 bonded, 1 gapped, 2 slit"),
    "bond_intact": Variable(r"\phi_b", "1", "fraction of the elements of a joint that are bonded"),
    "chip_area": Variable("A", "m2", "area of a chip", "mm$^2$", 1e6),
    "crack_x": Variable("x", "m", "place of the crack along the cut", *_MM),
    "crack_y": Variable("y", "m", "place of the crack across the cut", *_MM),
    "crack_normal": Variable(r"\theta", "rad", "direction of the crack normal to the x axis", *_DEG),
    "crack_time": Variable("t", "s", "time of the crack", *_MS),
    "crack_mode": Variable(r"m", "1", "mode of the crack: 0 tension, 1 shear"),
    "crack_bond": Variable("b", "1", "index of the joint of the crack"),
}


FLAGS = {
    "status": "done failed",
    "crack_mode": "tension shear",
    "touching": "bending touching",
    "trial_purpose": "search slope",
    "fit_converged": "no yes",
    "bond_kind": "bonded gapped slit",
    "grooved": "regular grooved",
    "disc_fixed": "free fixed",
}
"""Meanings of 0, 1, ... for variables that are flags."""


def attributes(name: str) -> dict[str, Any]:
    """Attributes of a variable in netCDF files: units, long_name, symbol.

    Raises
    ------
    KeyError
        If the table does not hold the name.
    """
    row = VARIABLES[name]
    known = {"units": row.unit, "long_name": row.long_name, "symbol": row.symbol}
    if name in FLAGS:
        known |= {"flag_values": list(range(len(FLAGS[name].split()))), "flag_meanings": FLAGS[name]}
    return known


def label(name: str) -> str:
    """Axis label: meaning, symbol and display unit."""
    row = VARIABLES[name]
    symbol = f" ${row.symbol}$" if row.symbol else ""
    unit = row.display or row.unit
    return f"{row.long_name}{symbol}" + (f" [{unit}]" if unit != "1" else "")
