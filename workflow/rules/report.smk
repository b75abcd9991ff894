"""One page with all figures, tables and animations, and where they come from."""

from orthocut.report.benchmarks import files


rule report:
    input:
        figures_of(PLAN.figures),
        rules.run_times.output.csv,
        benchmarks=[str(path) for path in files(Path(RESULTS))],
    output:
        page=f"{RESULTS}/report.html",
    log:
        f"{RESULTS}/logs/report.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        sources=digest_report(),
        study=str(OPTIONS.study_path(Path(workflow.basedir))),
        results=lambda wildcards, output: str(Path(output.page).parent),
        store=STORE,
    script:
        "../scripts/report.py"
