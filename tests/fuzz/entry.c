/* SPDX-License-Identifier: GPL-3.0-or-later
 * libFuzzer's entry; built once for each target, its name in FUZZ_TARGET. */
#include <stdint.h>

#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    target_run(FUZZ_TARGET, bytes, size);
    return 0;
}
