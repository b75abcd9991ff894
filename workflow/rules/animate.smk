"""Animations, for figures that have one."""


rule animation:
    input:
        dataset=f"{RESULTS}/datasets/{{figure}}.nc",
    output:
        gif=f"{RESULTS}/animations/{{figure}}.gif",
    log:
        f"{RESULTS}/logs/animation/{{figure}}.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        sources=digest_pictures(),
    script:
        "../scripts/animation.py"


rule animations:
    input:
        expand(f"{RESULTS}/animations/{{figure}}.gif", figure=PLAN.animations),
