/* SPDX-License-Identifier: GPL-3.0-or-later
 * How the solver's threads wait for each other. */
#ifndef WEFT_WAITING_H
#define WEFT_WAITING_H

/* Lets threads sleep while they wait instead of spinning.  OpenMP's runtime
 * reads that from the environment before main, so the program starts itself
 * anew with OMP_WAIT_POLICY set, unless it is already; where that cannot be
 * done it goes on as it is.  On a machine others use too, a thread that spins
 * for one that has no processor costs a multiple of the whole run. */
void waiting_sleep(char **argv);

#endif
