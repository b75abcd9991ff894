"""Draw the datasets. Sources that only change pictures are parameters of these jobs alone."""


rule figure:
    input:
        dataset=lambda wildcards: dataset_of(wildcards.figure),
    output:
        png=report(f"{RESULTS}/figures/{{figure}}.png", caption="../report/figure.rst", category="Figures"),
        svg=f"{RESULTS}/figures/{{figure}}.svg",
    log:
        f"{RESULTS}/logs/figure/{{figure}}.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        sources=digest_pictures(),
        caption=lambda wildcards: caption(wildcards.figure),
    script:
        "../scripts/figure.py"


rule table:
    input:
        dataset=lambda wildcards: dataset_of(wildcards.figure),
    output:
        csv=report(f"{RESULTS}/tables/{{figure}}.csv", caption="../report/figure.rst", category="Tables"),
        md=f"{RESULTS}/tables/{{figure}}.md",
    log:
        f"{RESULTS}/logs/table/{{figure}}.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        sources=digest_pictures(),
        caption=lambda wildcards: caption(wildcards.figure),
    script:
        "../scripts/table.py"


rule run_times:
    input:
        missing_of(PLAN.cases),
    output:
        csv=report(f"{RESULTS}/tables/run_times.csv", caption="../report/run_times.rst", category="Tables"),
        md=f"{RESULTS}/tables/run_times.md",
    log:
        f"{RESULTS}/logs/run_times.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        members=members_of(PLAN.cases),
        sources=digest_pictures(),
        labels=PLAN.labels,
        store=STORE,
    script:
        "../scripts/run_times.py"
