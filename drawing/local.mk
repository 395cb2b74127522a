# Paper and pen for whoever draws: the one place that talks to cairo.
noinst_LIBRARIES += libdrawing.a
libdrawing_a_SOURCES = \
    drawing/canvas.c drawing/canvas.h \
    drawing/colours.c drawing/colours.h \
    drawing/lettering.c drawing/lettering.h \
    drawing/packed.c drawing/packed.h
