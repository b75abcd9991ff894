"""Animations, for figures that have one."""


rule animate:
    input:
        dataset=f"{RESULTS}/datasets/{{figure}}.nc",
    output:
        gif=f"{RESULTS}/animations/{{figure}}.gif",
    log:
        f"{RESULTS}/logs/animate/{{figure}}.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        sources=digest_pictures(),
    script:
        "../scripts/animate.py"


rule animations:
    input:
        expand(f"{RESULTS}/animations/{{figure}}.gif", figure=PLAN.animations),
