# What comes out: meshes, report, charts.
noinst_LIBRARIES += liboutput.a
liboutput_a_SOURCES = solver/surface.h
