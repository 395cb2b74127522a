# Patterns as knitters exchange them: charts and written rows, in and out.
noinst_LIBRARIES += libcharts.a
libcharts_a_SOURCES = \
    charts/beds.c charts/beds.h \
    charts/csv.c charts/csv.h \
    charts/dictionary.c charts/dictionary.h \
    charts/drawn.c charts/drawn.h \
    charts/drawn_body.c charts/drawn_body.h \
    charts/import.c charts/import.h \
    charts/knitout.c charts/knitout.h charts/knitout_write.c \
    charts/kp.c charts/kp.h \
    charts/legend.c charts/legend.h \
    charts/lines.c charts/lines.h \
    charts/pattern.h \
    charts/picture.c charts/picture.h \
    charts/raster.c charts/raster.h \
    charts/repeat.c charts/repeat.h \
    charts/row.c charts/row.h \
    charts/text.c charts/text.h \
    charts/words.c charts/words.h \
    charts/written.c charts/written.h
