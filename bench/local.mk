# What things cost: `make bench/triangle_kernel` and so on; not built by `make`.
EXTRA_PROGRAMS += bench/triangle_kernel
bench_triangle_kernel_SOURCES = bench/triangle_kernel.c
bench_triangle_kernel_LDADD = libsolver.a $(LIBRARIES_OF_OTHERS)
