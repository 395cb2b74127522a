# Units of output, with cmocka.
if HAVE_CMOCKA
check_LIBRARIES += libsample.a
libsample_a_SOURCES = tests/output/sample.c tests/output/sample.h

check_PROGRAMS += tests/output/test_binary tests/output/test_file tests/output/test_mesh tests/output/test_page tests/output/test_plot tests/output/test_portrait tests/output/test_report

tests_output_test_binary_SOURCES = tests/output/test_binary.c
tests_output_test_binary_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_output_test_binary_LDADD = libsample.a liboutput.a libcharts.a libdrawing.a liblang.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

tests_output_test_file_SOURCES = tests/output/test_file.c
tests_output_test_file_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_output_test_file_LDADD = libsample.a liboutput.a libcharts.a libdrawing.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

tests_output_test_mesh_SOURCES = tests/output/test_mesh.c
tests_output_test_mesh_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_output_test_mesh_LDADD = libsample.a liboutput.a libcharts.a libdrawing.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

tests_output_test_page_SOURCES = tests/output/test_page.c
tests_output_test_page_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_output_test_page_LDADD = libsample.a liboutput.a libcharts.a libdrawing.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

tests_output_test_report_SOURCES = tests/output/test_report.c
tests_output_test_report_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_output_test_report_LDADD = libsample.a liboutput.a libcharts.a libdrawing.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

tests_output_test_plot_SOURCES = tests/output/test_plot.c
tests_output_test_plot_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_output_test_plot_LDADD = libsample.a liboutput.a libdrawing.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

tests_output_test_portrait_SOURCES = tests/output/test_portrait.c
tests_output_test_portrait_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_output_test_portrait_LDADD = libsample.a liboutput.a libcharts.a libdrawing.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)
endif

# Meshes read by others' readers, those of them that are there.
check_SCRIPTS += tests/output/readers.sh
EXTRA_DIST += tests/output/readers.sh tests/output/readers.py tests/output/gltf.cjs
