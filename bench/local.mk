# What things cost.  `make bench` measures weft; the programs here are not built by `make`.
EXTRA_PROGRAMS += bench/triangle_kernel
bench_triangle_kernel_SOURCES = bench/triangle_kernel.c
bench_triangle_kernel_LDADD = libsolver.a $(LIBRARIES_OF_OTHERS)

EXTRA_PROGRAMS += bench/limits
bench_limits_SOURCES = bench/limits.c
bench_limits_LDADD = libsolver.a $(LIBRARIES_OF_OTHERS)

EXTRA_PROGRAMS += bench/write
bench_write_SOURCES = bench/write.c
bench_write_LDADD = $(weft_LDADD)

EXTRA_DIST += bench/run.sh bench/lib.sh bench/report.awk bench/limits.sh bench/skip.sh bench/estimate.sh bench/converge.sh bench/scenes/checks.knit \
    bench/scaling.sh bench/gradient.sh bench/accuracy.sh bench/plot.sh bench/summary.sh bench/warm.sh bench/write.sh \
    bench/scenes/bars.knit bench/scenes/basketweave.knit bench/scenes/chains.knit bench/scenes/checkerboard.knit \
    bench/scenes/columns.knit bench/scenes/flat.knit bench/scenes/garter.knit bench/scenes/miura.knit bench/scenes/miura_2x2.knit \
    bench/scenes/miura_4x4.knit bench/scenes/peaks.knit bench/scenes/rib2x2.knit bench/scenes/rib_small.knit bench/scenes/seed.knit \
    bench/scenes/squiggles.knit bench/scenes/stockinette.knit bench/scenes/weave.knit

EXTRA_DIST += docs/numerics.md docs/plots/accuracy.svg docs/plots/converge.svg docs/plots/estimate.svg docs/plots/gradient.svg docs/plots/scaling.svg
EXTRA_DIST += bench/plot.gp

# Some eighty minutes, half of them the baseline; the plots want gnuplot.  See bench/run.sh for parts of it.
bench: weft bench/limits$(EXEEXT) bench/write$(EXEEXT)
	srcdir='$(srcdir)' WEFT=./weft sh '$(srcdir)/bench/run.sh'
clean-local-bench:
	-rm -rf bench/results
clean-local: clean-local-bench
.PHONY: bench clean-local-bench
