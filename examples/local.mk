# One .knit per idea; each is a test.
