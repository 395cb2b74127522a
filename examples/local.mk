# One .knit per idea; each is a test.
EXAMPLES = examples/miura.knit
EXTRA_DIST += $(EXAMPLES)
