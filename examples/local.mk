# One .knit per idea; each is a test.
EXAMPLES = examples/bars.knit \
    examples/chains.knit \
    examples/columns.knit \
    examples/flag.knit \
    examples/miura.knit \
    examples/own_stitch.knit \
    examples/peaks.knit \
    examples/rib.knit \
    examples/seed.knit \
    examples/squiggles.knit \
    examples/stockinette.knit \
    examples/weave.knit
examplesdir = $(pkgdatadir)/examples
dist_examples_DATA = $(EXAMPLES)

# A sweep, and scripts that run it on many processors and machines.
SWEEP_EXAMPLES = examples/sweep/sweep.knit examples/sweep/parallel.sh examples/sweep/slurm.sh
sweep_examplesdir = $(examplesdir)/sweep
dist_sweep_examples_DATA = $(SWEEP_EXAMPLES)
