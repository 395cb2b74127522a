include tests/format/local.mk
include tests/golden/local.mk
include tests/solver/local.mk
include tests/output/local.mk
include tests/charts/local.mk
include tests/cli/local.mk
include tests/stress/local.mk
include tests/fuzz/local.mk
