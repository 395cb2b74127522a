# Motifs in .knit, embedded in the binary.
