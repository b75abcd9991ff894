"""What people ask for by name: everything, a paper, a method, a figure."""

PAPERS = [figure for figure in PLAN.figures if figure.startswith(("nairn2015_", "yang2018_"))]
SPECIMENS = [
    case
    for case, made in PLAN.cases.items()
    if made.kind in ("dem_tension", "dem_compression", "dem_brazilian", "dem_toughness")
]
TARGETS = {
    "paper": PAPERS,
    "mpm": of_method("mpm"),
    "dem": of_method("dem"),
    "calibration": [figure for figure, cases in PLAN.figures.items() if set(cases) & set(SPECIMENS)],
    **{figure: [figure] for figure in PLAN.figures},
}
for figure in PAPERS:
    TARGETS.setdefault(figure.partition("_")[2], []).append(figure)


rule figures:
    input:
        [path for path in figures_of(PLAN.figures) if path.startswith(f"{RESULTS}/figures/")],


rule tables:
    input:
        [path for path in figures_of(PLAN.figures) if path.startswith(f"{RESULTS}/tables/")],
        expand(f"{RESULTS}/tables/run_times.{{form}}", form=("csv", "md")),


for target, drawn in TARGETS.items():

    rule:
        name:
            target
        input:
            figures_of(drawn),
