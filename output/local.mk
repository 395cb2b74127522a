# What comes out: meshes, report, charts.
noinst_LIBRARIES += liboutput.a
liboutput_a_SOURCES = \
    output/axis.c output/axis.h \
    output/chart.c output/chart.h \
    output/field.c output/field.h \
    output/file.c output/file.h \
    output/glb.c output/glb.h \
    output/growth.c output/growth.h \
    output/json.c output/json.h \
    output/little.h \
    output/number.h \
    output/obj.c output/obj.h \
    output/page.c output/page.h \
    output/page_pack.c output/page_pack.h \
    output/plot.c output/plot.h \
    output/portrait.c output/portrait.h \
    output/ply.c output/ply.h \
    output/pvd.c output/pvd.h \
    output/render.c output/render.h \
    output/report.c output/report.h \
    output/stl.c output/stl.h \
    output/view.c output/view.h \
    output/vtp.c output/vtp.h
