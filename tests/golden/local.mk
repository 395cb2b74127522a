# Tests of the language: scripts and what they must say, to the letter.
noinst_PROGRAMS = tests/golden/knit_dump
tests_golden_knit_dump_LDADD = liblang.a $(LIBRARIES_OF_OTHERS)
